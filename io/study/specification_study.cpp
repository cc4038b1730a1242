#include "io/study/specification_study.h"

#include "io/scene/scene_reference.h"
#include "io/scene/specification_sections.h"

#include <iterator>

namespace abut {

namespace {

OnlyWith only_of(const std::vector<std::string>& types) {
    return {"type", quoted_all(types)};
}

std::vector<Key> general() {
    return {
        {.path = "", .kind = Kind::object, .meaning = "A family of runs of one scene, and what is measured."},
        {.path = "/$schema", .kind = Kind::text, .meaning = "For editors; ignored."},
        {.path = "/title", .kind = Kind::text, .otherwise = quoted(""), .meaning = "Title of reports."},
        {.path = "/base",
         .kind = Kind::any,
         .required = true,
         .meaning = "The scene that varies: a path, relative to this file, or a scene itself."},
        {.path = "/end",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = above(0),
         .meaning = "End of all runs; not given: the scene's."},
        {.path = "/set",
         .kind = Kind::map,
         .otherwise = "{}",
         .meaning = "Values of the scene in all variants: from JSON pointers to values."},
        {.path = "/set/*", .kind = Kind::any, .meaning = "A value, as in a scene; null removes the key."},
        {.path = "/parameters",
         .kind = Kind::map,
         .otherwise = "{}",
         .meaning =
             "Names for expressions: numbers, quantities (`\"10 MPa\"`), JSON pointers to numbers of a variant's "
             "scene (`\"/grid/cell\"`, in SI), or expressions in the parameters before."},
        {.path = "/parameters/*", .kind = Kind::any, .meaning = "A number or a text."},
        {.path = "/repeats",
         .kind = Kind::integer,
         .otherwise = "1",
         .range = from_to(1, 1000),
         .meaning =
             "How often each variant is run for its time. All variants are run once, then all again ..., so that "
             "noise hits them alike."},
        {.path = "/threads",
         .kind = Kind::integer,
         .otherwise = "1",
         .range = from_to(1, 1024),
         .meaning = "Threads of each run."},
        {.path = "/time_limit",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = above(0),
         .meaning = "Wall time after which a run is ended and counts as failed; not given: none."},
    };
}

std::vector<Key> variation() {
    return {
        {.path = "/axes",
         .kind = Kind::map,
         .required = true,
         .meaning = "What varies, by name. Reports show the axes in their order."},
        {.path = "/axes/*", .kind = Kind::object, .meaning = "One thing that varies, by its levels."},
        {.path = "/axes/*/pointer",
         .kind = Kind::name,
         .only_with = OnlyWith{"values", {}},
         .meaning = "JSON pointer to the value of the scene that varies."},
        {.path = "/axes/*/values",
         .kind = Kind::list,
         .range = at_least(1),
         .meaning = "Its values. A level is called like its value."},
        {.path = "/axes/*/values/#", .kind = Kind::any, .meaning = "A value, as in a scene."},
        {.path = "/axes/*/variants",
         .kind = Kind::map,
         .meaning = "Levels by name, each setting any number of values: from JSON pointers to values."},
        {.path = "/axes/*/variants/*", .kind = Kind::map, .meaning = "From JSON pointers to values."},
        {.path = "/axes/*/variants/*/*", .kind = Kind::any, .meaning = "A value; null removes the key."},
        {.path = "/axes/*/threads",
         .kind = Kind::list,
         .range = at_least(1),
         .meaning = "Numbers of threads of the runs."},
        {.path = "/axes/*/threads/#",
         .kind = Kind::integer,
         .range = from_to(1, 1024),
         .meaning = "A number of threads."},
        {.path = "/axes/*/size",
         .kind = Kind::name,
         .meaning =
             "JSON pointer to a number of the scene that stands for the level: what figures have across, and what "
             "errors converge with. Not given: `pointer`, if there are numbers."},
        {.path = "/axes/*/center",
         .kind = Kind::any,
         .meaning = "The level (its name or value) where other axes vary alone; not given: the first."},
        {.path = "/combine",
         .kind = Kind::any,
         .otherwise = quoted("product"),
         .meaning =
             "`\"product\"`: all levels with one another; `\"one-at-a-time\"`: all axes at their centers, and each "
             "axis alone along its levels; or a list of selections: from axes to a level, a list of levels or "
             "`\"*\"`, all of them. Axes that a selection doesn't name are at their centers."},
        {.path = "/except",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Selections that are left out. Axes that a selection doesn't name may have any level."},
        {.path = "/except/#", .kind = Kind::map, .meaning = "From axes to a level or a list of levels."},
        {.path = "/except/#/*", .kind = Kind::any, .meaning = "A level (its name or value), or a list of them."},
    };
}

std::vector<Key> metrics() {
    return {
        {.path = "/metrics",
         .kind = Kind::map,
         .required = true,
         .meaning = "What is measured, by name. A text alone is the `value` of a `history`."},
        {.path = "/metrics/*", .kind = Kind::object, .meaning = "One number of each run."},
        {.path = "/metrics/*/type",
         .kind = Kind::word,
         .words = texts(metric_words),
         .otherwise = quoted("history"),
         .meaning = "What kind of measure it is; README.md explains them."},
        {.path = "/metrics/*/value",
         .kind = Kind::any,
         .required = true,
         .only_with = only_of({"history", "particles"}),
         .meaning = "Expression, or a list of them: the components of a vector."},
        {.path = "/metrics/*/exact",
         .kind = Kind::any,
         .only_with = only_of({"history", "particles"}),
         .meaning = "What it should be: as many expressions. The metric is then the magnitude of the difference."},
        {.path = "/metrics/*/reference",
         .kind = Kind::map,
         .only_with = only_of({"history"}),
         .meaning = "Another variant to compare with: from axes to a level, or `\"finest\"`, the smallest size; other "
                    "axes are as in the variant itself."},
        {.path = "/metrics/*/reference/*", .kind = Kind::any, .meaning = "A level, or `\"finest\"`."},
        {.path = "/metrics/*/results",
         .kind = Kind::file,
         .only_with = only_of({"history"}),
         .meaning = "Result folder of any run to compare with."},
        {.path = "/metrics/*/reduce",
         .kind = Kind::word,
         .words = texts(reduction_words),
         .only_with =
             only_of({"history", "particles", "balance-error", "interpenetration", "momentum-error", "symmetry-error"}),
         .meaning = "Over all rows (frames, particles): `end`, the last; `max`, the largest magnitude; `rms`; `mean`. "
                    "Not given: `end` for `history`, `rms` for `particles`, else `max`."},
        {.path = "/metrics/*/frames",
         .kind = Kind::word,
         .words = texts(reduction_words),
         .otherwise = quoted("end"),
         .only_with = only_of({"particles"}),
         .meaning = "Over the frames of particles, after `reduce` over the particles of each."},
        {.path = "/metrics/*/at",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = at_least(0),
         .only_with = only_of({"history", "particles", "energy-loss", "symmetry-error", "interpenetration"}),
         .meaning = "Time at which it is measured, instead of the end: rows are interpolated, of frames the nearest "
                    "counts."},
        {.path = "/metrics/*/from",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = at_least(0),
         .only_with = only_of({"history"}),
         .meaning = "Rows before this time don't count."},
        {.path = "/metrics/*/to",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = above(0),
         .only_with = only_of({"history"}),
         .meaning = "Rows after this time don't count."},
        {.path = "/metrics/*/relative",
         .kind = Kind::boolean,
         .otherwise = "false",
         .only_with = only_of({"history", "particles", "convergence"}),
         .meaning = "Whether the difference is divided by what the value should be, reduced likewise."},
        {.path = "/metrics/*/scale",
         .kind = Kind::name,
         .only_with = only_of({"history", "particles", "momentum-error", "symmetry-error"}),
         .meaning = "Expression in parameters (and `first_` columns) that the metric is divided by."},
        {.path = "/metrics/*/bodies",
         .kind = Kind::list,
         .range = at_least(1),
         .only_with = only_of({"particles", "symmetry-error"}),
         .meaning = "Names of the bodies whose particles count; not given: all."},
        {.path = "/metrics/*/bodies/#", .kind = Kind::name, .meaning = "Name of a body."},
        {.path = "/metrics/*/weight",
         .kind = Kind::word,
         .words = texts(weight_words),
         .otherwise = quoted("none"),
         .only_with = only_of({"particles"}),
         .meaning = "How particles count in `rms` and `mean`."},
        {.path = "/metrics/*/of",
         .kind = Kind::name,
         .required = true,
         .only_with = only_of({"convergence"}),
         .meaning = "Name of the metric, one with a sign, that converges."},
        {.path = "/metrics/*/axis",
         .kind = Kind::name,
         .required = true,
         .only_with = only_of({"convergence"}),
         .meaning = "Name of the axis, one with sizes, along which it converges."},
        {.path = "/metrics/*/mirror",
         .kind = Kind::word,
         .words = texts(axis_words),
         .required = true,
         .only_with = only_of({"symmetry-error"}),
         .meaning = "Coordinate that changes its sign in the mirror image."},
        {.path = "/metrics/*/plane",
         .kind = Kind::quantity,
         .dimension = dimensions::length,
         .otherwise = "0",
         .only_with = only_of({"symmetry-error"}),
         .meaning = "Where the mirror is."},
        {.path = "/tolerances",
         .kind = Kind::map,
         .otherwise = "{}",
         .meaning = "Accuracy wanted, for verdicts: from metrics to the largest magnitude that is good enough."},
        {.path = "/tolerances/*", .kind = Kind::number, .range = above(0), .meaning = "Such a magnitude."},
    };
}

const std::vector<Key>& study_keys() {
    static const std::vector<Key> keys = [] {
        std::vector<Key> all;
        for (const auto& section : {general(), variation(), metrics()})
            all.insert(all.end(), section.begin(), section.end());
        return all;
    }();
    return keys;
}

const std::vector<Group>& study_groups() {
    static const std::vector<Group> groups{
        {"/axes/*", {"values", "variants", "threads"}, Count::exactly_one},
        {"/metrics/*", {"exact", "reference", "results"}, Count::at_most_one},
        {"/metrics/*", {"relative", "scale"}, Count::at_most_one},
    };
    return groups;
}

} // namespace

const SpecificationNode& study_specification() {
    static const SpecificationNode root = make_specification(study_keys(), study_groups());
    return root;
}

std::string study_reference() {
    return "# The study file: all keys\n\nMade by `abut reference --study`; see README.md for what they are for.\n\n" +
           key_tables(study_specification(), "The study");
}

} // namespace abut

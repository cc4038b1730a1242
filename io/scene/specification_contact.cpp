#include "io/scene/specification_sections.h"

#include "io/scene/words.h"

#include <iterator>

namespace abut {

namespace {} // namespace

std::vector<Key> contact_keys() {
    std::vector<Key> keys{
        {.path = "/contact",
         .kind = Kind::object,
         .meaning = "Contact between bodies; without it all bodies move in one velocity field, as if glued."},
        {.path = "/contact/normal",
         .kind = Kind::word,
         .words = texts(normal_words),
         .later_words = {"linear-regression", "maximum-gradient", "maximum-volume", "own-gradient", "specified"},
         .otherwise = quoted("logistic-regression"),
         .meaning = "How the contact normal is found."},
        {.path = "/contact/direction", .kind = Kind::later, .meaning = "Direction of a specified normal."},
        {.path = "/contact/separation",
         .kind = Kind::word,
         .words = texts(separation_words),
         .later_words = {"displacement"},
         .otherwise = quoted("particle-edges"),
         .meaning = "How the distance of two bodies is found; `none` looks at the approach velocity alone."},
        {.path = "/contact/offset",
         .kind = Kind::number,
         .otherwise = "0.8",
         .range = at_least(0),
         .only_with = OnlyWith{"separation", quoted_all({"critical-position"})},
         .meaning = "Distance of the particle positions, in cells, below which bodies are in contact."},
        {.path = "/contact/exponent",
         .kind = Kind::number,
         .otherwise = "0.58",
         .range = above(0),
         .only_with = OnlyWith{"separation", quoted_all({"fitted-position"})},
         .meaning = "Exponent of the fit from particle positions to edges."},
        {.path = "/contact/overlap_correction",
         .kind = Kind::number,
         .otherwise = "0.01",
         .range = from_to(0, 0.5),
         .meaning = "Share of an overlap of two bodies that a step removes, with separation `particle-edges` and "
                    "`explicit` pairs; 0: contact only stops bodies that approach, as published."},
        {.path = "/contact/screening",
         .kind = Kind::number,
         .otherwise = "0.001",
         .range = from_to(0, 0.1),
         .meaning =
             "Where a body has a smaller share of a pair's mass at a node and they touch, the pair is accelerated "
             "as one and keeps its sliding velocity (`explicit` pairs): so little mass would else be thrown along "
             "the interface."},
        {.path = "/contact/corrections",
         .kind = Kind::integer,
         .otherwise = "2",
         .range = from_to(1, 2),
         .meaning = "Contact corrections in a time step; 1 only to show why 2 are needed."},
        {.path = "/contact/three_or_more",
         .kind = Kind::word,
         .words = texts(three_or_more_words),
         .otherwise = quoted("explicit"),
         .meaning = "What happens at nodes that see three or more bodies: `lumped` takes each against all the others; "
                    "`explicit` solves all touching pairs at once, each with its own normal."},
        {.path = "/contact/rigid_bias",
         .kind = Kind::number,
         .otherwise = "0",
         .range = at_least(0),
         .meaning = "At a rigid body the normal is that of its own volume gradient where the gradient times this is at "
                    "least as large as the other body's; 0: `normal` holds there too."},
        {.path = "/contact/law",
         .kind = Kind::object,
         .otherwise = R"({"type": "frictionless"})",
         .meaning = "Law of every pair that is not named in `laws`."},
    };
    const auto append = [&keys](std::vector<Key> more) {
        keys.insert(keys.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    };
    append(law_keys("/contact/law"));
    append({
        {.path = "/contact/laws", .kind = Kind::list, .otherwise = "[]", .meaning = "Laws of single pairs of bodies."},
        {.path = "/contact/laws/#", .kind = Kind::object, .meaning = "The law of one pair."},
        {.path = "/contact/laws/#/bodies",
         .kind = Kind::list,
         .required = true,
         .range = from_to(2, 2),
         .meaning = "Names of the two bodies."},
        {.path = "/contact/laws/#/bodies/#", .kind = Kind::name, .meaning = "Name of a body."},
        {.path = "/contact/laws/#/law", .kind = Kind::object, .required = true, .meaning = "Their law."},
    });
    append(law_keys("/contact/laws/#/law"));
    return keys;
}

} // namespace abut

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
         .otherwise = quoted("logistic-regression"),
         .meaning = "How the contact normal is found. From the particles around a node: `logistic-regression`; "
                    "`linear-regression`, its first iterate; `irls-regression`, the same by maximum likelihood. From "
                    "volume gradients: `average-gradient` of both bodies, `maximum-gradient` or `maximum-volume`, that "
                    "of the body with more of it; `own-gradient`, each body its own, which does not conserve momentum. "
                    "`specified`: `direction` everywhere."},
        {.path = "/contact/direction",
         .kind = Kind::vector,
         .required = true,
         .only_with = OnlyWith{"normal", quoted_all({"specified"})},
         .meaning = "Direction of the normal, of any length but 0, from the body that the scene lists first to the "
                    "later one."},
        {.path = "/contact/separation",
         .kind = Kind::word,
         .words = texts(separation_words),
         .otherwise = quoted("particle-edges"),
         .meaning = "How the distance of two bodies is found: `particle-edges` from the particles around a node; "
                    "`critical-position` and `fitted-position` from extrapolated positions; `displacement` from "
                    "extrapolated displacements, for bodies that touch from the start and move little; `none` looks at "
                    "the approach velocity alone."},
        {.path = "/contact/offset",
         .kind = Kind::number,
         .otherwise = "0.8",
         .range = at_least(0),
         .only_with = OnlyWith{"separation", quoted_all({"critical-position"})},
         .meaning = "Distance of the particle positions, in cells, below which bodies are in contact: 0.8 for two "
                    "particles per cell along an axis, 1.07 for one."},
        {.path = "/contact/fit",
         .kind = Kind::word,
         .words = texts(fit_words),
         .otherwise = quoted("power-law"),
         .only_with = OnlyWith{"separation", quoted_all({"fitted-position"})},
         .meaning = "Fit from particle positions to edges, of shape `ugimp`: `power-law` and the piecewise "
                    "`two-per-cell` are for two particles per cell along an axis, `one-per-cell` for one."},
        {.path = "/contact/exponent",
         .kind = Kind::number,
         .otherwise = "0.58",
         .range = above(0),
         .only_with = OnlyWith{"separation", quoted_all({"fitted-position"})},
         .meaning = "Exponent of the fit `power-law`; the others have none."},
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
                    "`explicit` solves all touching pairs at once, each with its own normal; `up-to-two` does so "
                    "where one or two pairs touch, and lumps where more do."},
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
        {.path = "/contact/laws",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Laws of single pairs of bodies; of several that fit a pair the first holds."},
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

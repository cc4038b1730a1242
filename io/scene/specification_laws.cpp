#include "io/scene/specification_sections.h"

#include "io/scene/words.h"

namespace abut {

namespace {

/// A quantity that some of the laws have.
Key law_quantity(const std::string& path, const std::string& name, const Dimension& dimension,
                 const std::vector<std::string>& types, const std::string& meaning) {
    return {.path = path + "/" + name,
            .kind = Kind::quantity,
            .dimension = dimension,
            .range = at_least(0),
            .only_with = OnlyWith{"type", quoted_all(types)},
            .meaning = meaning};
}

Key required(Key key) {
    key.required = true;
    return key;
}

Key with_default(Key key, const std::string& value) {
    key.otherwise = value;
    return key;
}

Key positive(Key key) {
    key.range = above(0);
    return key;
}

std::vector<Key> friction_keys(const std::string& path) {
    return {
        {.path = path + "/coefficient",
         .kind = Kind::number,
         .required = true,
         .range = at_least(0),
         .only_with = OnlyWith{"type", quoted_all({"friction", "viscous-friction", "adhesion"})},
         .meaning = "Coefficient of friction µ while sliding; of `adhesion` under pressure, and when it has failed."},
        {.path = path + "/static_coefficient",
         .kind = Kind::number,
         .range = at_least(0),
         .only_with = OnlyWith{"type", quoted_all({"friction"})},
         .meaning = "Coefficient at rest; not given: as `coefficient`."},
        with_default(law_quantity(path, "decay_velocity", dimensions::velocity, {"friction"},
                                  "Sliding speed over which the static coefficient decays to the other one, "
                                  "exponentially; 0: at once."),
                     "0"),
        required(law_quantity(path, "viscosity", dimensions::film_viscosity, {"viscous-friction"},
                              "Shear traction by sliding speed of a film between the bodies, added to µ times the "
                              "pressure: the film's viscosity over its thickness.")),
        positive(law_quantity(path, "contact_stiffness", dimensions::stiffness, {"frictionless", "friction"},
                              "Softens the contact: bodies that overlap are pushed apart by this pressure per overlap, "
                              "as far as the time step can carry it, instead of being stopped.")),
    };
}

std::vector<Key> bond_keys(const std::string& path) {
    const std::vector<std::string> bonds{"adhesion", "cohesive-interface"};
    return {
        required(positive(law_quantity(path, "strength", dimensions::pressure, bonds,
                                       "Tensile traction at which `adhesion` fails; peak of a cohesive interface's."))),
        required(positive(law_quantity(path, "shear_strength", dimensions::pressure, bonds,
                                       "The same for the traction along the interface."))),
        {.path = path + "/reach",
         .kind = Kind::number,
         .otherwise = "0.1",
         .range = from_to(0, 1),
         .only_with = OnlyWith{"type", quoted_all({"adhesion", "viscous-friction"})},
         .meaning = "Separation within which a bond or a film holds, in cells."},
        required(positive(law_quantity(path, "opening", dimensions::length, {"cohesive-interface"},
                                       "Opening δ_p at the peak of the normal traction strength (δ/δ_p) "
                                       "exp(1 − δ/δ_p)."))),
        required(positive(law_quantity(path, "sliding", dimensions::length, {"cohesive-interface"},
                                       "Sliding displacement at the peak of the tangential traction."))),
    };
}

std::vector<Key> interface_keys(const std::string& path) {
    return {
        required(law_quantity(path, "normal_stiffness", dimensions::stiffness, {"linear-interface"},
                              "Normal traction by displacement across the interface, in tension and compression.")),
        required(law_quantity(path, "tension_stiffness", dimensions::stiffness, {"bilinear-interface"},
                              "Normal traction by opening; 0: debonded.")),
        law_quantity(path, "compression_stiffness", dimensions::stiffness, {"bilinear-interface", "cohesive-interface"},
                     "Pressure by displacement against each other; not given: the bodies don't penetrate."),
        required(law_quantity(path, "tangential_stiffness", dimensions::stiffness,
                              {"linear-interface", "bilinear-interface"}, "Shear traction by sliding displacement.")),
    };
}

} // namespace

std::vector<Key> law_keys(const std::string& path) {
    std::vector<Key> keys{
        {.path = path + "/type",
         .kind = Kind::word,
         .words = texts(law_words),
         .required = true,
         .meaning =
             "`frictionless` sliding, Coulomb `friction`, `viscous-friction`, `stick` without sliding while pressed "
             "together, `adhesion` up to a strength, `perfect` bonding; or springs between bodies that lie on each "
             "other at the start: `linear-interface`, `bilinear-interface`, and `cohesive-interface`, which softens."}};
    for (const auto& more : {friction_keys(path), bond_keys(path), interface_keys(path)})
        keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

} // namespace abut

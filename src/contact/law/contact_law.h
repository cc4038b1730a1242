#pragma once
#include "contact/law/adhesion.h"
#include "contact/law/cohesive_interface.h"
#include "contact/law/viscous_friction.h"
#include "scene/scene.h"

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace abut {

/// Bonded: both bodies move as one, whatever their separation.
struct Perfect {
    static constexpr bool needs_area = false;
};
template <int D>
Vec<D> law_impulse(const Perfect&, const Meeting<D>& at) {
    return at.stick;
}

/// The contact laws. To add one: a struct with slide() (slide.h), or with a law_impulse or an interface_step of its
/// own; a line here, in with_contact_law and in make_contact_law.
using ContactLaw = std::variant<Frictionless, Friction, Stick, Perfect, ViscousFriction, Adhesion,
                                Softened<Frictionless>, Softened<Friction>, LinearInterface, CohesiveInterface>;

/// Calls work(law) with the law itself; std::visit without its exception.
template <class Work>
decltype(auto) with_contact_law(const ContactLaw& law, Work&& work) {
    if (const auto* l = std::get_if<Friction>(&law)) return work(*l);
    if (const auto* l = std::get_if<Stick>(&law)) return work(*l);
    if (const auto* l = std::get_if<Perfect>(&law)) return work(*l);
    if (const auto* l = std::get_if<ViscousFriction>(&law)) return work(*l);
    if (const auto* l = std::get_if<Adhesion>(&law)) return work(*l);
    if (const auto* l = std::get_if<Softened<Frictionless>>(&law)) return work(*l);
    if (const auto* l = std::get_if<Softened<Friction>>(&law)) return work(*l);
    if (const auto* l = std::get_if<LinearInterface>(&law)) return work(*l);
    if (const auto* l = std::get_if<CohesiveInterface>(&law)) return work(*l);
    return work(*std::get_if<Frictionless>(&law));
}

inline ContactLaw make_contact_law(const LawSpec& spec) {
    constexpr double perfect = std::numeric_limits<double>::infinity();
    const Friction friction{spec.coefficient, spec.static_coefficient.value_or(spec.coefficient), spec.decay_velocity};
    switch (spec.type) {
    case LawType::friction:
        if (spec.contact_stiffness) return Softened<Friction>{friction, *spec.contact_stiffness};
        return friction;
    case LawType::stick:
        return Stick{};
    case LawType::perfect:
        return Perfect{};
    case LawType::viscous_friction:
        return ViscousFriction{spec.coefficient, spec.viscosity, spec.reach};
    case LawType::adhesion:
        return Adhesion{spec.strength, spec.shear_strength, spec.reach, friction};
    case LawType::linear_interface: // one normal stiffness
        return LinearInterface{spec.tension_stiffness, spec.tension_stiffness, spec.tangential_stiffness};
    case LawType::bilinear_interface:
        return LinearInterface{spec.tension_stiffness, spec.compression_stiffness.value_or(perfect),
                               spec.tangential_stiffness};
    case LawType::cohesive_interface:
        return CohesiveInterface{{spec.strength, spec.opening},
                                 {spec.shear_strength, spec.sliding},
                                 spec.compression_stiffness.value_or(perfect)};
    case LawType::frictionless:
        break;
    }
    if (spec.contact_stiffness) return Softened<Frictionless>{{}, *spec.contact_stiffness};
    return Frictionless{};
}

/// Springs between the bodies, with energy of their own.
inline bool is_interface(const LawSpec& law) {
    return law.type == LawType::linear_interface || law.type == LawType::bilinear_interface ||
           law.type == LawType::cohesive_interface;
}
inline bool is_interface(const ContactLaw& law) {
    return std::holds_alternative<LinearInterface>(law) || std::holds_alternative<CohesiveInterface>(law);
}
inline bool is_perfect(const ContactLaw& law) {
    return std::holds_alternative<Perfect>(law);
}
/// Whether bodies in contact are only stopped, and slide.
inline bool only_slides(const ContactLaw& law) {
    return std::holds_alternative<Frictionless>(law) || std::holds_alternative<Friction>(law) ||
           std::holds_alternative<ViscousFriction>(law);
}
inline bool needs_area(const LawSpec& spec) {
    return with_contact_law(make_contact_law(spec), [](const auto& law) { return law.needs_area; });
}

/// Δp' of body a by any law, and the energy that the interface holds then.
template <int D>
InterfaceStep<D> apply_law(const ContactLaw& law, const Meeting<D>& at) {
    return with_contact_law(law, [&](const auto& l) -> InterfaceStep<D> {
        if constexpr (requires { interface_step(l, at); })
            return interface_step(l, at);
        else
            return {law_impulse(l, at), 0};
    });
}

/// Which law holds between two bodies.
struct LawTable {
    struct Pair {
        std::int32_t a, b; ///< a < b
        ContactLaw law;
    };
    ContactLaw standard;
    std::vector<Pair> pairs; ///< sorted by (a, b)

    const ContactLaw& between(std::int32_t a, std::int32_t b) const {
        if (pairs.empty()) return standard;
        if (a > b) std::swap(a, b);
        const auto found = std::lower_bound(pairs.begin(), pairs.end(), std::pair(a, b),
                                            [](const Pair& p, auto key) { return std::pair(p.a, p.b) < key; });
        return found != pairs.end() && found->a == a && found->b == b ? found->law : standard;
    }
};

} // namespace abut

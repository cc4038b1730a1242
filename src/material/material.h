#pragma once
#include "material/linear_elastic.h"
#include "material/neo_hookean.h"

#include <variant>

namespace abut {

/// The constitutive laws. To add one: a struct with kirchhoff, energy, stiffness and (for plane stress)
/// stretch_without_stress, and a line here, in with_law and in make_material.
using Law = std::variant<NeoHookean, NeoHookeanIsochoric, LinearElastic>;

/// Calls work(law) with the law itself; like std::visit, but without its exception, which loops of threads must not
/// throw.
template <class Work>
decltype(auto) with_law(const Law& law, Work&& work) {
    if (const auto* l = std::get_if<NeoHookean>(&law)) return work(*l);
    if (const auto* l = std::get_if<NeoHookeanIsochoric>(&law)) return work(*l);
    return work(*std::get_if<LinearElastic>(&law));
}

/// A material ready for the kernels.
struct Material {
    Law law;
    double density; ///< of the undeformed solid [kg/m^3]
};

inline Material make_material(const MaterialSpec& spec) {
    switch (spec.model) {
    case MaterialModel::neo_hookean:
        return {NeoHookean{spec.bulk_modulus - 2.0 / 3 * spec.shear_modulus, spec.shear_modulus}, spec.density};
    case MaterialModel::linear_elastic:
        return {LinearElastic{spec.bulk_modulus - 2.0 / 3 * spec.shear_modulus, spec.shear_modulus}, spec.density};
    case MaterialModel::neo_hookean_isochoric:
        break;
    }
    return {NeoHookeanIsochoric{spec.bulk_modulus, spec.shear_modulus}, spec.density};
}

} // namespace abut

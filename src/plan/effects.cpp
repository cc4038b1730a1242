#include "plan/effects.h"

#include "contact/law/contact_law.h"
#include "shape/dispatch.h"

#include <algorithm>

namespace abut {

namespace {

/// Whether a law that is in use is as asked.
template <class Test>
bool any_law(const ContactSpec& contact, Test&& test) {
    return test(contact.law) || std::any_of(contact.laws.begin(), contact.laws.end(),
                                            [&](const PairLawSpec& pair) { return test(pair.law); });
}

bool any_prestress(const Scene& scene) {
    const auto has_stress = [](const auto& body) { return body.state.stress.has_value(); };
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), has_stress) ||
           std::any_of(scene.images.begin(), scene.images.end(), [&](const ImageSpec& image) {
               return std::any_of(image.legend.begin(), image.legend.end(), has_stress);
           });
}

bool any_rigid(const Scene& scene) {
    const auto is_rigid = [](const auto& body) { return body.rigid.has_value(); };
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), is_rigid) ||
           std::any_of(scene.images.begin(), scene.images.end(), [&](const ImageSpec& image) {
               return std::any_of(image.legend.begin(), image.legend.end(), is_rigid);
           });
}

bool is_regression(NormalMethod normal) {
    return normal == NormalMethod::logistic_regression || normal == NormalMethod::linear_regression ||
           normal == NormalMethod::irls_regression;
}

bool is_gradient(NormalMethod normal) {
    return !is_regression(normal) && normal != NormalMethod::specified;
}

} // namespace

Effects effects_of(const Scene& scene) {
    Effects effects;
    const TransferSpec& transfer = scene.method.transfer;
    const bool filters = transfer.scheme == TransferScheme::xpic || transfer.scheme == TransferScheme::fmpm;
    effects.extra_orders = filters ? transfer.order - 1 : 0;
    effects.fmpm = transfer.scheme == TransferScheme::fmpm && effects.extra_orders > 0;
    effects.pic = transfer.scheme != TransferScheme::flip && effects.extra_orders == 0;
    effects.rigid = any_rigid(scene);
    effects.prestress = any_prestress(scene);
    effects.periodic = transfer.every_cfl.has_value() && transfer.scheme != TransferScheme::flip;
    const StressUpdate update = scene.method.stress_update;
    effects.stress_last = update != StressUpdate::usf;
    effects.stress_first = update != StressUpdate::usl && update != StressUpdate::usl_plus;
    effects.reextrapolate = update == StressUpdate::usl_plus || update == StressUpdate::usavg_plus;
    effects.gravity = scene.gravity != Vector{};
    effects.ring = scene.analysis == Analysis::axisymmetric;
    effects.free_across = scene.analysis == Analysis::plane_stress;
    effects.velocity_conditions = effects.ring;
    for (const BoundarySpec& boundary : scene.boundaries)
        (std::holds_alternative<TractionSpec>(boundary.condition) ? effects.tractions : effects.velocity_conditions) =
            true;
    // Kept also where a last extrapolation must find the stencils of the step's beginning though particles have moved.
    effects.stored_stencils = effects.ring || effects.reextrapolate ||
                              with_shape(scene.method.shape, [](auto shape) { return decltype(shape)::stored; });
    if (scene.contact) {
        const ContactSpec& contact = *scene.contact;
        effects.contact = true;
        effects.delta_velocity = effects.extra_orders > 0 && contact.corrections == 2;
        // Perfect interfaces need neither normal nor separation.
        if (any_law(contact, [](const LawSpec& law) { return law.type != LawType::perfect; })) {
            effects.interfaces = any_law(contact, [](const LawSpec& law) { return is_interface(law); });
            effects.displacements |= effects.interfaces;
            effects.areas = any_law(contact, needs_area);
            effects.volumes |= effects.areas;
            effects.contact_strain = effects.fmpm;
            effects.planes = true;
            effects.pairs = scene.output.pairs;
            effects.regression = is_regression(contact.normal);
            effects.gradients = is_gradient(contact.normal) || (effects.rigid && contact.rigid_bias > 0);
            effects.volumes |= contact.normal == NormalMethod::maximum_volume;
            effects.displacements |= contact.separation == SeparationMethod::displacement;
            effects.clouds = effects.regression || contact.separation == SeparationMethod::particle_edges;
            effects.positions = contact.separation == SeparationMethod::critical_position ||
                                contact.separation == SeparationMethod::fitted_position;
        }
    }
    return effects;
}

} // namespace abut

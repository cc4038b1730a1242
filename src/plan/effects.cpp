#include "plan/effects.h"

#include "shape/dispatch.h"

#include <algorithm>

namespace abut {

namespace {

bool is_perfect(const LawSpec& law) {
    return law.type == LawType::perfect;
}

/// Perfect interfaces need neither normal nor separation.
bool all_perfect(const ContactSpec& contact) {
    return is_perfect(contact.law) && std::all_of(contact.laws.begin(), contact.laws.end(),
                                                  [](const PairLawSpec& pair) { return is_perfect(pair.law); });
}

} // namespace

Effects effects_of(const Scene& scene) {
    Effects effects;
    const TransferSpec& transfer = scene.method.transfer;
    effects.extra_orders = transfer.scheme == TransferScheme::xpic ? transfer.order - 1 : 0;
    effects.stress_first = scene.method.stress_update == StressUpdate::usf;
    effects.stored_stencils = with_shape(scene.method.shape, [](auto shape) { return decltype(shape)::stored; });
    effects.gravity = scene.gravity != Vector{};
    if (scene.contact) {
        const ContactSpec& contact = *scene.contact;
        effects.contact = true;
        effects.delta_velocity = effects.extra_orders > 0 && contact.corrections == 2;
        if (!all_perfect(contact)) {
            effects.regression = contact.normal == NormalMethod::logistic_regression;
            effects.gradients = contact.normal == NormalMethod::average_gradient;
            effects.clouds = effects.regression || contact.separation == SeparationMethod::particle_edges;
            effects.positions = contact.separation == SeparationMethod::critical_position ||
                                contact.separation == SeparationMethod::fitted_position;
        }
    }
    return effects;
}

} // namespace abut

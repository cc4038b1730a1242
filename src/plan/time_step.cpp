#include "plan/time_step.h"

#include "grid/effective_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abut {

namespace {

struct Limit {
    double factor; ///< times 1 / √k
    double least;  ///< whatever k
};

Limit fmpm_limit(ShapeKind shape) {
    switch (shape) {
    case ShapeKind::cpdi:
        return {0.7, 0.25};
    case ShapeKind::b2cpdi:
        return {1.2, 0.3};
    case ShapeKind::b2gimp:
        return {1.0, 0};
    case ShapeKind::b2spline:
        return {0.8, 0};
    case ShapeKind::linear:
    case ShapeKind::ugimp:
    case ShapeKind::gimp:
        break;
    }
    return {0.7, 0};
}

} // namespace

double cfl_limit(const Scene& scene) {
    const TransferSpec& transfer = scene.method.transfer;
    if (transfer.scheme != TransferScheme::fmpm || transfer.order < 2) return 1;
    const Limit limit = fmpm_limit(scene.method.shape);
    return std::min(1.0, std::max(limit.least, limit.factor / std::sqrt(transfer.order)));
}

double largest_stiffness(const LawSpec& law) {
    const double stiffest = std::max({law.tension_stiffness, law.compression_stiffness.value_or(0),
                                      law.tangential_stiffness, law.contact_stiffness.value_or(0)});
    if (law.type != LawType::cohesive_interface) return stiffest;
    return std::max(
        {stiffest, std::exp(1) * law.strength / law.opening, std::exp(1) * law.shear_strength / law.sliding});
}

double interface_step_limit(const Scene& scene, double stiffness) {
    double density = std::numeric_limits<double>::infinity();
    for (const MaterialSpec& material : scene.materials) density = std::min(density, material.density);
    const Vector cell = effective_cell(scene.grid);
    const double length = *std::min_element(cell.begin(), cell.begin() + dimension(scene.analysis));
    return 0.5 * std::numbers::pi * std::sqrt(density * length / (4 * stiffness));
}

double initial_step(const Scene& scene) {
    if (scene.time.step) return *scene.time.step;
    double speed = 0;
    for (const MaterialSpec& m : scene.materials)
        speed = std::max(speed, std::sqrt((m.bulk_modulus + 4.0 / 3 * m.shear_modulus) / m.density));
    const Vector cell = effective_cell(scene.grid);
    const double length = *std::min_element(cell.begin(), cell.begin() + dimension(scene.analysis));
    return std::min(scene.time.cfl, cfl_limit(scene)) * length / speed;
}

} // namespace abut

#include "plan/time_step.h"

#include <algorithm>
#include <cmath>

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

} // namespace abut

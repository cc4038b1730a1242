#include "io/render/domains.h"

#include "io/render/values.h"

#include <algorithm>
#include <cmath>

namespace abut {

const double* reals_of(const PointFrame& frame, const char* name, int components) {
    const Array* array = find_array(frame, name);
    const auto* values = array && array->components == components ? std::get_if<0>(&array->values) : nullptr;
    return values ? values->data() : nullptr;
}

std::optional<Domains> Domains::of(const PointFrame& frame) {
    Domains domains;
    domains.half_size_ = reals_of(frame, "half_size", 3);
    if (!domains.half_size_ && !frame.points.empty()) return {};
    domains.points_ = frame.points.data();
    domains.gradient_ = reals_of(frame, "deformation_gradient", 9);
    domains.size_ = frame.points.size() / 3;
    return domains;
}

std::array<Vector3, 3> Domains::half_edges(std::size_t particle) const {
    constexpr std::array<double, 9> identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double* F = gradient_ ? gradient_ + 9 * particle : identity.data();
    const double* r = half_size(particle);
    std::array<Vector3, 3> edges{};
    for (std::size_t k = 0; k < 3; ++k) edges[k] = {F[k] * r[k], F[3 + k] * r[k], F[6 + k] * r[k]};
    return edges;
}

bool Domains::in_space() const {
    for (std::size_t p = 0; p < size_; ++p)
        if (half_size(p)[2] > 0) return true;
    return false;
}

void Domains::extend(Bounds& bounds) const {
    for (std::size_t p = 0; p < size_; ++p) {
        const auto edges = half_edges(p);
        for (std::size_t k = 0; k < 3; ++k) {
            const double reach = std::abs(edges[0][k]) + std::abs(edges[1][k]) + std::abs(edges[2][k]);
            bounds.lower[k] = std::min(bounds.lower[k], centre(p)[k] - reach);
            bounds.upper[k] = std::max(bounds.upper[k], centre(p)[k] + reach);
        }
    }
}

} // namespace abut

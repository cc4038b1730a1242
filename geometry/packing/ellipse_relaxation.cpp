#include "geometry/packing/ellipse_relaxation.h"

#include "geometry/packing/ellipse_contact.h"
#include "geometry/packing/growth.h"
#include "geometry/packing/near_pairs.h"
#include "geometry/packing/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut {

namespace {

/// Sines and cosines differ in their last digits between machines; so all that comes of them is rounded far above that.
double on_fixed_grid(double value) {
    return std::round(value * 0x1p20) * 0x1p-20;
}

class Ellipses {
public:
    explicit Ellipses(const PackingRequest& request) : request_(request) {
        Random random(request.seed);
        double sum = 0;
        for (const double size : sample_sizes(request.sizes, request.bodies, random)) {
            const double aspect = std::sqrt(random.between(request.min_aspect, request.max_aspect));
            const double angle = on_fixed_grid(random.between(0, std::numbers::pi));
            const Vector centre{on_fixed_grid(random.between(0, request.width)),
                                on_fixed_grid(random.between(0, request.height)), 0};
            shapes_.push_back({size * aspect, size / aspect});
            ellipses_.push_back({centre, {}, angle});
            sum += std::numbers::pi * size * size;
        }
        outlines_.resize(ellipses_.size());
        unit_ = std::sqrt(request.width * request.height / sum);
    }

    void set_fraction(double fraction) {
        mean_ = 0;
        for (std::size_t k = 0; k < ellipses_.size(); ++k) {
            for (int axis = 0; axis < 2; ++axis)
                ellipses_[k].semi_axes[axis] = unit_ * std::sqrt(fraction) * shapes_[k][axis];
            mean_ += ellipses_[k].semi_axes[1] / static_cast<double>(ellipses_.size());
            place(k);
        }
        find_pairs();
    }

    bool fits() const {
        return std::all_of(ellipses_.begin(), ellipses_.end(), [&](const Ellipse& each) {
            return 2 * each.semi_axes[0] <= std::min(request_.width, request_.height);
        });
    }

    void relax_once() {
        constexpr double further = 1.001; // the push would else only come nearer to enough
        for (const auto& [a, b] : pairs_) {
            const double x = outlines_[b].x - outlines_[a].x, y = outlines_[b].y - outlines_[a].y;
            const double far = further * (outlines_[a].reach + outlines_[b].reach);
            if (x * x + y * y > far * far) continue;
            const Closeness close = closeness(outlines_[a], outlines_[b], further * further);
            if (close.value < further * further) push(a, b, close, further);
        }
        double moved = 0;
        for (std::size_t k = 0; k < ellipses_.size(); ++k)
            moved = std::max(
                moved, std::hypot(ellipses_[k].center[0] - found_at_[k][0], ellipses_[k].center[1] - found_at_[k][1]));
        if (2 * moved > margin()) find_pairs();
    }

    bool apart() const {
        return std::all_of(pairs_.begin(), pairs_.end(), [&](const std::array<int, 2>& pair) {
            const Outline &a = outlines_[pair[0]], &b = outlines_[pair[1]];
            const double x = b.x - a.x, y = b.y - a.y, far = a.reach + b.reach;
            return x * x + y * y > far * far || contact_function(a, b, 1) >= 1;
        });
    }

    const std::vector<Ellipse>& result() const { return ellipses_; }

private:
    double margin() const { return mean_; }

    void find_pairs() {
        std::vector<PointD<2>> centres;
        std::vector<double> reach;
        for (const Outline& each : outlines_) {
            centres.push_back({each.x, each.y});
            reach.push_back(1.001 * each.reach);
        }
        pairs_ = near_pairs<2>(centres, reach, {request_.width, request_.height}, margin());
        found_at_ = centres;
    }

    /// Brings an ellipse inside the box, and its outline to its place.
    void place(std::size_t k) {
        Ellipse& ellipse = ellipses_[k];
        ellipse.angle = on_fixed_grid(ellipse.angle);
        const std::array<double, 2> extent = half_extent(ellipse), box{request_.width, request_.height};
        for (int axis = 0; axis < 2; ++axis) {
            // Inwards by at least one step of the grid.
            const double lower = std::ceil(extent[axis] * 0x1p20 + 1) * 0x1p-20;
            ellipse.center[axis] = std::max(lower, std::min(on_fixed_grid(ellipse.center[axis]), box[axis] - lower));
        }
        outlines_[k] = outline_with_gap(ellipse, request_.gap);
    }

    /// Moves and turns both along the gradient of the factor h = √F by which they can grow until they touch, so far
    /// that h becomes `wanted` (to first order). At fixed λ, F = λ μ rᵀ C⁻¹ r with C = μ A + λ B, μ = 1 − λ, so with z
    /// = C⁻¹ r: ∂F/∂r = 2 λ μ z and ∂F/∂A = −λ μ² z zᵀ.
    void push(int first, int second, const Closeness& close, double wanted) {
        const Outline &a = outlines_[first], &b = outlines_[second];
        const double lambda = close.lambda, mu = 1 - lambda, x = b.x - a.x, y = b.y - a.y;
        const double xx = mu * a.xx + lambda * b.xx, xy = mu * a.xy + lambda * b.xy, yy = mu * a.yy + lambda * b.yy;
        const double determinant = xx * yy - xy * xy;
        const double u = (yy * x - xy * y) / determinant, v = (xx * y - xy * x) / determinant;
        const auto turned = [&](const Outline& m) { // zᵀ (dM/dθ) z
            return 2 * (m.xy * (v * v - u * u) + (m.xx - m.yy) * u * v);
        };
        const double h = std::sqrt(close.value);
        Ellipse &one = ellipses_[first], &other = ellipses_[second];
        if (h < 1e-3) { // on the same place: there is no direction
            one.center[0] -= 0.5 * one.semi_axes[1];
            other.center[0] += 0.5 * other.semi_axes[1];
        } else {
            const double to_h = 1 / (2 * h);
            const double gx = to_h * 2 * lambda * mu * u, gy = to_h * 2 * lambda * mu * v;
            const double turn_one = -to_h * lambda * mu * mu * turned(a);
            const double turn_other = -to_h * lambda * lambda * mu * turned(b);
            const auto ease = [](const Ellipse& e) { // squared radius of gyration
                return 4 / (e.semi_axes[0] * e.semi_axes[0] + e.semi_axes[1] * e.semi_axes[1]);
            };
            const double step = (wanted - h) / (2 * (gx * gx + gy * gy) + ease(one) * turn_one * turn_one +
                                                ease(other) * turn_other * turn_other);
            one.center[0] -= step * gx;
            one.center[1] -= step * gy;
            other.center[0] += step * gx;
            other.center[1] += step * gy;
            one.angle += std::clamp(step * ease(one) * turn_one, -0.2, 0.2);
            other.angle += std::clamp(step * ease(other) * turn_other, -0.2, 0.2);
        }
        place(first);
        place(second);
    }

    const PackingRequest& request_;
    std::vector<std::array<double, 2>> shapes_; ///< semi-axes at scale 1
    std::vector<Ellipse> ellipses_;
    std::vector<Outline> outlines_; ///< enlarged for the gap
    std::vector<PointD<2>> found_at_;
    std::vector<std::array<int, 2>> pairs_;
    double unit_ = 1, mean_ = 0;
};

} // namespace

std::vector<Ellipse> relax_ellipses(const PackingRequest& request) {
    Ellipses ellipses(request);
    grow_to(ellipses, request.area_fraction, "ellipses", static_cast<std::size_t>(request.bodies));
    return ellipses.result();
}

} // namespace abut

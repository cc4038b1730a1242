#include "geometry/packing/ellipse_packing.h"

#include "geometry/packing/ellipse_contact.h"
#include "geometry/packing/ellipse_relaxation.h"
#include "geometry/packing/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace abut {

namespace {

/// Rounds to a binary grid far coarser than round-off. Processors that fuse multiply and add differ in last digits, and
/// a Monte Carlo run would blow that up to another packing; rounded after every step, all of them take the same path.
double on_fixed_grid(double value) {
    return std::round(value * 0x1p20) * 0x1p-20;
}

/// Grows all at once, as far as the nearest two allow.
class Packing {
public:
    explicit Packing(const PackingRequest& request) : request_(request), random_(request.seed) {}

    std::vector<Ellipse> run() {
        choose_shapes();
        constexpr double dilute = 0.15; // area fraction at which random placing always works
        place(std::min(dilute, request_.area_fraction));
        constexpr int most_sweeps = 20000;
        for (int sweep = 0; sweep < most_sweeps; ++sweep) {
            if (scale_ >= final_scale_) return scaled(final_scale_);
            jiggle();
            grow();
        }
        const double reached = request_.area_fraction * std::pow(scale_ / final_scale_, 2);
        throw std::runtime_error(fmt::format(
            "{} ellipses fill {:.3f} of the picture at most, not {:.3f}; ask for less, or for a smaller gap",
            request_.bodies, reached, request_.area_fraction));
    }

private:
    /// Semi-axes at scale 1, with unlike sizes and aspects; the scale at which they fill the wanted area.
    void choose_shapes() {
        double area = 0;
        for (int k = 0; k < request_.bodies; ++k) {
            const double aspect = std::sqrt(random_.between(request_.min_aspect, request_.max_aspect));
            const double size = request_.sizes.sample(random_);
            Ellipse ellipse{{}, {size * aspect, size / aspect}, on_fixed_grid(random_.between(0, std::numbers::pi))};
            area += std::numbers::pi * size * size;
            ellipses_.push_back(ellipse);
        }
        // The largest first: they are the hardest to place.
        std::stable_sort(ellipses_.begin(), ellipses_.end(), [](const Ellipse& a, const Ellipse& b) {
            return a.semi_axes[0] * a.semi_axes[1] > b.semi_axes[0] * b.semi_axes[1];
        });
        final_scale_ = std::sqrt(request_.area_fraction * request_.width * request_.height / area);
    }

    void place(double area_fraction) {
        scale_ = final_scale_ * std::sqrt(area_fraction / request_.area_fraction);
        constexpr int tries = 2000, restarts = 200;
        outlines_.resize(ellipses_.size());
        for (int restart = 0; restart < restarts; ++restart, scale_ *= 0.9) {
            std::size_t placed = 0;
            for (int attempt = 0; placed < ellipses_.size() && attempt < tries; ++attempt) {
                Ellipse& ellipse = ellipses_[placed];
                ellipse.center = {on_fixed_grid(random_.between(0, request_.width)),
                                  on_fixed_grid(random_.between(0, request_.height)), 0};
                if (!is_free(ellipse, placed, placed)) continue;
                outlines_[placed++] = outline_with_gap(ellipse);
                attempt = -1;
            }
            if (placed == ellipses_.size()) return;
        }
        throw std::runtime_error(fmt::format("no room for {} ellipses with this gap", request_.bodies));
    }

    /// One random move of every ellipse; moves get shorter when most are refused.
    void jiggle() {
        std::size_t accepted = 0;
        for (std::size_t k = 0; k < ellipses_.size(); ++k) {
            const double reach = move_ * scale_ * ellipses_[k].semi_axes[1];
            Ellipse moved = ellipses_[k];
            moved.center[0] = on_fixed_grid(moved.center[0] + random_.between(-reach, reach));
            moved.center[1] = on_fixed_grid(moved.center[1] + random_.between(-reach, reach));
            moved.angle = on_fixed_grid(moved.angle + random_.between(-move_, move_));
            if (!is_free(moved, k, ellipses_.size())) continue;
            ellipses_[k] = moved;
            outlines_[k] = outline_with_gap(moved);
            ++accepted;
        }
        const bool often = 2 * accepted > ellipses_.size();
        move_ = std::clamp(often ? move_ * 1.05 : move_ * 0.95, 1e-3, 1.0);
    }

    /// Scales all ellipses up, half the way to the first contact.
    void grow() {
        double growth = final_scale_ / scale_;
        for (std::size_t k = 0; k < ellipses_.size(); ++k) {
            const std::array<double, 2> extent = half_extent(at_scale(ellipses_[k]));
            const Vector& centre = ellipses_[k].center;
            growth = std::min({growth, centre[0] / extent[0], (request_.width - centre[0]) / extent[0],
                               centre[1] / extent[1], (request_.height - centre[1]) / extent[1]});
            for (std::size_t other = 0; other < k; ++other)
                growth = std::min(growth, growth_until_contact(outlines_[k], outlines_[other], growth));
        }
        if (growth >= final_scale_ / scale_)
            scale_ = final_scale_;
        else if (growth > 1)
            scale_ = std::max(scale_, std::floor(scale_ * (1 + 0.5 * (growth - 1)) * 0x1p20) * 0x1p-20);
        for (std::size_t k = 0; k < ellipses_.size(); ++k) outlines_[k] = outline_with_gap(ellipses_[k]);
    }

    /// Whether an ellipse lies inside the box and apart from the first `count` others; itself is number `self`.
    bool is_free(const Ellipse& unscaled, std::size_t self, std::size_t count) const {
        const Ellipse ellipse = at_scale(unscaled);
        const std::array<double, 2> extent = half_extent(ellipse);
        if (ellipse.center[0] < extent[0] || ellipse.center[0] > request_.width - extent[0] ||
            ellipse.center[1] < extent[1] || ellipse.center[1] > request_.height - extent[1])
            return false;
        const Outline own = outline_with_gap(unscaled);
        for (std::size_t other = 0; other < count; ++other)
            if (other != self && growth_until_contact(own, outlines_[other], 1) < 1) return false;
        return true;
    }

    /// Factor by which both can grow, or `enough` or more if they certainly can grow that much.
    static double growth_until_contact(const Outline& a, const Outline& b, double enough) {
        const double x = b.x - a.x, y = b.y - a.y;
        const double far = enough * (a.reach + b.reach);
        if (x * x + y * y > far * far) return enough;
        return std::sqrt(contact_function(a, b, enough * enough));
    }

    Ellipse at_scale(Ellipse ellipse) const {
        for (double& axis : ellipse.semi_axes) axis *= scale_;
        return ellipse;
    }

    Outline outline_with_gap(const Ellipse& unscaled) const {
        return abut::outline_with_gap(at_scale(unscaled), request_.gap);
    }

    std::vector<Ellipse> scaled(double scale) const {
        std::vector<Ellipse> result = ellipses_;
        for (Ellipse& ellipse : result)
            for (double& axis : ellipse.semi_axes) axis *= scale;
        return result;
    }

    const PackingRequest& request_;
    Random random_;
    std::vector<Ellipse> ellipses_; ///< semi-axes at scale 1
    std::vector<Outline> outlines_; ///< of the ellipses at the present scale, enlarged for the gap
    double scale_ = 1, final_scale_ = 1;
    double move_ = 0.5; ///< of the shorter semi-axis; also the turn [rad]
};

} // namespace

std::vector<Ellipse> pack_ellipses(const PackingRequest& request) {
    // The more there are, the nearer are the nearest two, and the slower all would grow.
    constexpr int most_at_once = 60;
    if (request.bodies > most_at_once) return relax_ellipses(request);
    return Packing(request).run();
}

} // namespace abut

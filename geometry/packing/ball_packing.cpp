#include "geometry/packing/ball_packing.h"

#include "geometry/packing/growth.h"
#include "geometry/packing/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut {

namespace {

/// Balls that push each other apart.
template <int D>
class Balls {
public:
    explicit Balls(const BallRequest<D>& request) : request_(request), radii_(request.sizes) {
        Random random(request.seed);
        for (std::size_t k = 0; k < radii_.size(); ++k) {
            PointD<D> centre{};
            for (int axis = 0; axis < D; ++axis) centre[axis] = random.between(0, request.box[axis]);
            centres_.push_back(centre);
        }
        double volume = 1, sum = 0;
        for (const double length : request.box) volume *= length;
        for (const double size : request.sizes) sum += D == 2 ? size * size : size * size * size;
        sum *= D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
        unit_ = D == 2 ? std::sqrt(volume / sum) : std::cbrt(volume / sum);
    }

    /// Radii at which they fill the share.
    void set_fraction(double fraction) {
        const double scale = unit_ * (D == 2 ? std::sqrt(fraction) : std::cbrt(fraction));
        // Rounded: cbrt() differs in its last digit between machines.
        for (std::size_t k = 0; k < radii_.size(); ++k)
            radii_[k] = scale * request_.sizes[k] > 1e-3 ? std::floor(scale * request_.sizes[k] * 0x1p40) * 0x1p-40
                                                         : scale * request_.sizes[k];
        mean_ = 0;
        for (const double radius : radii_) mean_ += radius / static_cast<double>(radii_.size());
        find_pairs();
    }

    bool fits() const {
        const double largest = *std::max_element(radii_.begin(), radii_.end());
        return 2 * largest <= *std::min_element(request_.box.begin(), request_.box.end());
    }

    /// Moves them apart, pair by pair, a little further than needed: the push would else only come nearer to enough.
    void relax_once() {
        constexpr double further = 1e-3;
        for (std::size_t k = 0; k < centres_.size(); ++k) hold_inside(k);
        for (const auto& [a, b] : pairs_) {
            const double apart = (radii_[a] + radii_[b]) * (1 + further) + request_.gap;
            const double square = square_distance(a, b);
            if (square >= apart * apart) continue;
            const double distance = std::sqrt(square);
            PointD<D> push{};
            if (distance > 0)
                for (int axis = 0; axis < D; ++axis)
                    push[axis] = 0.5 * (apart - distance) / distance * (centres_[b][axis] - centres_[a][axis]);
            else
                push[0] = 0.5 * apart;
            for (int axis = 0; axis < D; ++axis) {
                centres_[a][axis] -= push[axis];
                centres_[b][axis] += push[axis];
            }
            hold_inside(a);
            hold_inside(b);
        }
        double moved = 0;
        for (std::size_t k = 0; k < centres_.size(); ++k) {
            double square = 0;
            for (int axis = 0; axis < D; ++axis) square += std::pow(centres_[k][axis] - found_at_[k][axis], 2);
            moved = std::max(moved, square);
        }
        if (4 * moved > margin() * margin()) find_pairs();
    }

    bool apart() const {
        return std::all_of(pairs_.begin(), pairs_.end(), [&](const std::array<int, 2>& pair) {
            const double least = radii_[pair[0]] + radii_[pair[1]] + request_.gap;
            return square_distance(pair[0], pair[1]) >= least * least;
        });
    }

    PackedBalls<D> result() const { return {centres_, radii_}; }

private:
    double margin() const { return 0.5 * mean_; }

    void find_pairs() {
        for (std::size_t k = 0; k < centres_.size(); ++k) hold_inside(k);
        pairs_ = near_pairs<D>(centres_, radii_, request_.box, request_.gap + 2e-3 * mean_ + margin());
        found_at_ = centres_;
    }

    double square_distance(int a, int b) const {
        double square = 0;
        for (int axis = 0; axis < D; ++axis)
            square += (centres_[a][axis] - centres_[b][axis]) * (centres_[a][axis] - centres_[b][axis]);
        return square;
    }

    void hold_inside(std::size_t k) {
        for (int axis = 0; axis < D; ++axis)
            centres_[k][axis] = std::max(radii_[k], std::min(centres_[k][axis], request_.box[axis] - radii_[k]));
    }

    const BallRequest<D>& request_;
    std::vector<PointD<D>> centres_, found_at_; ///< found_at_: when the pairs were found
    std::vector<double> radii_;
    std::vector<std::array<int, 2>> pairs_;
    double unit_ = 1; ///< radius of a ball of size 1 when they fill the box
    double mean_ = 0;
};

} // namespace

template <int D>
PackedBalls<D> pack_balls(const BallRequest<D>& request) {
    Balls<D> balls(request);
    grow_to(balls, request.fraction, D == 2 ? "disks" : "balls", request.sizes.size());
    return balls.result();
}

template <int D>
std::size_t count_contacts(const PackedBalls<D>& balls, const PointD<D>& box, double distance) {
    return near_pairs<D>(balls.centres, balls.radii, box, distance).size();
}

template PackedBalls<2> pack_balls<2>(const BallRequest<2>&);
template PackedBalls<3> pack_balls<3>(const BallRequest<3>&);
template std::size_t count_contacts<2>(const PackedBalls<2>&, const PointD<2>&, double);
template std::size_t count_contacts<3>(const PackedBalls<3>&, const PointD<3>&, double);

} // namespace abut

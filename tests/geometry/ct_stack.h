#pragma once
/// A stack of slices like those of a µCT scanner, of grains that touch, with the truth beside it: ellipsoids packed at
/// random, drawn in two greys, blurred and made noisy.
///
/// Recipe: ellipsoids with volumes and aspects drawn at random and turned at random are put anywhere in the box; then
/// overlaps are relaxed: each pair that overlaps is moved apart along its contact normal, each ellipsoid back into the
/// box, over and over. What is left of overlaps is far less than a voxel; pairs that nearly touch are many, and the
/// blur closes the gaps between them.

#include "geometry/images/image.h"
#include "geometry/packing/random.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace test {

struct CtRecipe {
    int size = 200; ///< of the cube [voxels]
    int grains = 500;
    double solid_fraction = 0.5; ///< of the ellipsoids, by volume
    double largest_aspect = 1.5; ///< of the longest to the shortest semi-axis
    double size_spread = 0.2;    ///< radii vary by this share to either side
    int void_grey = 70, grain_grey = 180;
    double blur = 1;   ///< standard deviation of the Gauss filter [voxels]
    double noise = 15; ///< standard deviation [greys]
    int relaxations = 300;
    std::uint64_t seed = 1;
};

struct CtGrain {
    Eigen::Vector3d center;
    Eigen::Matrix3d shape; ///< S with (x − c)ᵀ S⁻¹ (x − c) ≤ 1 inside
    double volume = 0;
};

struct CtStack {
    std::vector<CtGrain> grains;
    std::vector<std::int32_t> truth; ///< grain of each voxel from 1, 0: void; x fastest, then y (upwards), then z
    std::vector<abut::Image> slices; ///< rows from the top, as in files
    double largest_overlap = 0;      ///< [voxels]
    int contacts = 0;                ///< pairs with a gap of less than half a voxel
};

/// Perram and Wertheim's contact function: the factor by which both ellipsoids would have to grow in volume^(2/3) to
/// touch; with the gap between them along the normal, negative where they overlap.
struct CtContact {
    double gap = 0;
    Eigen::Vector3d normal; ///< from a to b
};
inline CtContact ct_contact(const CtGrain& a, const CtGrain& b) {
    const Eigen::Vector3d r = b.center - a.center;
    double lower = 0, upper = 1;
    Eigen::Vector3d normal = r;
    double value = 0;
    for (int step = 0; step < 16; ++step) { // the maximum over t of a concave function
        const double t = 0.5 * (lower + upper);
        const Eigen::Matrix3d mixed = (1 - t) * a.shape + t * b.shape;
        normal = mixed.inverse() * r;
        value = t * (1 - t) * r.dot(normal);
        const double slope = (1 - 2 * t) * r.dot(normal) - t * (1 - t) * normal.dot((b.shape - a.shape) * normal);
        (slope > 0 ? lower : upper) = t;
    }
    const double along = r.dot(normal) / normal.norm(); // distance of the centres along the normal
    return {along * (1 - 1 / std::sqrt(std::max(value, 1e-12))), normal.normalized()};
}

inline Eigen::Vector3d ct_half_extent(const CtGrain& grain) {
    return grain.shape.diagonal().cwiseSqrt();
}

inline std::vector<CtGrain> ct_random_grains(const CtRecipe& recipe, abut::Random& random) {
    std::vector<CtGrain> grains;
    double total = 0;
    for (int k = 0; k < recipe.grains; ++k) {
        const double radius = random.between(1 - recipe.size_spread, 1 + recipe.size_spread);
        Eigen::Vector3d axes;
        for (int a = 0; a < 3; ++a)
            axes[a] = std::sqrt(random.between(1, recipe.largest_aspect)) *
                      (random.below(2) == 0 ? 1 : 1 / std::sqrt(recipe.largest_aspect));
        axes *= radius / std::cbrt(axes.prod());
        Eigen::Quaterniond turn; // uniform over all rotations (Shoemake)
        const double u = random.unit(), v = 2 * std::numbers::pi * random.unit(),
                     w = 2 * std::numbers::pi * random.unit();
        turn.coeffs() << std::sqrt(1 - u) * std::sin(v), std::sqrt(1 - u) * std::cos(v), std::sqrt(u) * std::sin(w),
            std::sqrt(u) * std::cos(w);
        const Eigen::Matrix3d q = turn.toRotationMatrix();
        CtGrain grain;
        grain.shape = q * axes.cwiseAbs2().asDiagonal() * q.transpose();
        grain.volume = 4.0 / 3 * std::numbers::pi * axes.prod();
        for (int a = 0; a < 3; ++a) grain.center[a] = recipe.size * random.unit();
        total += grain.volume;
        grains.push_back(grain);
    }
    const double scale = std::cbrt(recipe.solid_fraction * std::pow(recipe.size, 3) / total);
    for (CtGrain& grain : grains) {
        grain.shape *= scale * scale;
        grain.volume *= scale * scale * scale;
    }
    return grains;
}

/// Calls visit(i, j) for pairs whose boxes come closer than `reach`.
template <class Visit>
void ct_near_pairs(const std::vector<CtGrain>& grains, double reach, const Visit& visit) {
    std::vector<Eigen::Vector3d> extent;
    for (const CtGrain& grain : grains) extent.push_back(ct_half_extent(grain));
    for (std::size_t i = 0; i < grains.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Eigen::Vector3d apart = (grains[i].center - grains[j].center).cwiseAbs();
            if (((apart - extent[i] - extent[j]).array() < reach).all()) visit(i, j);
        }
}

inline void ct_relax(const CtRecipe& recipe, CtStack& stack) {
    std::vector<CtGrain>& grains = stack.grains;
    for (int round = 0; round < recipe.relaxations; ++round) {
        std::vector<Eigen::Vector3d> move(grains.size(), Eigen::Vector3d::Zero());
        ct_near_pairs(grains, 0, [&](std::size_t i, std::size_t j) {
            const CtContact contact = ct_contact(grains[i], grains[j]);
            if (contact.gap >= 0) return;
            move[i] += 0.3 * contact.gap * contact.normal; // the normal points from i to j, the gap is negative
            move[j] -= 0.3 * contact.gap * contact.normal;
        });
        for (std::size_t i = 0; i < grains.size(); ++i) {
            const Eigen::Vector3d extent = ct_half_extent(grains[i]);
            for (int a = 0; a < 3; ++a)
                grains[i].center[a] = std::clamp(grains[i].center[a] + move[i][a], extent[a], recipe.size - extent[a]);
        }
    }
    ct_near_pairs(grains, 1, [&](std::size_t i, std::size_t j) {
        const double gap = ct_contact(grains[i], grains[j]).gap;
        stack.largest_overlap = std::max(stack.largest_overlap, -gap);
        if (gap < 0.5) ++stack.contacts;
    });
}

/// The grain of each voxel by its centre; of two that overlap, the one deeper inside.
inline void ct_draw(const CtRecipe& recipe, CtStack& stack) {
    const auto n = static_cast<std::size_t>(recipe.size);
    stack.truth.assign(n * n * n, 0);
    std::vector<float> least(n * n * n, 1);
    for (std::size_t g = 0; g < stack.grains.size(); ++g) {
        const CtGrain& grain = stack.grains[g];
        const Eigen::Matrix3d form = grain.shape.inverse();
        const Eigen::Vector3d extent = ct_half_extent(grain);
        Eigen::Vector3i from, to;
        for (int a = 0; a < 3; ++a) {
            from[a] = std::max(0, static_cast<int>(grain.center[a] - extent[a]) - 1);
            to[a] = std::min(recipe.size - 1, static_cast<int>(grain.center[a] + extent[a]) + 1);
        }
        for (int k = from[2]; k <= to[2]; ++k)
            for (int j = from[1]; j <= to[1]; ++j)
                for (int i = from[0]; i <= to[0]; ++i) {
                    const Eigen::Vector3d x = Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5) - grain.center;
                    const auto value = static_cast<float>(x.dot(form * x));
                    const std::size_t p = (k * n + j) * n + i;
                    if (value > least[p]) continue;
                    least[p] = value;
                    stack.truth[p] = static_cast<std::int32_t>(g + 1);
                }
    }
}

/// Gauss filter along the axis of this stride; the border's values go on beyond it.
inline void ct_blur(std::vector<float>& grey, std::size_t n, std::size_t stride, double sigma) {
    const int reach = static_cast<int>(std::ceil(4 * sigma));
    std::vector<float> weight;
    float sum = 0;
    for (int k = -reach; k <= reach; ++k) {
        weight.push_back(static_cast<float>(std::exp(-0.5 * k * k / (sigma * sigma))));
        sum += weight.back();
    }
    std::vector<float> result(grey.size(), 0);
    for (std::size_t block = 0; block < grey.size(); block += n * stride)
        for (int k = 0; k < static_cast<int>(n); ++k)
            for (int w = -reach; w <= reach; ++w) {
                const auto from = static_cast<std::size_t>(std::clamp(k + w, 0, static_cast<int>(n) - 1));
                const float* in = &grey[block + from * stride];
                float* out = &result[block + static_cast<std::size_t>(k) * stride];
                const float share = weight[static_cast<std::size_t>(w + reach)] / sum;
                for (std::size_t p = 0; p < stride; ++p) out[p] += share * in[p];
            }
    grey = std::move(result);
}

/// Normally distributed with standard deviation 1 (Box and Muller).
inline double ct_normal(abut::Random& random) {
    return std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(2 * std::numbers::pi * random.unit());
}

inline void ct_scan(const CtRecipe& recipe, CtStack& stack, abut::Random& random) {
    const auto n = static_cast<std::size_t>(recipe.size);
    std::vector<float> grey;
    grey.reserve(stack.truth.size());
    for (const std::int32_t grain : stack.truth)
        grey.push_back(static_cast<float>(grain > 0 ? recipe.grain_grey : recipe.void_grey));
    if (recipe.blur > 0)
        for (const std::size_t stride : {std::size_t{1}, n, n * n}) ct_blur(grey, n, stride, recipe.blur);
    for (std::size_t k = 0; k < n; ++k) {
        abut::Image image{recipe.size, recipe.size, 1, std::vector<std::uint16_t>(n * n), 8};
        for (std::size_t p = 0; p < n * n; ++p) {
            const std::size_t row = p / n, column = p % n; // from the top
            double value = grey[(k * n + n - 1 - row) * n + column];
            if (recipe.noise > 0) value += recipe.noise * ct_normal(random);
            image.pixels[p] = static_cast<std::uint16_t>(std::clamp<long>(std::lround(value), 0, 255));
        }
        stack.slices.push_back(std::move(image));
    }
}

inline CtStack ct_stack(const CtRecipe& recipe) {
    abut::Random random(recipe.seed);
    CtStack stack;
    stack.grains = ct_random_grains(recipe, random);
    ct_relax(recipe, stack);
    ct_draw(recipe, stack);
    ct_scan(recipe, stack, random);
    return stack;
}

} // namespace test

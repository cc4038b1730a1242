// Grains that touch in a noisy, blurred stack: how many of them come out right.
#include "ct_stack.h"
#include "geometry/labels/label_image.h"
#include "support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <map>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test

namespace {

LabelledImage grains_of(const test::CtStack& stack, std::optional<double> split, int speckle) {
    ImageSpec spec;
    spec.bodies = BodiesBy::component;
    spec.split = split;
    spec.speckle = speckle;
    spec.legend = {test::grey(0, ""), test::grey(0, "grain")};
    spec.legend[0].grey_range = {{0, 124}};
    spec.legend[1].grey_range = {{125, 255}};
    const StackInfo info{stack.slices[0].width, stack.slices[0].height, static_cast<int>(stack.slices.size()), 8, {}};
    return label_stack(spec, 3, info, [&](int first, int last, const auto& visit) {
        for (int slice = first; slice <= last; ++slice) visit(slice, stack.slices[static_cast<std::size_t>(slice)]);
    });
}

struct Agreement {
    std::size_t bodies = 0;
    int right = 0;            ///< grains that share more than 90 % of their voxels, and of the body's, with one body
    double volume_error = 0;  ///< of those: mean of the absolute relative error
    double largest_error = 0; ///< ... and the largest
    int merged = 0;           ///< grains most of which lies in a body that holds most of another grain as well
};

Agreement compare(const test::CtStack& stack, const LabelledImage& image) {
    Agreement result;
    result.bodies = image.bodies.size();
    std::vector<std::map<std::int32_t, std::int64_t>> shared(stack.grains.size());
    std::vector<std::int64_t> voxels(stack.grains.size(), 0);
    for (std::size_t p = 0; p < stack.truth.size(); ++p) {
        if (stack.truth[p] == 0) continue;
        const auto grain = static_cast<std::size_t>(stack.truth[p] - 1);
        ++voxels[grain];
        if (image.volume.label[p] > 0) ++shared[grain][image.volume.label[p]];
    }
    std::map<std::int32_t, int> grains_in;
    std::vector<std::int32_t> body_of(stack.grains.size(), 0);
    for (std::size_t g = 0; g < stack.grains.size(); ++g) {
        std::int64_t most = 0;
        for (const auto& [body, count] : shared[g])
            if (count > most) {
                most = count;
                body_of[g] = body;
            }
        if (body_of[g] == 0) continue;
        ++grains_in[body_of[g]];
        const std::int64_t pixels = image.bodies[static_cast<std::size_t>(body_of[g] - 1)].pixels;
        if (10 * most <= 9 * std::max(voxels[g], pixels)) continue;
        const double error = std::abs(static_cast<double>(pixels) / static_cast<double>(voxels[g]) - 1);
        ++result.right;
        result.volume_error += error;
        result.largest_error = std::max(result.largest_error, error);
    }
    result.volume_error /= std::max(1, result.right);
    for (const std::int32_t body : body_of) result.merged += grains_in[body] > 1 ? 1 : 0;
    return result;
}

Agreement report(const test::CtStack& stack, std::optional<double> split, int speckle) {
    const auto start = std::chrono::steady_clock::now();
    const LabelledImage image = grains_of(stack, split, speckle);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Agreement found = compare(stack, image);
    std::printf("split %4.1f: %5zu bodies, %3d of %zu grains right, volumes to %.2f %% (worst %.1f %%), %3d merged; "
                "%d speckles of %lld voxels; %.2f s\n",
                split.value_or(0), found.bodies, found.right, stack.grains.size(), 100 * found.volume_error,
                100 * found.largest_error, found.merged, image.speckles, static_cast<long long>(image.speckle_pixels),
                seconds);
    return found;
}

} // namespace

TEST(LabelsCt, GrainsThatTouchComeApart) {
    test::CtRecipe recipe;
    recipe.size = 100;
    recipe.grains = 62;
    recipe.relaxations = 1000;
    const test::CtStack stack = test::ct_stack(recipe);
    std::printf("%d contacts, overlaps up to %.2f voxels\n", stack.contacts, stack.largest_overlap);
    EXPECT_LT(stack.largest_overlap, 0.5);
    EXPECT_GT(stack.contacts, 2 * 50);
    for (const double split : {0.75, 1.0, 2.0}) {
        const Agreement found = report(stack, split, 30);
        EXPECT_EQ(found.bodies, 62u);
        EXPECT_EQ(found.right, 62);
        EXPECT_LT(found.volume_error, 0.01);
    }
    EXPECT_GT(report(stack, {}, 30).merged, 50) << "without";
    EXPECT_GT(report(stack, 1.0, 0).bodies, 80u) << "bright voxels of noise are bodies";
}

TEST(LabelsCt, FullStackOf500Grains) {
    const test::CtStack stack = test::ct_stack({});
    std::printf("%d contacts, overlaps up to %.2f voxels\n", stack.contacts, stack.largest_overlap);
    for (const double split : {0.75, 1.0, 1.5, 3.0}) {
        const Agreement found = report(stack, split, 30);
        EXPECT_EQ(found.bodies, 500u);
        EXPECT_EQ(found.right, 500);
        EXPECT_LT(found.volume_error, 0.01);
    }
    EXPECT_GT(report(stack, 0.5, 30).bodies, 500u) << "roughness of the pixels";
    EXPECT_EQ(report(stack, {}, 30).merged, 500);
}

/// Properties of scenes made by chance.

#include "stability/random_scene.h"

namespace {

using namespace test;

/// Prints scenes that fail, shrunk. \return whether it is one of ten, and enough is known
bool report(std::uint64_t seed, const RandomScene& scene, const std::function<std::string(const RandomScene&)>& fails,
            int& failed) {
    const RandomScene small = shrunk(scene, fails);
    ADD_FAILURE() << "seed " << seed << ": " << fails(scene) << "\nshrunk to " << text_of(small) << "\n"
                  << fails(small);
    return ++failed == 10;
}

/// \param threads every so many of them also with two threads
void try_advised(std::uint64_t first, std::uint64_t count, std::uint64_t threads) {
    Figures figures(std::to_string(count) + " advised scenes");
    int failed = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const bool threads_too = seed % threads == 0;
        const RandomScene scene = random_scene(seed, Choice::advised);
        if (what_fails(scene, threads_too, &figures).empty()) continue;
        if (report(
                seed, scene, [&](const RandomScene& s) { return what_fails(s, threads_too); }, failed))
            return;
    }
}

/// Steps near the stability limit, bodies of one particle, any stress update, high orders: the energy may grow, and a
/// run may end, but with a diagnosis; momentum and the same bits are kept all the same. How many scenes gain energy is
/// printed, and that it is at most one in six: the wave speed over the cell says nothing of nodes with next to no mass.
void try_anything(std::uint64_t first, std::uint64_t count, std::uint64_t threads) {
    Figures figures(std::to_string(count) + " scenes of anything");
    int failed = 0;
    double ended = 0, gained = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const bool threads_too = seed % threads == 0;
        const RandomScene scene = random_scene(seed, Choice::anything);
        const auto fails = [&](const RandomScene& s) {
            const std::string what = what_fails(s, threads_too);
            const bool diagnosed = what.rfind("step ", 0) == 0 && what.find("of body") != std::string::npos;
            return diagnosed || what.rfind("energy gained", 0) == 0 ? std::string() : what;
        };
        const std::string what = what_fails(scene, threads_too, &figures);
        ended += what.rfind("step ", 0) == 0;
        gained += what.rfind("energy gained", 0) == 0;
        if (!fails(scene).empty() && report(seed, scene, fails, failed)) return;
    }
    figures.at_most("share that gains energy or ends",
                    std::to_string(int(gained)) + " and " + std::to_string(int(ended)),
                    (gained + ended) / static_cast<double>(count), 1.0 / 6);
}

TEST(RandomScenes, AdvisedOnesKeepMomentumEnergyAndBits) {
    try_advised(1, 400, 40);
}

TEST(RandomScenes, AnythingKeepsMomentumAndBitsOrSaysWhatWentWrong) {
    try_anything(1, 200, 40);
}

TEST(RandomScenes, FullTenThousand) {
    try_advised(100001, 7000, 50);
    try_anything(100001, 3000, 50);
}

/// The search for a smaller scene finds one: here the smallest with two bodies of which one is of the second material.
TEST(RandomScenes, AreShrunkToWhatMatters) {
    const auto fails = [](const RandomScene& s) {
        const bool second =
            std::any_of(s.bodies.begin(), s.bodies.end(), [](const RandomBody& b) { return b.material; });
        return s.bodies.size() >= 2 && second && s.contact ? std::string("fails") : std::string();
    };
    std::uint64_t seed = 1;
    while (fails(random_scene(seed, Choice::anything)).empty()) ++seed;
    const RandomScene small = shrunk(random_scene(seed, Choice::anything), fails);
    EXPECT_FALSE(fails(small).empty());
    EXPECT_EQ(small.bodies.size(), 2U);
    EXPECT_EQ(small.steps, 1);
    EXPECT_EQ(small.transfer.scheme, TransferScheme::flip);
    EXPECT_FALSE(small.walls || small.gravity || small.plane_stress);
    for (const RandomBody& b : small.bodies) EXPECT_TRUE(b.n[0] == 1 && b.n[1] == 1 && b.velocity == Vector{});
    EXPECT_NE(text_of(small).find("RandomScene{"), std::string::npos);
}

} // namespace

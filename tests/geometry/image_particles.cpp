// Pictures to particles: the legend, and the area-weighted majority against a brute-force oracle.
#include "geometry/image_particles.h"

#include "geometry/packing/random.h"
#include "grid/effective_cell.h"
#include "support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::grey;
using test::picture;
using testing::ElementsAre;

namespace {

using Places = std::map<std::pair<int, int>, int>; ///< lattice place -> body

Places places_of(const ImageParticles& particles, const GridSpec& grid, int per_cell) {
    const Vector cell = effective_cell(grid);
    Places places;
    for (std::size_t body = 0; body < particles.position.size(); ++body)
        for (const Vector& centre : particles.position[body]) {
            const double i = (centre[0] - grid.lower[0]) / cell[0] * per_cell - 0.5;
            const double j = (centre[1] - grid.lower[1]) / cell[1] * per_cell - 0.5;
            EXPECT_NEAR(i, std::round(i), 1e-9) << "particles lie on the grid's lattice";
            EXPECT_NEAR(j, std::round(j), 1e-9);
            const auto [at, is_new] =
                places.insert({{static_cast<int>(std::lround(i)), static_cast<int>(std::lround(j))}, int(body)});
            EXPECT_TRUE(is_new) << "one particle a place";
        }
    return places;
}

/// Label of the picture at a point, 0 outside it.
int label_at(const LabelledPicture& image, const ImageSpec& spec, double x, double y) {
    const int column = static_cast<int>(std::floor((x - spec.lower[0]) / spec.pixel[0]));
    const int up = static_cast<int>(std::floor((y - spec.lower[1]) / spec.pixel[1]));
    if (column < 0 || up < 0 || column >= image.width || up >= image.height) return 0;
    const int row = spec.first_row_is_up ? image.height - 1 - up : up;
    return image.label[static_cast<std::size_t>(row) * image.width + column];
}

Image random_picture(Random& random, int width, int height, int colours) {
    Image image{width, height, 1, {}};
    for (int k = 0; k < width * height; ++k) image.pixels.push_back(static_cast<std::uint8_t>(random.below(colours)));
    return image;
}

GridSpec grid_of(Vector cell, Vector lower, Vector upper) {
    return {cell, lower, upper};
}

} // namespace

TEST(Legend, ExactAndWithinTolerance) {
    std::vector<LegendEntry> legend{grey(10, "a"), grey(20, "b"), grey(255, "")};
    legend[1].tolerance = 5;
    const LabelledPicture image = label_pixels(picture({{10, 25, 255}, {15, 11, 26}}), legend);
    EXPECT_THAT(image.bodies, ElementsAre("a", "b"));
    EXPECT_THAT(image.label, ElementsAre(1, 2, 0, 2, 0, 0));
    EXPECT_THAT(image.pixels_of_entry, ElementsAre(1, 2, 1));
    ASSERT_EQ(image.unmatched.size(), 2u);
    EXPECT_EQ(colour_name(image.unmatched[0].rgb), "grey 11");
}

TEST(Legend, NearestEntryWinsThenTheFirst) {
    std::vector<LegendEntry> legend{grey(10, "a"), grey(20, "b"), grey(20, "c")};
    for (LegendEntry& entry : legend) entry.tolerance = 10;
    EXPECT_THAT(label_pixels(picture({{14, 15, 16, 20}}), legend).label, ElementsAre(1, 1, 2, 2));
}

TEST(Legend, ToleranceIsPerChannel) {
    LegendEntry red = grey(0, "red");
    red.rgb = {200, 40, 30};
    red.tolerance = 6;
    const Image image{3, 1, 3, {206, 34, 36, 207, 40, 30, 200, 40, 30}};
    const LabelledPicture labelled = label_pixels(image, {red});
    EXPECT_THAT(labelled.label, ElementsAre(1, 0, 1));
    EXPECT_EQ(colour_name(labelled.unmatched.at(0).rgb), "#cf281e");
}

TEST(Legend, SeveralColoursOfOneBodyShareItsLabel) {
    const LabelledPicture image =
        label_pixels(picture({{1, 2, 3}}), {grey(3, "late"), grey(1, "early"), grey(2, "late")});
    EXPECT_THAT(image.bodies, ElementsAre("late", "early"));
    EXPECT_THAT(image.label, ElementsAre(2, 1, 1));
}

TEST(Legend, UnmatchedColoursComeMostFrequentFirst) {
    const LabelledPicture image = label_pixels(picture({{9, 9, 5, 7, 7, 7}}), {});
    ASSERT_EQ(image.unmatched.size(), 3u);
    EXPECT_EQ(image.unmatched[0].pixels, 3);
    EXPECT_EQ(image.unmatched[0].rgb[0], 7);
    EXPECT_EQ(image.unmatched[2].rgb[0], 5);
}

TEST(ImageParticles, TopRowIsTopUnlessToldOtherwise) {
    const GridSpec grid = grid_of({1, 1, 0}, {0, 0, 0}, {2, 2, 0});
    const LabelledPicture image = label_pixels(picture({{1, 0}, {0, 0}}), {grey(1, "a"), grey(0, "")});
    ImageSpec spec;
    spec.pixel = {1, 1};
    spec.particles_per_cell = 1;
    EXPECT_THAT(image_particles(spec, image, grid).position.at(0), ElementsAre(Vector{0.5, 1.5, 0}));
    spec.first_row_is_up = false;
    EXPECT_THAT(image_particles(spec, image, grid).position.at(0), ElementsAre(Vector{0.5, 0.5, 0}));
}

TEST(ImageParticles, SizeInsteadOfPixel) {
    ImageSpec spec;
    spec.size = {2, 3};
    EXPECT_THAT(pixel_size(spec, 4, 12), ElementsAre(0.5, 0.25));
    spec.pixel = {7, 8};
    EXPECT_THAT(pixel_size(spec, 4, 12), ElementsAre(7, 8));
}

TEST(ImageParticles, TiesGoToMaterialThenToTheEarlierBody) {
    const GridSpec grid = grid_of({2, 2, 0}, {0, 0, 0}, {2, 2, 0});
    ImageSpec spec;
    spec.pixel = {1, 1};
    spec.particles_per_cell = 1;
    const std::vector<LegendEntry> legend{grey(0, ""), grey(1, "a"), grey(2, "b")};
    const auto winner = [&](const std::vector<std::vector<int>>& rows) {
        const Places places = places_of(image_particles(spec, label_pixels(picture(rows), legend), grid), grid, 1);
        return places.empty() ? -1 : places.begin()->second;
    };
    EXPECT_EQ(winner({{0, 0}, {2, 2}}), 1) << "material before void";
    EXPECT_EQ(winner({{2, 2}, {1, 1}}), 0) << "the earlier body";
    EXPECT_EQ(winner({{2, 1}, {1, 2}}), 0);
    EXPECT_EQ(winner({{0, 0}, {1, 2}}), -1) << "void covers most";
    EXPECT_EQ(winner({{2, 2}, {1, 0}}), 1);
}

TEST(ImageParticles, TiesDontDependOnRoundOff) {
    // Places of 6 × 6 pixels, half of them of one body, half of the other, shuffled: every place is a tie, and the two
    // sums are rounded differently.
    const GridSpec grid = grid_of({0.6, 0.6, 0}, {0.7, -0.3, 0}, {0.7 + 20 * 0.6, -0.3 + 20 * 0.6, 0});
    ImageSpec spec;
    spec.pixel = {0.1, 0.1};
    spec.lower = grid.lower;
    spec.particles_per_cell = 1;
    Random random(11);
    std::vector<std::vector<int>> rows(120, std::vector<int>(120));
    for (std::size_t place = 0; place < 400; ++place) {
        int left[2] = {18, 18};
        for (std::size_t k = 0; k < 36; ++k) {
            const int body = random.below(left[0] + left[1]) < left[0] ? 0 : 1;
            --left[body];
            rows[place / 20 * 6 + k / 6][place % 20 * 6 + k % 6] = body;
        }
    }
    const ImageParticles particles =
        image_particles(spec, label_pixels(picture(rows), {grey(0, "a"), grey(1, "b")}), grid);
    EXPECT_EQ(particles.position[0].size(), 400u);
    EXPECT_EQ(particles.position[1].size(), 0u);
}

TEST(ImageParticles, BeyondThePictureIsVoid) {
    const GridSpec grid = grid_of({1, 1, 0}, {0, 0, 0}, {4, 4, 0});
    ImageSpec spec;
    spec.particles_per_cell = 1;
    spec.lower = {0.4, 0.4, 0};
    spec.pixel = {2.2, 2.2}; // to 2.6: the places 0 and 2 are covered by 0.6 each way, 0.36 in the corners
    const LabelledPicture image = label_pixels(picture({{1}}), {grey(1, "a")});
    const Places places = places_of(image_particles(spec, image, grid), grid, 1);
    EXPECT_EQ(places.size(), 5u);
    EXPECT_TRUE(places.contains({1, 0}) && places.contains({0, 1}) && places.contains({1, 1}) &&
                places.contains({2, 1}) && places.contains({1, 2}));
}

TEST(ImageParticles, PlacesBeyondTheGridAreLeftOut) {
    const GridSpec grid = grid_of({1, 1, 0}, {0, 0, 0}, {2, 2, 0});
    ImageSpec spec;
    spec.pixel = {10, 10};
    spec.lower = {-4, -4, 0};
    const LabelledPicture image = label_pixels(picture({{1}}), {grey(1, "a")});
    EXPECT_EQ(image_particles(spec, image, grid).position[0].size(), 16u);
    spec.lower = {1e15, 0, 0};
    EXPECT_EQ(image_particles(spec, image, grid).position[0].size(), 0u);
}

/// Random pictures, pixels and grids, against sampling each place with 40 × 40 points.
TEST(ImageParticles, MajorityAgreesWithSupersampling) {
    Random random(7);
    int compared = 0, near_tie = 0;
    for (int round = 0; round < 25; ++round) {
        const int per_cell = 1 + random.below(3);
        const GridSpec grid = grid_of({random.between(0.4, 1.5), random.between(0.4, 1.5), 0},
                                      {random.between(-3, 3), random.between(-3, 3), 0}, {9, 8, 0});
        ImageSpec spec;
        const double ratio = std::exp(random.between(std::log(0.15), std::log(6.0)));
        spec.pixel = {ratio * random.between(0.5, 1.5), ratio * random.between(0.5, 1.5)};
        spec.lower = {grid.lower[0] + random.between(-2, 3), grid.lower[1] + random.between(-2, 3), 0};
        spec.first_row_is_up = random.below(2) == 0;
        spec.particles_per_cell = per_cell;
        const Image image = random_picture(random, 1 + random.below(30), 1 + random.below(30), 4);
        const LabelledPicture labelled = label_pixels(image, {grey(0, ""), grey(1, "a"), grey(2, "b"), grey(3, "a")});
        const ImageParticles particles = image_particles(spec, labelled, grid);
        const Places places = places_of(particles, grid, per_cell);

        const Vector cell = effective_cell(grid);
        const std::array<int, 3> cells = cell_counts(grid);
        constexpr int samples = 40;
        for (int j = 0; j < cells[1] * per_cell; ++j)
            for (int i = 0; i < cells[0] * per_cell; ++i) {
                std::array<int, 3> hits{};
                for (int q = 0; q < samples; ++q)
                    for (int p = 0; p < samples; ++p)
                        ++hits[label_at(labelled, spec, grid.lower[0] + (i + (p + 0.5) / samples) * cell[0] / per_cell,
                                        grid.lower[1] + (j + (q + 0.5) / samples) * cell[1] / per_cell)];
                const auto found = places.find({i, j});
                const int got = found == places.end() ? 0 : found->second + 1;
                const int most = std::max({hits[0], hits[1], hits[2]});
                // Sampling is exact to about a row of samples along each edge within the place.
                if (hits[got] == most)
                    ++compared;
                else {
                    ++near_tie;
                    EXPECT_GT(hits[got], most - 0.1 * samples * samples) << "place " << i << ", " << j;
                }
            }
    }
    EXPECT_GT(compared, 3000);
    EXPECT_LT(near_tie, compared / 50);
}

TEST(ImageParticles, ExactAreaWhenPixelsAndParticlesFit) {
    // 2 × 2 pixels a particle, as in the compaction of ellipses: 280 pixels of 3.57 um are 0.9996 mm.
    const GridSpec grid = grid_of({14.3e-6, 14.3e-6, 0}, {0, 0, 0}, {1e-3, 2e-3, 0});
    EXPECT_EQ(cell_counts(grid)[0], 70);
    EXPECT_EQ(cell_counts(grid)[1], 140);
    EXPECT_DOUBLE_EQ(effective_cell(grid)[0], 1e-3 / 70);
    ImageSpec spec;
    spec.pixel = {3.57e-6, 3.57e-6};
    const Image full{280, 560, 1, test::Bytes(280 * 560, 5)};
    EXPECT_EQ(image_particles(spec, label_pixels(full, {grey(5, "a")}), grid).position[0].size(), 140u * 280u);
}

TEST(ImageParticles, WorkGrowsWithPixelsPlusParticles) {
    const auto seconds = [](int pixels, int places) {
        const GridSpec grid = grid_of({1, 1, 0}, {0, 0, 0}, {places * 1.0, places * 1.0, 0});
        ImageSpec spec;
        spec.size = {places * 1.0, places * 1.0};
        spec.particles_per_cell = 1;
        Random random(3);
        const Image image = random_picture(random, pixels, pixels, 200);
        std::vector<LegendEntry> legend;
        legend.reserve(200);
        for (int k = 0; k < 200; ++k) legend.push_back(grey(k, fmt::format("b{}", k)));
        const LabelledPicture labelled = label_pixels(image, legend);
        const auto start = std::chrono::steady_clock::now();
        EXPECT_FALSE(image_particles(spec, labelled, grid).position.empty());
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    // 4 million of either: not a benchmark, only far below what pixels × particles would take.
    EXPECT_LT(seconds(2000, 20), 10);
    EXPECT_LT(seconds(20, 2000), 10);
}

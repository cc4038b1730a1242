// Pixels to places: the majority and covered fractions, against brute-force oracles.
#include "geometry/image_cover.h"

#include "geometry/packing/random.h"
#include "grid/effective_cell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using testing::ElementsAre;

namespace {

/// An image from its rows as seen, top first.
LabelVolume image_of(const std::vector<std::vector<int>>& rows) {
    LabelVolume image{{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1}, {}};
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        image.label.insert(image.label.end(), row->begin(), row->end());
    return image;
}

LabelVolume random_image(Random& random, const std::array<int, 3>& size, int labels) {
    LabelVolume image{size, {}};
    for (int k = 0; k < size[0] * size[1] * size[2]; ++k) image.label.push_back(random.below(labels));
    return image;
}

using Places = std::map<Place, int>; ///< place -> label

Places places_of(const std::vector<std::vector<Covered>>& covered) {
    Places places;
    for (std::size_t body = 0; body < covered.size(); ++body)
        for (const Covered& each : covered[body]) {
            EXPECT_EQ(each.fraction, 1);
            EXPECT_TRUE(places.insert({each.place, static_cast<int>(body) + 1}).second) << "one particle a place";
        }
    return places;
}

int label_at(const LabelVolume& image, const ImageFrame& frame, const Vector& x, std::size_t dimension) {
    std::array<int, 3> pixel{};
    for (std::size_t a = 0; a < dimension; ++a) {
        pixel[a] = static_cast<int>(std::floor((x[a] - frame.lower[a]) / frame.pixel[a]));
        if (pixel[a] < 0 || pixel[a] >= image.size[a]) return 0;
    }
    return image.at(pixel[0], pixel[1], pixel[2]);
}

const Lattice unit_lattice{2, {0, 0, 0}, {1, 1, 0}};

} // namespace

TEST(ImageCover, OfEqualSharesTheLowerOrLeftWins) {
    const auto winner = [&](const std::vector<std::vector<int>>& rows) {
        const Places places =
            places_of(cover_image(image_of(rows), 2, {{}, {0.5, 0.5, 0}}, unit_lattice, {1, 1, 1}, Fill::majority));
        return places.empty() ? 0 : places.begin()->second;
    };
    EXPECT_EQ(winner({{0, 0}, {2, 2}}), 2) << "a body's upper side";
    EXPECT_EQ(winner({{2, 2}, {0, 0}}), 0) << "its lower side";
    EXPECT_EQ(winner({{2, 0}, {2, 0}}), 2);
    EXPECT_EQ(winner({{0, 2}, {0, 2}}), 0);
    EXPECT_EQ(winner({{2, 2}, {1, 1}}), 1);
    EXPECT_EQ(winner({{1, 1}, {2, 2}}), 2);
    EXPECT_EQ(winner({{2, 1}, {1, 2}}), 1) << "alike: the lower label";
    EXPECT_EQ(winner({{2, 0}, {0, 2}}), 2) << "alike: a body before void";
    EXPECT_EQ(winner({{0, 0}, {1, 2}}), 0) << "void covers most";
    EXPECT_EQ(winner({{2, 2}, {1, 0}}), 2);
}

TEST(ImageCover, TiesDontDependOnRoundOff) {
    // Places of 6 × 6 pixels, half of them of one body, half of the other, shuffled: every place is a tie, and the two
    // sums are rounded differently. Which one lies lower whole numbers tell.
    const Lattice lattice{2, {0.7, -0.3, 0}, {0.6, 0.6, 0}};
    Random random(11);
    std::vector<std::vector<int>> rows(120, std::vector<int>(120));
    std::map<Place, int> expected;
    for (std::size_t place = 0; place < 400; ++place) {
        int left[2] = {18, 18};
        int height = 0, right = 0; // sums of the first body's minus the second's
        for (std::size_t k = 0; k < 36; ++k) {
            const int body = random.below(left[0] + left[1]) < left[0] ? 0 : 1;
            --left[body];
            const int row = static_cast<int>(k) / 6, column = static_cast<int>(k) % 6;
            rows[place / 20 * 6 + k / 6][place % 20 * 6 + k % 6] = body + 1;
            height += (body == 0 ? 1 : -1) * (5 - row);
            right += (body == 0 ? 1 : -1) * column;
        }
        const int winner = height != 0 ? (height < 0 ? 1 : 2) : (right <= 0 ? 1 : 2);
        expected[{static_cast<int>(place % 20), 19 - static_cast<int>(place / 20), 0}] = winner;
    }
    EXPECT_EQ(
        places_of(cover_image(image_of(rows), 2, {lattice.lower, {0.1, 0.1, 0}}, lattice, {20, 20, 1}, Fill::majority)),
        expected);
}

TEST(ImageCover, BeyondTheImageIsVoid) {
    // From 0.4 to 2.6: the places 0 and 2 are covered by 0.6 each way, 0.36 in the corners.
    const ImageFrame frame{{0.4, 0.4, 0}, {2.2, 2.2, 0}};
    const Places places = places_of(cover_image(image_of({{1}}), 1, frame, unit_lattice, {4, 4, 1}, Fill::majority));
    EXPECT_EQ(places.size(), 5u);
    EXPECT_TRUE(places.contains({1, 0, 0}) && places.contains({0, 1, 0}) && places.contains({1, 1, 0}) &&
                places.contains({2, 1, 0}) && places.contains({1, 2, 0}));
    const auto parts = cover_image(image_of({{1}}), 1, frame, unit_lattice, {4, 4, 1}, Fill::covered_fraction)[0];
    ASSERT_EQ(parts.size(), 9u);
    EXPECT_NEAR(parts[0].fraction, 0.36, 1e-15);
    EXPECT_NEAR(parts[0].centre[0], 0.7, 1e-15);
    EXPECT_NEAR(parts[0].variance[0], 0.36 / 12, 1e-15);
    EXPECT_EQ(parts[4].fraction, 1);
}

TEST(ImageCover, PlacesBeyondTheGridAreLeftOut) {
    const LabelVolume image = image_of({{1}});
    const auto count = [&](const Vector& lower) {
        return cover_image(image, 1, {lower, {10, 10, 0}}, unit_lattice, {4, 4, 1}, Fill::majority)[0].size();
    };
    EXPECT_EQ(count({-4, -4, 0}), 16u);
    EXPECT_EQ(count({1e15, 0, 0}), 0u);
    EXPECT_EQ(count({-1e15, 0, 0}), 0u);
}

/// Random images, pixels and lattices in two and three dimensions, against sampling each place.
TEST(ImageCover, MajorityAndFractionsAgreeWithSampling) {
    Random random(7);
    int compared = 0;
    int near_tie = 0;
    for (int round = 0; round < 30; ++round) {
        const std::size_t dimension = round % 3 == 2 ? 3 : 2;
        Lattice lattice{dimension, {}, {}};
        ImageFrame frame;
        Place places{1, 1, 1};
        std::array<int, 3> size{1, 1, 1};
        const double ratio = std::exp(random.between(std::log(0.2), std::log(6.0)));
        for (std::size_t a = 0; a < dimension; ++a) {
            lattice.lower[a] = random.between(-3, 3);
            lattice.edge[a] = random.between(0.4, 1.5);
            places[a] = 1 + random.below(dimension == 3 ? 6 : 12);
            frame.pixel[a] = ratio * random.between(0.5, 1.5);
            frame.lower[a] = lattice.lower[a] + random.between(-2, 3);
            size[a] = 1 + random.below(dimension == 3 ? 8 : 30);
        }
        const LabelVolume image = random_image(random, size, 3);
        const Places majority = places_of(cover_image(image, 2, frame, lattice, places, Fill::majority));
        std::map<std::pair<Place, int>, Covered> parts;
        const auto covered = cover_image(image, 2, frame, lattice, places, Fill::covered_fraction);
        for (int body = 0; body < 2; ++body)
            for (const Covered& each : covered[static_cast<std::size_t>(body)]) parts[{each.place, body + 1}] = each;

        const int samples = dimension == 3 ? 12 : 40;
        const int depth = dimension == 3 ? samples : 1;
        const double all = samples * samples * depth;
        for (int k = 0; k < places[2]; ++k)
            for (int j = 0; j < places[1]; ++j)
                for (int i = 0; i < places[0]; ++i) {
                    std::array<double, 3> hits{};
                    std::array<double, 3> sum_x{};
                    for (int r = 0; r < depth; ++r)
                        for (int q = 0; q < samples; ++q)
                            for (int p = 0; p < samples; ++p) {
                                const Vector at{i + (p + 0.5) / samples, j + (q + 0.5) / samples,
                                                k + (r + 0.5) / depth};
                                Vector x{};
                                for (std::size_t a = 0; a < dimension; ++a)
                                    x[a] = lattice.lower[a] + at[a] * lattice.edge[a];
                                const auto label = static_cast<std::size_t>(label_at(image, frame, x, dimension));
                                hits[label] += 1 / all;
                                sum_x[label] += x[0] / all;
                            }
                    const auto found = majority.find({i, j, k});
                    const auto got = static_cast<std::size_t>(found == majority.end() ? 0 : found->second);
                    const double most = std::max({hits[0], hits[1], hits[2]});
                    // Sampling is right to about a row of samples along each edge within the place.
                    const double error = (dimension == 3 ? 4.0 : 4.0) / samples * (1 + 1 / ratio);
                    ++(hits[got] == most ? compared : near_tie);
                    EXPECT_GT(hits[got], most - error) << "place " << i << ", " << j << ", " << k;
                    for (int label = 1; label < 3; ++label) {
                        const auto part = parts.find({{i, j, k}, label});
                        const double fraction = part == parts.end() ? 0 : part->second.fraction;
                        const auto l = static_cast<std::size_t>(label);
                        EXPECT_NEAR(fraction, hits[l], error / 2);
                        if (fraction > 0.3) {
                            EXPECT_NEAR(part->second.centre[0], sum_x[l] / hits[l], error * lattice.edge[0]);
                        }
                    }
                }
    }
    EXPECT_GT(compared, 1000);
    EXPECT_LT(near_tie, compared / 20);
}

TEST(ImageCover, FractionsKeepTheAreaExactly) {
    Random random(3);
    const LabelVolume image = random_image(random, {37, 23, 1}, 3);
    std::array<double, 3> pixels{};
    for (const std::int32_t label : image.label) pixels[static_cast<std::size_t>(label)] += 1;
    const Lattice lattice{2, {-1.3, -0.7, 0}, {0.31, 0.47, 0}}; // pixels of 0.1 × 0.2 at the origin
    const auto covered = cover_image(image, 2, {{}, {0.1, 0.2, 0}}, lattice, {40, 40, 1}, Fill::covered_fraction);
    for (std::size_t body = 0; body < 2; ++body) {
        double area = 0;
        for (const Covered& each : covered[body]) area += each.fraction * lattice.content();
        EXPECT_NEAR(area, pixels[body + 1] * 0.02, 1e-12);
    }
}

TEST(ImageCover, MeansAndValuesOfASecondImage) {
    LabelVolume values{{4, 2, 1}, {0, 10, 20, 30, 40, 50, 60, 70}};
    const ImageFrame frame{{0, 0, 0}, {1, 1, 0}};
    const Lattice lattice{2, {0.5, 0, 0}, {2, 2, 0}}; // half of column 0, column 1, half of column 2
    const LabelVolume image{{4, 2, 1}, {1, 1, 0, 0, 2, 2, 0, 0}};
    const auto mean = [&](int label) { return mean_over_places(values, image, label, frame, lattice, {{0, 0, 0}}); };
    EXPECT_THAT(mean(1), ElementsAre(testing::DoubleNear((0 * 0.5 + 10) / 1.5, 1e-12))) << "its own pixels";
    EXPECT_THAT(mean(2), ElementsAre(testing::DoubleNear((40 * 0.5 + 50) / 1.5, 1e-12)));
    EXPECT_THAT(mean(3), ElementsAre(testing::DoubleNear(30, 1e-12))) << "all, where it has none";
    EXPECT_EQ(value_at(values, frame, 2, {2.5, 1.5, 0}), 60);
    EXPECT_EQ(value_at(values, frame, 2, {-9, 9, 0}), 40) << "the nearest pixel";
}

TEST(ImageCover, WorkGrowsWithPixelsPlusPlaces) {
    const auto seconds = [](int pixels, int places) {
        Random random(3);
        const LabelVolume image = random_image(random, {pixels, pixels, 1}, 200);
        const double edge = static_cast<double>(pixels) / places;
        const auto start = std::chrono::steady_clock::now();
        EXPECT_FALSE(
            cover_image(image, 199, {{}, {1, 1, 0}}, {2, {}, {edge, edge, 0}}, {places, places, 1}, Fill::majority)
                .empty());
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    // 4 million of either: not a benchmark, only far below what pixels × places would take.
    EXPECT_LT(seconds(2000, 20), 10);
    EXPECT_LT(seconds(20, 2000), 10);
}

// Arrows of contact pairs with the colours of their separations.
#include "io/render/compose.h"
#include "io/render/contact_arrows.h"
#include "io/render/render_series.h"
#include "render_contact_support.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace abut::test {
namespace {

TEST(RenderContact, ArrowsHaveTheColoursOfSeparations) {
    TemporaryFolder folder;
    RenderOptions options;
    options.preset = "contact";
    const Image image(render_series(write_series(folder), options).at(0));
    ColourScale scale = separation_scale(std::pair(-2e-6, 1e-6), false); // of the pairs in contact
    EXPECT_DOUBLE_EQ(scale.lower, -2e-6);
    EXPECT_DOUBLE_EQ(scale.upper, 2e-6);
    EXPECT_EQ(scale.unit, "µm");
    const Layout layout = contact_layout(scale);
    const auto at = [&](double y_mm, double right, double up = 0) {
        const double point[3] = {1e-3, y_mm * 1e-3, 0};
        const Pixel p = layout.view.pixel(point);
        return image.at({p[0] + right, p[1] + up});
    };
    EXPECT_EQ(at(0.2, 8), map_colour(ColourMap::diverging, 0));
    EXPECT_EQ(at(0.4, 8), map_colour(ColourMap::diverging, 0.75));
    EXPECT_EQ(at(0.6, 8)[0], map_colour(ColourMap::diverging, 1)[0]); // beyond: the end's colour
    // Arrows point to body_b; pale bodies elsewhere; only pairs in contact have the thickness of a bold arrow.
    for (const double y : {0.2, 0.4, 0.6}) EXPECT_EQ(at(y, -5), lighter(body_colour(0), 0.7)) << y;
    EXPECT_EQ(at(0.2, 8, 1.7), map_colour(ColourMap::diverging, 0));
    EXPECT_EQ(at(0.6, 8, 4), lighter(body_colour(1), 0.7));
    EXPECT_LT(at(0.2, 8, 2.9)[2], 170); // the dark edge; blue both within and without
    EXPECT_TRUE(image.is_white_at_the_edges());
}

TEST(RenderContact, ArrowsAreNoLongerThanNodesAreApart) {
    const ColourScale scale = separation_scale(std::pair(-1.0, 1.0), true);
    Layout layout = contact_layout(scale);
    const auto longest = [&](double spacing) {
        PointFrame frame = contacts();
        for (std::size_t i = 0; i < 4; ++i) frame.points[3 * i + 1] = 1e-4 + spacing * static_cast<double>(i);
        Picture picture;
        add_separations(picture, frame, layout, scale);
        double reach = 0;
        const Pixel node = layout.view.pixel(frame.points.data());
        for (const Pixel& corner : picture.quads.corners) reach = std::max(reach, corner[0] - node[0]);
        return reach;
    };
    const double pixel = 1 / layout.view.scale;
    EXPECT_NEAR(longest(16 * pixel), 16, 3); // and its edge
    EXPECT_NEAR(longest(100 * pixel), 25, 4);
    EXPECT_NEAR(longest(1 * pixel), 10, 2); // still to be seen
}

/// Before bodies meet, the colours tell how far apart they are.
TEST(RenderContact, PairsThatAreAllApartHaveTheColoursOfTheirSeparations) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    PointFrame apart = contacts();
    apart.arrays[1].values = std::vector<double>{2e-6, 10e-6, 20e-6, 40e-6};
    apart.arrays[2].values = std::vector<std::int32_t>{0, 0, 0, 0};
    write_contact(folder / "c0.vtp", apart);
    RenderOptions options;
    options.preset = "contact";
    const Image image(render_series(results, options).at(0));
    const ColourScale scale = separation_scale(std::pair(2e-6, 40e-6), false);
    EXPECT_EQ(scale.unit, "µm");
    const Layout layout = contact_layout(scale);
    std::set<Rgb> colours;
    for (std::size_t i = 0; i < 4; ++i) {
        const Pixel p = layout.view.pixel(&apart.points[3 * i]);
        colours.insert(image.at({p[0] + 8, p[1]}));
    }
    EXPECT_EQ(colours.size(), 4U) << "each its own";
    const Pixel last = layout.view.pixel(&apart.points[9]);
    EXPECT_EQ(image.at({last[0] + 8, last[1]})[0], map_colour(ColourMap::diverging, 1)[0]);
}

/// A series with some pairs in contact keeps their range, also for frames where all are apart.
TEST(RenderContact, AFrameInContactGivesTheRangeOfTheSeries) {
    const RenderOptions options = [] {
        RenderOptions separations;
        separations.separations = true;
        return separations;
    }();
    PointFrame apart = contacts();
    apart.arrays[2].values = std::vector<std::int32_t>{0, 0, 0, 0};
    const PointFrame touching = contacts();
    const ShownValues none = shown_values(particles(), &apart, options);
    EXPECT_FALSE(none.range.has_value());
    EXPECT_EQ(none.all, (std::pair{-2e-6, 30e-6}));
    EXPECT_EQ(joined(none, shown_values(particles(), &touching, options)).range, (std::pair{-2e-6, 1e-6}));
}

TEST(RenderContact, NoPairsGiveAPicture) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    PointFrame none = contacts();
    none.points.clear();
    for (Array& array : none.arrays) std::visit([](auto& values) { values.clear(); }, array.values);
    write_contact(folder / "c0.vtp", none);
    RenderOptions options;
    options.preset = "contact";
    EXPECT_EQ(render_series(results, options).size(), 1u);
}

} // namespace
} // namespace abut::test

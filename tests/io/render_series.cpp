// Two bodies side by side, the left one taller and sheared: what is drawn must lie where it belongs.
#include "io/render/render_series.h"
#include "io/render/layout.h"
#include "io/results/pvd.h"
#include "io/results/write_frame.h"
#include "io/results/write_text.h"
#include "render_support.h"
#include "results_support.h"

#include <cmath>
#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr double half = 0.005e-3; // of a particle's edge [m]

/// One particle: centre, body and pressure.
void add(PointFrame& frame, double x, double y, int body, double pressure) {
    frame.points.insert(frame.points.end(), {x, y, 0});
    const auto append = [&](std::size_t array, std::initializer_list<double> values) {
        auto& all = std::get<0>(frame.arrays[array].values);
        all.insert(all.end(), values);
    };
    append(0, {half, half, 0});
    append(1, {1, 0, 0, 0, 1, 0, 0, 0, 1});
    append(2, {pressure});
    append(3, {0, -3, 4});
    std::get<1>(frame.arrays[4].values).push_back(body);
}

PointFrame empty_frame(double time) {
    PointFrame frame;
    frame.time = time;
    frame.arrays = {{"half_size", 3, std::vector<double>{}},
                    {"deformation_gradient", 9, std::vector<double>{}},
                    {"pressure", 1, std::vector<double>{}},
                    {"velocity", 3, std::vector<double>{}},
                    {"body", 1, std::vector<std::int32_t>{}}};
    frame.words = {{"body_names", {"left", "right"}}};
    return frame;
}

/// The box is 1 mm x 2 mm; body 0 fills its left half, body 1 the lower right quarter.
fs::path write_series(const TemporaryFolder& folder, int frames = 2, bool with_half_size = true) {
    const fs::path results = folder / "results";
    for (const char* name : {"particles", "grid", "contact"}) fs::create_directories(results / name);
    PvdSeries particles{results / "particles.pvd", {}}, grids{results / "grid.pvd", {}},
        contacts{results / "contact.pvd", {}};
    for (int f = 0; f < frames; ++f) {
        PointFrame frame = empty_frame(f * 1e-6);
        for (double y = half; y < 2e-3; y += 2 * half)
            for (double x = half; x < 1e-3; x += 2 * half)
                if (x < 0.5e-3 || y < 1e-3) add(frame, x, y, x < 0.5e-3 ? 0 : 1, 4e9 * f * y / 2e-3);
        if (!with_half_size) frame.arrays.erase(frame.arrays.begin());
        const std::string number = std::to_string(f);
        write_particles(results / "particles" / (number + ".vtu"), frame);
        particles.append(frame.time, "particles/" + number + ".vtu");

        GridFrame grid;
        grid.nodes = {11, 21, 1};
        grid.spacing = {0.1e-3, 0.1e-3, 0.1e-3};
        write_grid(results / "grid" / (number + ".vti"), grid);
        grids.append(frame.time, "grid/" + number + ".vti");

        PointFrame contact; // one pair in contact pointing right, one not in contact above it
        contact.points = {0.5e-3, 0.5e-3, 0, 0.5e-3, 0.8e-3, 0};
        contact.arrays = {{"normal", 3, std::vector<double>{1, 0, 0, 1, 0, 0}},
                          {"in_contact", 1, std::vector<std::int32_t>{1, 0}}};
        write_contact(results / "contact" / (number + ".vtp"), contact);
        contacts.append(frame.time, "contact/" + number + ".vtp");
    }
    return results;
}

double legend_width() {
    const std::vector<LegendItem> legend{{"left", {}}, {"right", {}}};
    return panel_width(legend, 1);
}

Layout expected_layout(double panel) {
    return make_layout({{0, 0, 0}, {1e-3, 2e-3, 0}}, 1000, 0, panel);
}

Pixel place(const Layout& layout, double x_mm, double y_mm) {
    const double point[3] = {x_mm * 1e-3, y_mm * 1e-3, 0};
    return layout.view.pixel(point);
}

TEST(RenderSeries, BodiesLieWhereTheyBelong) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    RenderOptions options;
    options.preset = "bodies";
    const auto files = render_series(results, options);
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[1], results / "frames/bodies/frame_00001.png");

    const Layout layout = expected_layout(legend_width());
    const Image image(files[0]);
    ASSERT_EQ(image.width(), 1000);
    ASSERT_EQ(image.height(), layout.height);
    EXPECT_GT(image.height(), 1500); // a tall box, a tall picture
    EXPECT_EQ(image.at(place(layout, 0.25, 1.5)), body_colour(0));
    EXPECT_EQ(image.at(place(layout, 0.25, 0.5)), body_colour(0));
    EXPECT_EQ(image.at(place(layout, 0.75, 0.5)), body_colour(1));
    EXPECT_EQ(image.at(place(layout, 0.75, 1.5)), (Rgb{255, 255, 255}));
    EXPECT_EQ(image.at(place(layout, 0.495, 0.9)), body_colour(0)); // the seam is sharp
    EXPECT_EQ(image.at(place(layout, 0.505, 0.9)), body_colour(1));
    EXPECT_EQ(image.at(place(layout, 0.9, 0.995)), body_colour(1));
    EXPECT_EQ(image.at(place(layout, 0.9, 1.005)), (Rgb{255, 255, 255}));
    EXPECT_TRUE(image.is_white_at_the_edges());
}

TEST(RenderSeries, NeighbouringDomainsLeaveNoGaps) {
    TemporaryFolder folder;
    RenderOptions options;
    options.last_only = true;
    const auto files = render_series(write_series(folder), options);
    ASSERT_EQ(files.size(), 1u);
    EXPECT_EQ(files[0].filename(), "frame_00001.png");
    const Layout layout = expected_layout(legend_width());
    const Image image(files[0]);
    const Pixel lower = place(layout, 0.01, 0.01), upper = place(layout, 0.49, 1.99);
    int others = 0;
    for (double y = std::ceil(lower[1]); y < upper[1]; ++y)
        for (double x = std::ceil(lower[0]); x < upper[0]; ++x) others += image.at({x, y}) != body_colour(0);
    EXPECT_EQ(others, 0);
}

TEST(RenderSeries, ValuesAreColouredOverOneRange) {
    TemporaryFolder folder;
    RenderOptions options;
    options.preset = "pressure"; // 0 to 4 GPa from bottom to top in the last frame, 0 in the first
    options.output = folder / "pictures";
    const auto files = render_series(write_series(folder), options);
    Array pressure{"pressure", 1, std::vector<double>{}};
    const ColourScale scale = colour_scale(pressure, -1, std::pair(0.0, 4e9), false);
    const Layout layout = expected_layout(panel_width(scale, 1));
    const Image first(files[0]), last(files[1]);
    EXPECT_EQ(first.at(place(layout, 0.25, 1.5)), map_colour(ColourMap::sequential, 0));
    for (const double y : {0.2, 1.0, 1.9})
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(last.at(place(layout, 0.25, y))[k], map_colour(ColourMap::sequential, y / 2)[k], 3) << y;
    EXPECT_TRUE(last.is_white_at_the_edges());
}

TEST(RenderSeries, NormalsOfPairsInContactAreDrawn) {
    TemporaryFolder folder;
    RenderOptions options;
    options.preset = "normals";
    options.frames = std::vector<int>{1};
    const auto files = render_series(write_series(folder), options);
    const Layout layout = expected_layout(legend_width());
    const Image image(files.at(0));
    const Pixel touching = place(layout, 0.5, 0.5), apart = place(layout, 0.5, 0.8);
    EXPECT_LT(image.at({touching[0] + 10, touching[1]})[0], 60);  // the shaft
    EXPECT_GT(image.at({touching[0] - 10, touching[1]})[0], 100); // nothing on its other side
    EXPECT_GT(image.at({apart[0] + 10, apart[1]})[0], 100);
}

TEST(RenderSeries, DeformedDomainsAreParallelograms) {
    PointFrame frame = empty_frame(0);
    add(frame, 0, 0, 0, 0);
    std::get<0>(frame.arrays[0].values) = {0.1, 0.1, 0};
    std::get<0>(frame.arrays[1].values) = {1, 1, 0, 0, 1, 0, 0, 0, 1}; // x = X + Y: leans to the right
    Quads quads;
    ASSERT_TRUE(
        add_domains(quads, frame, View{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {50, 50}, 100}, {body_colour(0)}, {0}));
    const std::vector<Pixel> expected{{30, 40}, {50, 40}, {70, 60}, {50, 60}};
    ASSERT_EQ(quads.corners.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(quads.corners[i][k], expected[i][k], 0.6);
}

TEST(RenderSeries, WithoutDomainsParticlesAreDots) {
    TemporaryFolder folder;
    RenderOptions options;
    options.last_only = true;
    const auto files = render_series(write_series(folder, 2, false), options);
    const Layout layout = expected_layout(legend_width());
    EXPECT_EQ(Image(files.at(0)).at(place(layout, 0.755, 0.505)), body_colour(1));
}

TEST(RenderSeries, SpaceIsSeenObliquely) {
    TemporaryFolder folder;
    PointFrame frame;
    for (int i = 0; i < 1000; ++i) // a cube, body 1 on top of body 0
        frame.points.insert(frame.points.end(), {i % 10 * 1.0, i / 10 % 10 * 1.0, i / 100 * 1.0});
    std::vector<std::int32_t> body(1000, 0);
    std::fill(body.begin() + 500, body.end(), 1);
    frame.arrays = {{"body", 1, body}, {"volume", 1, std::vector<double>(1000, 1.0)}};
    write_particles(folder / "0.vtu", frame);
    PvdSeries{folder / "particles.pvd", {}}.append(0, "0.vtu");
    const Image image(render_series(folder.path, {}).at(0));
    const auto has_hue = [&](double y, std::size_t strong, std::size_t weak) {
        const Rgb c = image.at({image.width() / 2.0, y});
        return c[strong] > c[weak] + 20;
    };
    EXPECT_TRUE(has_hue(0.3 * image.height(), 2, 0)); // blue below
    EXPECT_TRUE(has_hue(0.7 * image.height(), 0, 2)); // orange above
    EXPECT_TRUE(image.is_white_at_the_edges());
}

TEST(RenderSeries, AFrameNamedTwiceIsDrawnOnce) {
    TemporaryFolder folder;
    RenderOptions options;
    options.frames = std::vector<int>{1, 0, 1};
    const auto files = render_series(write_series(folder), options);
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0].filename(), "frame_00001.png"); // the order asked for is that of an animation
    EXPECT_EQ(files[1].filename(), "frame_00000.png");
}

TEST(RenderSeries, EmptyFrameGivesAPicture) {
    TemporaryFolder folder;
    const fs::path results = folder / "results";
    fs::create_directories(results);
    PvdSeries series{results / "particles.pvd", {}};
    write_particles(results / "0.vtu", empty_frame(0));
    series.append(0, "0.vtu");
    for (const char* preset : {"bodies", "pressure"}) {
        RenderOptions options;
        options.preset = preset;
        EXPECT_TRUE(Image(render_series(results, options).at(0)).is_white_at_the_edges());
    }
}

TEST(RenderSeries, ErrorsSayWhatThereIs) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { render_series(folder / "none", {}); }), HasSubstr("none: no such folder"));
    EXPECT_THAT(error_of([&] { render_series(folder.path, {}); }), HasSubstr("no particles.pvd"));
    const fs::path results = write_series(folder);
    RenderOptions options;
    options.array = "presure";
    EXPECT_THAT(error_of([&] { render_series(results, options); }),
                HasSubstr("no array \"presure\"; did you mean \"pressure\"? (there are: half_size,"));
    options.preset = "vonmises";
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("did you mean \"von-mises\"?"));
    options = {};
    options.frames = std::vector<int>{2};
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("no frame 2; there are 0 to 1"));
    options = {};
    options.array = "velocity";
    options.component = 3;
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("has components 0 to 2, not 3"));

    fs::resize_file(results / "particles/1.vtu", 2000);
    EXPECT_THAT(error_of([&] { render_series(results, {}); }), HasSubstr("particles/1.vtu: cannot read"));
    fs::remove_all(results / "contact.pvd");
    options = {};
    options.preset = "normals";
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("no contact.pvd"));
}

TEST(Render, PrintsNothing) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder, 1);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    render_series(results, {});
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace abut::test

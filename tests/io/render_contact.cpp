// Contact pairs with separations; presets and what results lack; the live picture.
#include "io/render/contact_arrows.h"
#include "io/render/live_picture.h"
#include "io/render/render_series.h"
#include "io/results/pvd.h"
#include "io/results/write_frame.h"
#include "render_support.h"
#include "results_support.h"

#include <cmath>
#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr Bounds box{{0, 0, 0}, {2e-3, 1e-3, 0}};

/// Body 0 fills the left half of the box, body 1 the right one.
PointFrame particles(double time = 0) {
    PointFrame frame;
    frame.time = time;
    frame.points = {0.5e-3, 0.5e-3, 0, 1.5e-3, 0.5e-3, 0};
    frame.arrays = {{"half_size", 3, std::vector<double>{0.5e-3, 0.5e-3, 0, 0.5e-3, 0.5e-3, 0}},
                    {"body", 1, std::vector<std::int32_t>{0, 1}},
                    {"von_mises_stress", 1, std::vector<double>{1e6, 2e6}},
                    {"strain_energy_density", 1, std::vector<double>{0, 3e3}}};
    frame.words = {{"body_names", {"left", "right"}}};
    return frame;
}

/// Pairs up the middle: in contact overlapping by 2 um, in contact with 1 um between, and two apart by 30 um; normals
/// to the right.
PointFrame contacts() {
    PointFrame frame;
    frame.points = {1e-3, 0.2e-3, 0, 1e-3, 0.4e-3, 0, 1e-3, 0.6e-3, 0, 1e-3, 0.8e-3, 0};
    frame.arrays = {{"normal", 3, std::vector<double>{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}},
                    {"separation", 1, std::vector<double>{-2e-6, 1e-6, 30e-6, 30e-6}},
                    {"in_contact", 1, std::vector<std::int32_t>{1, 1, 0, 0}},
                    {"body_a", 1, std::vector<std::int32_t>{0, 0, 0, 0}},
                    {"body_b", 1, std::vector<std::int32_t>{1, 1, 1, 1}}};
    return frame;
}

fs::path write_series(const TemporaryFolder& folder) {
    write_particles(folder / "p0.vtu", particles());
    PvdSeries{folder / "particles.pvd", {}}.append(0, "p0.vtu");
    write_contact(folder / "c0.vtp", contacts());
    PvdSeries{folder / "contact.pvd", {}}.append(0, "c0.vtp");
    GridFrame grid;
    grid.nodes = {3, 2, 1};
    grid.spacing = {1e-3, 1e-3, 1e-3};
    write_grid(folder / "g0.vti", grid);
    PvdSeries{folder / "grid.pvd", {}}.append(0, "g0.vti");
    return folder.path;
}

Layout contact_layout(const ColourScale& scale) {
    return make_layout(box, 1000, 0, std::max(panel_width(scale, 1), arrow_key_width(1)));
}

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

TEST(RenderContact, FramesWithoutPairsOfTheirTimeAreLeftOutOrRefused) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    PvdSeries series{folder / "particles.pvd", {}}, pairs{folder / "contact.pvd", {}};
    for (const double time : {0.0, 1.0, 2.0, 3.0}) series.append(time, "p0.vtu");
    for (const double time : {0.0, 1.5, 3.0}) pairs.append(time, "c0.vtp");
    for (const char* preset : {"contact", "normals"}) {
        std::vector<std::string> notes;
        RenderOptions options;
        options.preset = preset;
        options.width = 200;
        options.note = [&](const std::string& note) { notes.push_back(note); };
        const auto files = render_series(results, options);
        ASSERT_EQ(files.size(), 2u);
        EXPECT_EQ(files[1].filename(), "frame_00003.png");
        EXPECT_THAT(notes, testing::ElementsAre(testing::AllOf(HasSubstr("2 of 4 frames"),
                                                               HasSubstr("contact.pvd has no frame"),
                                                               HasSubstr("contact_every"))));
        options.last_only = true;
        EXPECT_EQ(render_series(results, options).size(), 1u);
        options.last_only = false;
        options.frames = std::vector<int>{0, 2};
        options.output = folder / "none";
        EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("frame 2: "));
        EXPECT_THROW(render_series(results, options), RenderRequestError);
        EXPECT_FALSE(fs::exists(options.output));
        EXPECT_EQ(notes.size(), 1u);
    }
    PvdSeries{folder / "contact.pvd", {}}.append(0.5, "c0.vtp");
    RenderOptions options;
    options.preset = "contact";
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("no frame at any time"));
}

TEST(RenderContact, ArraysThatPairsLackAreNamed) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    for (const std::string lacking : {"normal", "in_contact", "separation", "body_b"}) {
        SCOPED_TRACE(lacking);
        PointFrame pairs = contacts();
        std::erase_if(pairs.arrays, [&](const Array& array) { return array.name == lacking; });
        write_contact(folder / "c0.vtp", pairs);
        RenderOptions options;
        options.preset = "contact";
        options.width = 200;
        if (lacking == "body_b") options.bodies = {"left"};
        const std::string message = error_of([&] { render_series(results, options); });
        EXPECT_THAT(message, AllOf(HasSubstr((folder / "contact.pvd").string()), HasSubstr('"' + lacking + '"'),
                                   HasSubstr("contact_arrays")));
        EXPECT_THROW(render_series(results, options), RenderRequestError);
        EXPECT_FALSE(fs::exists(results / "frames"));
    }
    PointFrame pairs = contacts(); // black arrows show no separations
    std::erase_if(pairs.arrays, [&](const Array& array) { return array.name == "separation"; });
    write_contact(folder / "c0.vtp", pairs);
    RenderOptions options;
    options.preset = "normals";
    EXPECT_EQ(render_series(results, options).size(), 1u);
}

TEST(RenderPresets, NamesOfQuantitiesHaveUnits) {
    for (const auto& [name, quantity, unit] :
         {std::tuple{"orientation", "orientation", "rad"}, std::tuple{"temperature", "temperature", "K"},
          std::tuple{"strain_energy_density", "strain energy density", "kJ/m³"},
          std::tuple{"von_mises_stress", "von Mises stress", "kPa"}, std::tuple{"body_count", "body count", ""}}) {
        const bool small = std::string_view(unit).size() > 0 && unit[0] != 'k';
        const ColourScale scale =
            colour_scale({name, 1, std::vector<double>{}}, -1, std::pair(0.0, small ? 300.0 : 5e3), true);
        EXPECT_EQ(scale.quantity, quantity);
        EXPECT_EQ(scale.unit, unit);
    }
}

TEST(RenderPresets, WhatResultsLackIsSaid) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    RenderOptions options;
    options.preset = "temperature";
    EXPECT_THAT(error_of([&] { render_series(results, options); }),
                AllOf(HasSubstr("this scene has no temperature"), HasSubstr("bodies, stress, energy"),
                      Not(HasSubstr("velocity"))));
    options.preset = "velocity"; // every scene has one; it was left out
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("particle_arrays"));
    options.preset = "energy";
    EXPECT_EQ(render_series(results, options).size(), 1u);
    options = {};
    options.bodies = {"rihgt"};
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("did you mean \"right\"?"));
    options = {};
    options.region = {0, 0, 0, 1, 1, 1};
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("4 numbers"));
    options.region = {1e-3, 0, 1e-3, 1e-3};
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("empty along x"));
    options = {};
    options.percentile = 30;
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("percentile"));
    EXPECT_FALSE(fs::exists(results / "frames/temperature"));
}

TEST(RenderPresets, ARegionFillsThePictureAndEndsAtItsEdges) {
    TemporaryFolder folder;
    RenderOptions options;
    options.region = {0.9e-3, 0.2e-3, 1.1e-3, 0.3e-3};
    options.legend = false;
    const Image image(render_series(write_series(folder), options).at(0));
    const Layout layout = make_layout({{0.9e-3, 0.2e-3, 0}, {1.1e-3, 0.3e-3, 0}}, 1000, 0, 0);
    const auto at = [&](double x_um, double y_um) {
        const double point[3] = {x_um * 1e-6, y_um * 1e-6, 0};
        return image.at(layout.view.pixel(point));
    };
    EXPECT_EQ(at(902, 202), body_colour(0));
    EXPECT_EQ(at(998, 298), body_colour(0));
    EXPECT_EQ(at(1002, 202), body_colour(1));
    EXPECT_EQ(at(1098, 298), body_colour(1));
    EXPECT_EQ(at(898, 250), (Rgb{255, 255, 255}));
    EXPECT_EQ(at(1000, 303), (Rgb{255, 255, 255}));
    EXPECT_TRUE(image.is_white_at_the_edges());
}

TEST(RenderPresets, MissingAndCutFilesStopBeforeAnythingIsWritten) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    for (const char* name : {"p1.vtu", "p2.vtu"}) write_particles(folder / name, particles());
    PvdSeries series{folder / "particles.pvd", {}};
    for (int i = 0; i < 3; ++i) series.append(i, "p" + std::to_string(i) + ".vtu");
    fs::resize_file(folder / "p2.vtu", fs::file_size(folder / "p2.vtu") - 5);
    EXPECT_THAT(error_of([&] { render_series(results, {}); }), HasSubstr("p2.vtu: cannot read: the file is cut off"));
    std::ofstream(folder / "p1.vtu", std::ios::app) << "garbage"; // two writers
    EXPECT_THAT(error_of([&] { render_series(results, {}); }), HasSubstr("p1.vtu: cannot read: the file is cut off"));
    fs::remove(folder / "p1.vtu");
    EXPECT_THAT(error_of([&] { render_series(results, {}); }), HasSubstr("p1.vtu: cannot read: no such file"));
    EXPECT_FALSE(fs::exists(results / "frames"));
    RenderOptions options;
    options.frames = std::vector<int>{0};
    EXPECT_EQ(render_series(results, options).size(), 1u);
}

TEST(LivePicture, ShowsTheFrameAndKeepsItsView) {
    TemporaryFolder folder;
    LivePicture live(folder / "live.png", box, "Two", "bodies", 1e-6);
    EXPECT_FALSE(live.wants_contact());
    EXPECT_FALSE(fs::exists(folder / "live.png"));
    PointFrame frame = particles();
    live.draw(frame, nullptr);
    const std::vector<LegendItem> legend{{"left", {}}, {"right", {}}};
    const Layout layout = make_layout(box, 1000, 0, panel_width(legend, 1));
    const double left[3] = {0.25e-3, 0.5e-3, 0}, right[3] = {1.75e-3, 0.5e-3, 0};
    {
        const Image image(folder / "live.png");
        EXPECT_EQ(image.at(layout.view.pixel(left)), body_colour(0));
        EXPECT_EQ(image.at(layout.view.pixel(right)), body_colour(1));
    }
    std::swap(frame.points[0], frame.points[3]);
    live.draw(frame, nullptr);
    const Image image(folder / "live.png");
    EXPECT_EQ(image.at(layout.view.pixel(left)), body_colour(1));
    EXPECT_EQ(image.at(layout.view.pixel(right)), body_colour(0));
}

TEST(LivePicture, FailuresAreToldOnce) {
    TemporaryFolder folder;
    LivePicture live(folder / "none/live.png", box, "", "bodies", 1);
    LivePicture without_contact(folder / "live.png", box, "", "contact", 1);
    EXPECT_TRUE(without_contact.wants_contact());
    testing::internal::CaptureStderr();
    for (int i = 0; i < 3; ++i) {
        live.draw(particles(), nullptr);
        without_contact.draw(particles(), nullptr);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_THAT(said, HasSubstr("live.png is not drawn: "));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 2);
    EXPECT_THAT(said, HasSubstr("has none"));
    EXPECT_FALSE(fs::exists(folder / "live.png"));
}

} // namespace
} // namespace abut::test

// Contact pairs of a series; presets and what results lack; the live picture.
#include "io/render/live_picture.h"
#include "io/render/render_series.h"
#include "io/results/pvd.h"
#include "render_contact_support.h"

#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::HasSubstr;
using testing::Not;

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

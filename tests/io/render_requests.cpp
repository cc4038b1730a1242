// Requests that can't be met are refused before anything is drawn; where pictures go.
#include "io/render/render_series.h"
#include "io/results/pvd.h"
#include "io/results/write_frame.h"
#include "results_support.h"

#include <cmath>
#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Two particles side by side, in a grid of 2 mm x 1 mm, and a pair between them.
fs::path write_series(const TemporaryFolder& folder, int frames = 2) {
    const fs::path results = folder / "results";
    fs::create_directories(results);
    PointFrame frame;
    frame.points = {0.5e-3, 0.5e-3, 0, 1.5e-3, 0.5e-3, 0};
    frame.arrays = {{"half_size", 3, std::vector<double>{0.5e-3, 0.5e-3, 0, 0.5e-3, 0.5e-3, 0}},
                    {"body", 1, std::vector<std::int32_t>{0, 1}},
                    {"pressure", 1, std::vector<double>{1e6, 2e6}}};
    frame.words = {{"body_names", {"left", "right"}}};
    PointFrame pair;
    pair.points = {1e-3, 0.5e-3, 0};
    pair.arrays = {{"normal", 3, std::vector<double>{1, 0, 0}}, {"in_contact", 1, std::vector<std::int32_t>{1}}};
    GridFrame grid;
    grid.nodes = {3, 2, 1};
    grid.spacing = {1e-3, 1e-3, 1e-3};
    write_particles(results / "p.vtu", frame);
    write_contact(results / "c.vtp", pair);
    write_grid(results / "g.vti", grid);
    PvdSeries particles{results / "particles.pvd", {}}, pairs{results / "contact.pvd", {}},
        grids{results / "grid.pvd", {}};
    for (int f = 0; f < frames; ++f) {
        particles.append(f, "p.vtu");
        pairs.append(f, "c.vtp");
        grids.append(f, "g.vti");
    }
    return results;
}

TEST(RenderRequests, FilesWithoutArraysAreSaidToHaveNone) {
    TemporaryFolder folder;
    PointFrame bare;
    bare.points = {0, 0, 0, 1, 1, 0};
    write_particles(folder / "0.vtu", bare);
    PvdSeries{folder / "particles.pvd", {}}.append(0, "0.vtu");
    EXPECT_THAT(error_of([&] { render_series(folder.path, {}); }), HasSubstr("no array \"body\": there are none"));
    RenderOptions options;
    options.preset = "stress";
    EXPECT_THAT(error_of([&] { render_series(folder.path, options); }), HasSubstr("the files have no arrays"));
}

TEST(RenderRequests, NumbersThatAreNoneAreRefused) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    constexpr double inf = INFINITY;
    for (const auto& [lower, upper] : {std::pair{-inf, inf}, {0.0, inf}, {std::nan(""), 1.0}, {-1.7e308, 1.7e308}}) {
        RenderOptions options;
        options.array = "pressure";
        options.range = std::pair(lower, upper);
        EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("must be finite")) << upper;
    }
    for (const std::vector<double>& region : {std::vector<double>{0, 0, inf, 1}, {0, 0, 1, std::nan("")}}) {
        RenderOptions options;
        options.region = region;
        EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("region must be finite"));
    }
    for (const std::vector<double>& region : {std::vector<double>{0, 0, 1e300, 1e300}, {1, 1, 2, 2}}) {
        RenderOptions options;
        options.region = region;
        EXPECT_THROW(render_series(results, options), RenderRequestError);
    }
    EXPECT_FALSE(fs::exists(results / "frames"));
}

TEST(RenderRequests, FoldersHaveTheNamesOfPresets) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder, 1);
    const auto place = [&](RenderOptions options) {
        options.width = 200;
        return fs::relative(render_series(results, options).at(0), results / "frames").parent_path().string();
    };
    RenderOptions options;
    EXPECT_EQ(place(options), "bodies");
    options.normals = true;
    EXPECT_EQ(place(options), "normals");
    options.array = "pressure";
    EXPECT_EQ(place(options), "pressure");
    options.preset = "bodies";
    EXPECT_EQ(place(options), "bodies");
}

TEST(RenderRequests, AnAnimationReplacesNoPictureAndNoFolder) {
    TemporaryFolder folder;
    const fs::path results = write_series(folder);
    RenderOptions options;
    options.output = folder / "p";
    options.width = 200;
    const fs::path picture = render_series(results, options).at(1);
    const std::string before = read_text(picture);
    fs::create_directory_symlink(folder / "p", folder / "link");
    for (const char* name : {"p/frame_00001.png", "p/../p/./frame_00001.png", "link/frame_00000.png"}) {
        options.animation = folder / name;
        EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("would replace one of the pictures"));
        EXPECT_THROW(render_series(results, options), RenderRequestError);
    }
    EXPECT_TRUE(read_text(picture) == before);
    fs::create_directory(folder / "film.apng");
    options.animation = folder / "film.apng";
    options.output = folder / "q";
    EXPECT_THAT(error_of([&] { render_series(results, options); }), HasSubstr("film.apng: is a folder"));
    EXPECT_THROW(render_series(results, options), RenderRequestError);
    EXPECT_FALSE(fs::exists(folder / "q"));
    options.animation = folder / "p/frame_00002.png"; // none of the two
    EXPECT_EQ(render_series(results, options).size(), 3u);
}

} // namespace
} // namespace abut::test

// A cube of two bodies, sheared: three-dimensional series as pictures.
#include "io/render/layout.h"
#include "io/render/render_series.h"
#include "io/render/surface.h"
#include "io/results/pvd.h"
#include "io/results/write_frame.h"
#include "render_support.h"
#include "results_support.h"

#include <cmath>
#include <functional>
#include <set>

namespace abut::test {
namespace {

namespace fs = std::filesystem;

constexpr int edge = 10; // particles along an edge of the cube, each of 1 m

/// Body 1 on top of body 0; x = X + shear Z, and moved by `shift` of the particle's undeformed place.
PointFrame cube(double shear, const std::function<Vector3(const Vector3&)>& shift = {}) {
    PointFrame frame;
    frame.time = shear;
    std::vector<double> half_size, gradient, displacement, pressure;
    std::vector<std::int32_t> body;
    for (int k = 0; k < edge; ++k)
        for (int j = 0; j < edge; ++j)
            for (int i = 0; i < edge; ++i) {
                const Vector3 X{i + 0.5, j + 0.5, k + 0.5};
                Vector3 u = shift ? shift(X) : Vector3{};
                u[0] += shear * X[2];
                frame.points.insert(frame.points.end(), {X[0] + u[0], X[1] + u[1], X[2] + u[2]});
                displacement.insert(displacement.end(), u.begin(), u.end());
                half_size.insert(half_size.end(), {0.5, 0.5, 0.5});
                gradient.insert(gradient.end(), {1, 0, shear, 0, 1, 0, 0, 0, 1});
                pressure.push_back(1e6 * i);
                body.push_back(k < edge / 2 ? 0 : 1);
            }
    frame.arrays = {{"half_size", 3, half_size},
                    {"deformation_gradient", 9, gradient},
                    {"displacement", 3, displacement},
                    {"pressure", 1, pressure},
                    {"body", 1, body}};
    frame.words = {{"body_names", {"lower", "upper"}}};
    return frame;
}

/// The cube at rest, then sheared by half; in a grid that is much larger.
fs::path write_series(const TemporaryFolder& folder) {
    const fs::path results = folder / "results";
    for (const char* name : {"particles", "grid"}) fs::create_directories(results / name);
    PvdSeries particles{results / "particles.pvd", {}}, grids{results / "grid.pvd", {}};
    for (const double shear : {0.0, 0.5}) {
        const std::string number = shear > 0 ? "1" : "0";
        write_particles(results / "particles" / (number + ".vtu"), cube(shear));
        particles.append(shear, "particles/" + number + ".vtu");
        GridFrame grid;
        grid.nodes = {41, 41, 31};
        grid.origin = {-10, -10, -10};
        write_grid(results / "grid" / (number + ".vti"), grid);
        grids.append(shear, "grid/" + number + ".vti");
    }
    return results;
}

/// Of the two frames together, and 5 % of the longest edge around.
Layout expected_layout(double panel) {
    return make_layout({{-0.75, -0.75, -0.75}, {15.75, 10.75, 10.75}}, 1000, 0, panel);
}

Layout legend_layout() {
    const std::vector<LegendItem> legend{{"lower", {}}, {"upper", {}}};
    return expected_layout(panel_width(legend, 1));
}

Pixel place(const Layout& layout, double x, double y, double z) {
    const Vector3 point{x, y, z};
    return layout.view.pixel(point.data());
}

/// Whether it is `colour`, darker by a factor between `lowest` and `highest`.
bool is_shade(const Rgb& seen, const Rgb& colour, double lowest, double highest) {
    const double factor = (seen[0] + seen[1] + seen[2]) / double(colour[0] + colour[1] + colour[2]);
    for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(seen[k] - factor * colour[k]) > 2) return false;
    return factor > lowest && factor < highest;
}

constexpr Rgb white{255, 255, 255};

TEST(RenderSpace, BodiesAreLitSolids) {
    TemporaryFolder folder;
    const auto files = render_series(write_series(folder), {});
    ASSERT_EQ(files.size(), 2u);
    const Layout layout = legend_layout();
    const Image rest(files[0]), sheared(files[1]);
    ASSERT_EQ(rest.width(), 1000);
    ASSERT_EQ(rest.height(), layout.height);
    for (const double x : {0.5, 5.0, 9.5})
        for (const double y : {0.5, 5.0, 9.5}) {
            EXPECT_EQ(rest.at(place(layout, x, y, 10)), body_colour(1)) << x << ' ' << y; // as in the legend
            EXPECT_EQ(sheared.at(place(layout, x + 5, y, 10)), body_colour(1)) << x << ' ' << y;
        }
    for (const double x : {0.5, 5.0, 9.5}) { // in front, nearly to the seam, and on the right
        EXPECT_TRUE(is_shade(rest.at(place(layout, x, 0, 5.2)), body_colour(1), 0.8, 0.95)) << x;
        EXPECT_TRUE(is_shade(rest.at(place(layout, x, 0, 4.8)), body_colour(0), 0.8, 0.95)) << x;
        EXPECT_TRUE(is_shade(rest.at(place(layout, 10, x, 4.8)), body_colour(0), 0.6, 0.8)) << x;
    }
    EXPECT_TRUE(is_shade(rest.at(place(layout, 0.5, 0, 9)), body_colour(1), 0.8, 0.95));
    EXPECT_EQ(sheared.at(place(layout, 4, 0, 9)), white); // it has leaned away from there
    EXPECT_TRUE(is_shade(sheared.at(place(layout, 5, 0, 9)), body_colour(1), 0.8, 0.95));
    EXPECT_TRUE(rest.is_white_at_the_edges());
    EXPECT_TRUE(sheared.is_white_at_the_edges());
}

TEST(RenderSpace, LeavesNoGaps) {
    TemporaryFolder folder;
    const Layout layout = legend_layout();
    const Image image(render_series(write_series(folder), {}).at(1));
    std::set<Rgb> colours;
    for (double x = 0.1; x < 9.9; x += 0.02)
        for (double z = 5.1; z < 9.9; z += 0.05) colours.insert(image.at(place(layout, x + z / 2, 0, z)));
    // Along seams, parts of a pixel may show the side of a particle, which is darker; but neither white nor body 0.
    for (const Rgb& colour : colours) EXPECT_TRUE(is_shade(colour, body_colour(1), 0.68, 0.95));
}

TEST(RenderSpace, ValuesHaveTheColoursOfTheMap) {
    TemporaryFolder folder;
    RenderOptions options;
    options.preset = "pressure"; // 0 to 9 MPa along x
    options.last_only = true;
    options.range = std::pair(0.0, 10e6);
    const Image image(render_series(write_series(folder), options).at(0));
    const ColourScale scale = colour_scale({"pressure", 1, std::vector<double>{}}, -1, options.range, true);
    const Layout layout = make_layout({{-0.75, -0.75, -0.75}, {15.75, 10.75, 10.75}}, 1000, 0, panel_width(scale, 1));
    for (int i = 0; i < edge; ++i) {
        const Rgb expected = map_colour(ColourMap::sequential, i / 10.0);
        EXPECT_TRUE(is_shade(image.at(place(layout, i + 3.0, 0, 5)), expected, 0.8, 0.95)) << i;
    }
    EXPECT_EQ(image.width(), 1000);
}

TEST(RenderSpace, ALayerOfParticlesIsThick) {
    TemporaryFolder folder;
    PointFrame frame;
    frame.points = {0.5, 0.5, 0, 1.5, 0.5, 0};
    frame.arrays = {{"half_size", 3, std::vector<double>{0.5, 0.5, 0.5, 0.5, 0.5, 0.5}},
                    {"body", 1, std::vector<std::int32_t>{0, 0}}};
    write_particles(folder / "0.vtu", frame);
    PvdSeries{folder / "particles.pvd", {}}.append(0, "0.vtu");
    const Image image(render_series(folder.path, {}).at(0));
    const Layout layout = make_layout({{-0.1, -0.1, -0.6}, {2.1, 1.1, 0.6}}, 1000, 0, 0);
    EXPECT_EQ(image.at(place(layout, 1.2, 0.5, 0.5)), body_colour(0));
    EXPECT_TRUE(is_shade(image.at(place(layout, 1.2, 0, 0)), body_colour(0), 0.8, 0.95));
}

TEST(RenderSpace, ParticlesWithinABodyAreHidden) {
    const auto seen = [](const PointFrame& frame) { return surface_particles(frame, *Domains::of(frame)).size(); };
    constexpr std::size_t all = 1000, half_inside = 8 * 8 * 3; // of each body, 10 x 10 x 5
    EXPECT_EQ(seen(cube(0)), all - 2 * half_inside);
    EXPECT_EQ(seen(cube(0.5)), all - 2 * half_inside);
    // Torn apart at x = 4, then 4 and 6 wide.
    const auto tear = [](const Vector3& X) { return Vector3{X[0] > 4 ? 0.3 : 0, 0, 0}; };
    EXPECT_EQ(seen(cube(0, tear)), all - 2 * (2 * 8 * 3 + 4 * 8 * 3));
    PointFrame frame = cube(0);
    frame.arrays[2].name = "unknown";
    EXPECT_EQ(seen(frame), all);
}

} // namespace
} // namespace abut::test

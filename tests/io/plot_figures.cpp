// Figures: where curves are, what axes say, and values that are hard to draw.
#include "io/render/offscreen_context.h"
#include "io/render/plot.h"
#include "io/render/plot_axis.h"
#include "io/render/plot_curves.h"
#include "results_support.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <memory>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

namespace abut::test {
namespace {

using testing::ElementsAre;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

struct Drawn {
    PlotArea area;
    vtkNew<vtkPNGReader> reader;
    std::string bytes;

    int width() { return reader->GetOutput()->GetDimensions()[0]; }
    int height() { return reader->GetOutput()->GetDimensions()[1]; }
    Rgb at(int x, int y) {
        const auto* pixel = static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer(x, y, 0));
        return {pixel[0], pixel[1], pixel[2]};
    }
    /// Whether a pixel of about this colour is within `reach` of the place.
    bool near(double x, double y, Rgb colour, int reach = 1) {
        for (int i = static_cast<int>(x) - reach; i <= static_cast<int>(x) + reach; ++i)
            for (int k = static_cast<int>(y) - reach; k <= static_cast<int>(y) + reach; ++k) {
                if (i < 0 || k < 0 || i >= width() || k >= height()) continue;
                const Rgb found = at(i, k);
                int off = 0;
                for (std::size_t c = 0; c < 3; ++c) off = std::max(off, std::abs(found[c] - colour[c]));
                if (off < 40) return true;
            }
        return false;
    }
    int count(Rgb colour) {
        int found = 0;
        for (int i = static_cast<int>(area.left); i < static_cast<int>(area.right); ++i)
            for (int k = static_cast<int>(area.bottom); k < static_cast<int>(area.top); ++k)
                found += near(i, k, colour, 0) ? 1 : 0;
        return found;
    }
};

std::unique_ptr<Drawn> draw(const Plot& plot) {
    static OffscreenContext context;
    const TemporaryFolder folder;
    auto drawn = std::make_unique<Drawn>();
    drawn->area = write_plot(context, plot, folder / "p.png");
    EXPECT_EQ(folder.count(), 1U);
    drawn->bytes = read_text(folder / "p.png");
    drawn->reader->SetFileName((folder / "p.png").c_str());
    drawn->reader->Update();
    return drawn;
}

Plot one_curve(std::vector<double> x, std::vector<double> y) {
    return {"", {"time", "s", false}, {"energy", "J", false}, {{"energy", std::move(x), std::move(y), 0}}, 1200, 800};
}

TEST(Figure, HasTheSizeAndAWhiteBackground) {
    for (const auto& [width, height] : {std::pair{600, 400}, {1200, 800}, {200, 200}, {301, 977}}) {
        Plot plot = one_curve({0, 1, 2}, {1, 3, 2});
        plot.width = width;
        plot.height = height;
        const auto drawn = draw(plot);
        EXPECT_EQ(drawn->width(), width);
        EXPECT_EQ(drawn->height(), height);
        EXPECT_EQ(drawn->at(0, 0), (Rgb{255, 255, 255}));
        EXPECT_LT(drawn->area.left, drawn->area.right);
        EXPECT_LE(drawn->area.right, width);
        EXPECT_LE(drawn->area.top, height);
    }
}

TEST(Figure, AStraightLineIsWhereItShouldBe) {
    // y from 10 to 20: the axis is 4 % longer at both ends.
    const auto drawn = draw(one_curve({0, 4e-6}, {10e3, 20e3}));
    const PlotArea& area = drawn->area;
    const Rgb blue = body_colour(0);
    for (const double t : {0.1, 0.25, 0.5, 0.75, 0.9}) {
        const double x = area.left + t * (area.right - area.left);
        const double y = area.bottom + (0.04 + t) / 1.08 * (area.top - area.bottom);
        EXPECT_TRUE(drawn->near(x, y, blue)) << t;
        EXPECT_FALSE(drawn->near(x, y + 8, blue)) << t;
        EXPECT_FALSE(drawn->near(x, y - 8, blue)) << t;
    }
}

TEST(Figure, DashedCurvesHaveGaps) {
    Plot plot = one_curve({0, 1}, {1, 1});
    plot.curves.push_back({"two", {0, 1}, {2, 2}, 1});
    const auto drawn = draw(plot);
    const double length = drawn->area.right - drawn->area.left;
    const double width_of_line = 0.0035 * 800;
    EXPECT_GT(drawn->count(body_colour(0)), 0.9 * length); // a whole pixel of its width at least
    EXPECT_LT(drawn->count(body_colour(0)), 1.1 * length * std::ceil(width_of_line));
    // dash 5, gap 2.5 of the pattern
    const auto ratio = static_cast<double>(drawn->count(body_colour(1))) / drawn->count(body_colour(0));
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 0.85);
}

TEST(Figure, ThePeakOfManyRowsIsDrawn) {
    std::vector<double> x, y;
    for (int i = 0; i < 200000; ++i) {
        x.push_back(i);
        y.push_back(i == 123456 ? 10 : i == 50000 ? -10 : 0);
    }
    const auto drawn = draw(one_curve(x, y));
    const PlotArea& area = drawn->area;
    const auto height_of = [&](double v) { return area.bottom + (v + 10.8) / 21.6 * (area.top - area.bottom); };
    const auto across = [&](int i) { return area.left + i / 200000.0 * (area.right - area.left); };
    EXPECT_TRUE(drawn->near(across(123456), height_of(9.8), body_colour(0), 2));
    EXPECT_TRUE(drawn->near(across(50000), height_of(-9.8), body_colour(0), 2));
}

TEST(Figure, HardValuesAreDrawn) {
    const std::vector<double> x{0, 1, 2, 3};
    const std::vector<std::vector<double>> hard{
        {0, 0, 0, 0},
        {5, 5, 5, 5},
        {-5, -5, -5, -5},
        {1e-30, 2e-30, 3e-30, 2e-30},
        {1e30, -1e30, 2e30, 0},
        {1e308, -1e308, 1.7e308, 0},
        {5e-324, 1e-323, 0, 5e-324},
        {1, 1 + 2.3e-16, 1, 1},
        {1e6, 1e6 + 1e-5, 1e6, 1e6},
        {nan, 1, 2, nan},
        {1, inf, -inf, 2},
        {1, nan, 2, nan},
    };
    for (const std::vector<double>& y : hard)
        EXPECT_GT(draw(one_curve(x, y))->count(body_colour(0)), 8) << testing::PrintToString(y);
    // a table with one row is a dot, and without any nothing
    EXPECT_GT(draw(one_curve({0}, {1}))->count(body_colour(0)), 4);
    for (const auto& y : {std::vector<double>{}, {nan, inf}})
        EXPECT_EQ(draw(one_curve({0, 1}, y))->count(body_colour(0)), 0);
    for (const std::vector<double>& y : hard) { // and as the axis across, also logarithmic
        draw(one_curve(y, x));
        for (const bool logarithmic : {false, true}) {
            Plot plot = one_curve(y, y);
            plot.x.logarithmic = plot.y.logarithmic = logarithmic;
            draw(plot);
        }
    }
}

TEST(Figure, SameBytesEachTime) {
    Plot plot = one_curve({0, 1, 2}, {1, 5, 2});
    for (int i = 0; i < 8; ++i)
        plot.curves.push_back({"curve " + std::to_string(i), {0, 1, 2}, {5.0 - i, 1.0 * i, 3}, -1});
    const std::string first = draw(plot)->bytes;
    draw(one_curve({0, 1}, {0, 1}));
    EXPECT_TRUE(draw(plot)->bytes == first);
}

TEST(Figure, LegendLeavesCurvesFree) {
    // Two diagonals leave no corner; the legend goes to where none is.
    Plot plot = one_curve({0, 1}, {0, 1});
    plot.curves.push_back({"falling", {0, 1}, {1, 0}, 1});
    const auto with = draw(plot);
    for (PlotCurve& curve : plot.curves) curve.name = "";
    const auto without = draw(plot);
    if (with->area.right == without->area.right) {
        EXPECT_GE(with->count(body_colour(0)), without->count(body_colour(0)));
    }
    // Noise everywhere: beside the axes.
    PlotCurve noise{"noise", {}, {}, 2};
    for (int i = 0; i < 3000; ++i) noise.x.push_back(i / 3000.0), noise.y.push_back(i % 2);
    plot.curves.push_back(noise);
    EXPECT_LT(draw(plot)->area.right, without->area.right - 50);
}

std::vector<std::string> labels(const PlotAxis& axis, const std::vector<double>& values, bool margin = false) {
    const std::span<const double> span(values);
    std::vector<std::string> result{plot_scale(axis, {&span, 1}, {5, margin}).title};
    for (const PlotTick& tick : plot_scale(axis, {&span, 1}, {5, margin}).ticks) result.push_back(tick.label);
    return result;
}

TEST(PlotAxis, TicksAreFewAndUnitsReadable) {
    EXPECT_THAT(labels({"time", "s"}, {0, 15e-6}), ElementsAre("time (µs)", "0", "5", "10", "15"));
    EXPECT_THAT(labels({"time", "s"}, {0, 1.999}), ElementsAre("time (s)", "0.0", "0.5", "1.0", "1.5", "2.0"));
    EXPECT_THAT(labels({"time", "s"}, {0, 4000}), ElementsAre("time (s)", "0", "1000", "2000", "3000", "4000"));
    EXPECT_THAT(labels({"stress", "Pa"}, {-2e9, 1e9}), ElementsAre("stress (GPa)", "-2", "-1", "0", "1"));
    EXPECT_THAT(labels({"area", "m²"}, {0, 4e-6}), ElementsAre("area (mm²)", "0", "1", "2", "3", "4"));
    EXPECT_THAT(labels({"energy", "J"}, {0, 3e-30}), ElementsAre("energy (1e-30 J)", "0", "1", "2", "3"));
    EXPECT_THAT(labels({"energy", "J"}, {0, 2e30}), ElementsAre("energy (1e30 J)", "0.0", "0.5", "1.0", "1.5", "2.0"));
    EXPECT_THAT(labels({"step", ""}, {0, 20000}), ElementsAre("step", "0", "5000", "10000", "15000", "20000"));
    EXPECT_THAT(labels({"energy", "J"}, {0, 0}), ElementsAre("energy (J)", "-1.0", "-0.5", "0.0", "0.5", "1.0"));
    EXPECT_THAT(labels({"energy", "J"}, {nan, inf}), ElementsAre("energy (J)", "-1.0", "-0.5", "0.0", "0.5", "1.0"));
}

TEST(PlotAxis, LogarithmicTicksAreAtPowersOfTen) {
    EXPECT_THAT(labels({"energy", "J", true}, {1e-6, 1e-2}),
                ElementsAre("energy (J)", "1e-6", "1e-5", "1e-4", "0.001", "0.01"));
    EXPECT_THAT(labels({"energy", "J", true}, {3, 4}), ElementsAre("energy (J)", "1", "2", "5", "10"));
    EXPECT_LE(labels({"energy", "J", true}, {1e-300, 1e300}).size(), 7U);
    const std::vector<double> values{1e-2, 1, 100, -5, 0};
    const std::span<const double> span(values);
    const PlotScale scale = plot_scale({"", "", true}, {&span, 1}, {});
    EXPECT_NEAR(scale.fraction(1), 0.5, 1e-15);
    EXPECT_TRUE(std::isnan(scale.fraction(0)));
    EXPECT_TRUE(std::isnan(scale.fraction(-5)));
}

TEST(PlotAxis, ValuesHaveTheirFraction) {
    const std::vector<double> values{-3e-6, 5e-6};
    const std::span<const double> span(values);
    const PlotScale scale = plot_scale({"time", "s"}, {&span, 1}, {});
    EXPECT_NEAR(scale.fraction(-3e-6), 0, 1e-15);
    EXPECT_NEAR(scale.fraction(1e-6), 0.5, 1e-12);
    EXPECT_NEAR(scale.fraction(5e-6), 1, 1e-12);
    for (const PlotTick& tick : scale.ticks)
        EXPECT_NEAR(tick.fraction, scale.fraction(std::stod(tick.label) * 1e-6), 1e-12);
}

TEST(PlotCurves, FewPointsKeepTheExtremesOfEachColumn) {
    PlotCurve curve;
    for (int i = 0; i < 100000; ++i) {
        curve.x.push_back(i);
        curve.y.push_back(std::sin(0.7 * i) * (i % 997));
    }
    const std::span<const double> xs(curve.x), ys(curve.y);
    const PlotScale x = plot_scale({}, {&xs, 1}, {}), y = plot_scale({}, {&ys, 1}, {});
    const PlotArea area{100, 50, 300, 250};
    const auto runs = curve_pixels(curve, x, y, area);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_LE(runs[0].size(), 4U * 201);
    std::vector<double> lowest(201, inf), highest(201, -inf), shown_lowest(201, inf), shown_highest(201, -inf);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const auto column = static_cast<std::size_t>(200 * x.fraction(curve.x[i]));
        const double up = 50 + 200 * y.fraction(curve.y[i]);
        lowest[column] = std::min(lowest[column], up);
        highest[column] = std::max(highest[column], up);
    }
    for (const Pixel& p : runs[0]) {
        const auto column = static_cast<std::size_t>(p[0] - 100);
        shown_lowest[column] = std::min(shown_lowest[column], p[1]);
        shown_highest[column] = std::max(shown_highest[column], p[1]);
    }
    for (std::size_t c = 0; c < 200; ++c) {
        EXPECT_NEAR(shown_lowest[c], lowest[c], 1e-9) << c;
        EXPECT_NEAR(shown_highest[c], highest[c], 1e-9) << c;
    }
}

TEST(PlotCurves, DashesKeepTheirLengthAroundCorners) {
    const std::vector<PixelRun> runs{{{0, 0}, {3, 0}, {3, 100}}};
    const std::vector<double> pattern{10, 5};
    const auto dashes = dashed(runs, pattern);
    ASSERT_EQ(dashes.size(), 7U); // 103 long: 6 times 15, then 10, then 3 of a gap
    double length = 0;
    for (const PixelRun& dash : dashes)
        for (std::size_t i = 0; i + 1 < dash.size(); ++i)
            length += std::hypot(dash[i + 1][0] - dash[i][0], dash[i + 1][1] - dash[i][1]);
    EXPECT_NEAR(length, 70, 1e-9);
    ASSERT_EQ(dashes[0].size(), 3U);
    EXPECT_EQ(dashes[0][1], (Pixel{3, 0}));
    EXPECT_NEAR(dashes[0][2][1], 7, 1e-12);
    EXPECT_EQ(dashed(runs, {}).size(), 1U);
}

TEST(PlotCurves, GapsSplitRuns) {
    const PlotCurve curve{"", {0, 1, 2, 3, 4, 5}, {1, nan, 2, 3, inf, 4}, 0};
    const std::span<const double> xs(curve.x), ys(curve.y);
    const auto runs = curve_pixels(curve, plot_scale({}, {&xs, 1}, {}), plot_scale({}, {&ys, 1}, {}), {0, 0, 100, 100});
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs[0].size(), 1U);
    EXPECT_EQ(runs[1].size(), 2U);
    EXPECT_TRUE(crosses(runs, {45, 45, 55, 60}));
    EXPECT_FALSE(crosses(runs, {10, 10, 30, 90}));
}

} // namespace
} // namespace abut::test

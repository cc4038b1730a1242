#include "io/render/plot.h"

#include "io/render/offscreen_context.h"
#include "io/render/plot_curves.h"
#include "io/render/plot_legend.h"
#include "io/render/renderer_png.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace abut {
namespace {

constexpr Rgb ink{40, 40, 40};

/// Dash patterns in widths of the line: curves differ also without colours.
const std::vector<std::vector<double>>& dash_patterns() {
    static const std::vector<std::vector<double>> patterns{
        {}, {5, 2.5}, {1.3, 1.7}, {7, 2, 1.3, 2}, {10, 3}, {7, 2, 1.3, 2, 1.3, 2}, {2.5, 2.5}};
    return patterns;
}

/// A curve in pixels with its look.
struct DrawnCurve {
    std::vector<PixelRun> runs; ///< before they are cut into dashes
    Rgb colour{};
    std::vector<double> pattern; ///< [pixels]
};

double font_size(const Plot& plot) {
    return std::max(9.0, std::round(0.03 * std::min(plot.width, plot.height)));
}

double line_width(const Plot& plot) {
    return std::max(1.0, 0.0035 * std::min(plot.width, plot.height));
}

std::vector<double> lengths_of_dashes(std::size_t curve, double width) {
    std::vector<double> lengths = dash_patterns()[curve % dash_patterns().size()];
    for (double& length : lengths) length *= width;
    return lengths;
}

// === Decisions

PlotScale scale_of(const Plot& plot, bool of_x) {
    std::vector<std::span<const double>> values;
    for (const PlotCurve& curve : plot.curves) values.emplace_back(of_x ? curve.x : curve.y);
    PlotAxisWishes wishes;
    // Widths of the longest usual label, and heights that look well.
    wishes.intervals = std::clamp(
        static_cast<int>(of_x ? plot.width / (7 * font_size(plot)) : plot.height / (4 * font_size(plot))), 2, 7);
    wishes.margin = !of_x;
    return plot_scale(of_x ? plot.x : plot.y, values, wishes);
}

double widest_label(const PlotScale& scale, double size) {
    double widest = 0;
    for (const PlotTick& tick : scale.ticks) widest = std::max(widest, text_width(tick.label, size));
    return widest;
}

/// The axes leave room for their labels and titles, and for `beside` to their right.
PlotArea area_of(const Plot& plot, const PlotScale& x, const PlotScale& y, double beside) {
    const double font = font_size(plot);
    const double last_label = x.ticks.empty() ? 0 : text_width(x.ticks.back().label, font) / 2 + 0.3 * font;
    PlotArea area;
    area.left = std::round(2.6 * font + widest_label(y, font));
    area.bottom = std::round(3.4 * font);
    area.right = std::round(plot.width - std::max(0.8 * font, last_label) - beside);
    area.top = std::round(plot.height - (plot.title.empty() ? 0.9 : 2.1) * font);
    area.right = std::max(area.right, area.left + 10);
    area.top = std::max(area.top, area.bottom + 10);
    return area;
}

std::vector<DrawnCurve> drawn_curves(const Plot& plot, const PlotScale& x, const PlotScale& y, const PlotArea& area) {
    std::vector<DrawnCurve> curves;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const PlotCurve& curve = plot.curves[i];
        curves.push_back({curve_pixels(curve, x, y, area),
                          body_colour(curve.colour < 0 ? static_cast<int>(i) : curve.colour),
                          lengths_of_dashes(i, line_width(plot))});
    }
    return curves;
}

// === Drawing with VTK; one unit of every chart is a pixel

/// A chart that puts whole-pixel coordinates where they are.
vtkSmartPointer<vtkChartXY> pixel_chart(const PlotArea& area) {
    auto chart = vtkSmartPointer<vtkChartXY>::New();
    chart->SetAutoSize(false);
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetSize(vtkRectf(static_cast<float>(area.left), static_cast<float>(area.bottom),
                            static_cast<float>(area.right - area.left), static_cast<float>(area.top - area.bottom)));
    chart->SetShowLegend(false);
    for (const int side : {vtkAxis::BOTTOM, vtkAxis::LEFT, vtkAxis::TOP, vtkAxis::RIGHT}) {
        vtkAxis& axis = *chart->GetAxis(side);
        const bool across = side == vtkAxis::BOTTOM || side == vtkAxis::TOP;
        axis.SetBehavior(vtkAxis::FIXED);
        axis.SetRange(across ? area.left : area.bottom, across ? area.right : area.top);
        axis.SetVisible(false);
        axis.SetGridVisible(false);
        axis.SetTitle("");
    }
    return chart;
}

void set_text(vtkTextProperty& property, double size) {
    property.SetFontFamilyToArial();
    property.SetFontSize(static_cast<int>(std::lround(size)));
    property.SetBold(false);
    property.SetColor(ink[0] / 255.0, ink[1] / 255.0, ink[2] / 255.0);
}

void show_axis(vtkAxis& axis, const PlotScale& scale, double lower, double upper, double font, double pen) {
    vtkNew<vtkDoubleArray> positions;
    vtkNew<vtkStringArray> labels;
    for (const PlotTick& tick : scale.ticks) {
        positions->InsertNextValue(lower + tick.fraction * (upper - lower));
        labels->InsertNextValue(tick.label);
    }
    axis.SetVisible(true);
    axis.SetTickLabelAlgorithm(vtkAxis::TICK_SIMPLE);
    axis.SetCustomTickPositions(positions, labels);
    axis.SetTickLength(static_cast<float>(0.35 * font));
    axis.SetLabelOffset(static_cast<float>(0.55 * font));
    axis.GetPen()->SetWidth(static_cast<float>(pen));
    axis.GetPen()->SetColor(ink[0], ink[1], ink[2], 255);
    set_text(*axis.GetLabelProperties(), font);
}

void add_line(vtkChartXY& chart, const std::vector<PixelRun>& runs, Rgb colour, double width) {
    vtkNew<vtkDoubleArray> x, y;
    x->SetName("x");
    y->SetName("y");
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    for (const PixelRun& run : runs) {
        if (x->GetNumberOfTuples() > 0) {
            x->InsertNextValue(gap);
            y->InsertNextValue(gap);
        }
        for (const Pixel& pixel : run) {
            x->InsertNextValue(pixel[0]);
            y->InsertNextValue(pixel[1]);
        }
    }
    if (x->GetNumberOfTuples() < 2) return;
    vtkNew<vtkTable> table;
    table->AddColumn(x);
    table->AddColumn(y);
    vtkNew<vtkPlotLine> line;
    line->SetInputData(table, 0, 1);
    line->SetMarkerStyle(vtkPlotPoints::NONE);
    line->GetPen()->SetColor(colour[0], colour[1], colour[2], 255);
    line->GetPen()->SetWidth(static_cast<float>(width));
    line->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    chart.AddPlot(line);
}

/// Points that no line goes to.
void add_dots(vtkChartXY& chart, const std::vector<PixelRun>& runs, Rgb colour, double diameter) {
    std::vector<PixelRun> dots;
    for (const PixelRun& run : runs)
        if (run.size() == 1) // a line as long as it is wide
            dots.push_back({{run[0][0] - diameter / 2, run[0][1]}, {run[0][0] + diameter / 2, run[0][1]}});
    add_line(chart, dots, colour, diameter);
}

void add_curve(vtkChartXY& chart, const DrawnCurve& curve, double width) {
    add_line(chart, dashed(curve.runs, curve.pattern), curve.colour, width);
    add_dots(chart, curve.runs, curve.colour, 3 * width);
}

vtkSmartPointer<vtkTextActor> text(const std::string& words, double left, double bottom, double size) {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetInput(words.c_str());
    set_text(*actor->GetTextProperty(), size);
    actor->SetDisplayPosition(static_cast<int>(std::lround(left)), static_cast<int>(std::lround(bottom)));
    return actor;
}

/// VTK would put them against the labels.
void add_axis_titles(vtkRenderer& renderer, const Plot& plot, const PlotScale& x, const PlotScale& y,
                     const PlotArea& area) {
    const double font = font_size(plot);
    renderer.AddViewProp(text(x.title, (area.left + area.right - text_width(x.title, font)) / 2, 0.45 * font, font));
    const auto upright = text(y.title, 1.45 * font, (area.bottom + area.top - text_width(y.title, font)) / 2, font);
    upright->GetTextProperty()->SetOrientation(90);
    renderer.AddViewProp(upright);
}

void add_legend(vtkRenderer& renderer, vtkChartXY& sheet, const Plot& plot, const std::vector<DrawnCurve>& curves,
                const PlotLegend& legend) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const double middle = legend.place.top - (static_cast<double>(i) + 0.5) * legend.line;
        DrawnCurve sample{{{{legend.place.left, middle}, {legend.place.left + legend.symbol, middle}}},
                          curves[i].colour,
                          curves[i].pattern};
        add_curve(sheet, sample, line_width(plot));
        renderer.AddViewProp(text(plot.curves[i].name, legend.place.left + legend.symbol + legend.space,
                                  middle - 0.55 * legend.font, legend.font));
    }
}

} // namespace

PlotArea write_plot(OffscreenContext& context, const Plot& plot, const std::filesystem::path& path) {
    const PlotScale x = scale_of(plot, true), y = scale_of(plot, false);
    PlotArea area = area_of(plot, x, y, 0);
    std::vector<DrawnCurve> curves = drawn_curves(plot, x, y, area);
    const double font = font_size(plot), width = line_width(plot);

    std::vector<std::string> names;
    std::vector<PixelRun> all;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        names.push_back(plot.curves[i].name);
        all.insert(all.end(), curves[i].runs.begin(), curves[i].runs.end());
    }
    PlotLegend legend = legend_size(names, 0.9 * font, plot.height - 4 * font);
    if (names.size() > 1 && !place_inside(legend, all, area)) {
        area = area_of(plot, x, y, legend.place.right - legend.place.left + font);
        curves = drawn_curves(plot, x, y, area);
        place_beside(legend, area);
    }

    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    const auto chart = pixel_chart(area);
    show_axis(*chart->GetAxis(vtkAxis::BOTTOM), x, area.left, area.right, font, 0.5 * width);
    show_axis(*chart->GetAxis(vtkAxis::LEFT), y, area.bottom, area.top, font, 0.5 * width);
    add_axis_titles(*renderer, plot, x, y, area);
    if (const double zero = y.fraction(0); zero > 0.02 && zero < 0.98) {
        const double at = std::round(area.bottom + zero * (area.top - area.bottom));
        add_line(*chart, {{{area.left, at}, {area.right, at}}}, {190, 190, 190}, 0.4 * width);
    }
    for (const DrawnCurve& curve : curves) add_curve(*chart, curve, width);

    // The legend may lie beside the axes: a sheet as large as the picture has its samples.
    const auto sheet = pixel_chart({0, 0, static_cast<double>(plot.width), static_cast<double>(plot.height)});
    if (names.size() > 1) add_legend(*renderer, *sheet, plot, curves, legend);
    if (!plot.title.empty()) renderer->AddViewProp(text(plot.title, area.left, area.top + 0.6 * font, font));
    if (all.empty())
        renderer->AddViewProp(
            text("no values", (area.left + area.right) / 2 - 2 * font, (area.bottom + area.top) / 2, font));
    for (const auto& layer : {chart, sheet}) {
        vtkNew<vtkContextActor> actor;
        actor->GetScene()->SetRenderer(renderer);
        actor->GetScene()->AddItem(layer);
        renderer->AddViewProp(actor);
    }
    write_renderer_png(context, *renderer, plot.width, plot.height, 8, path);
    return area;
}

} // namespace abut

#include "geometry/model_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace abut {

namespace {

constexpr std::size_t most_rows = 60;

std::string row(const BodyReport& body) {
    return fmt::format("{:<24} {:>10} {:>14.6g} {:>14.6g} {:>9.3f} {:>10.1f}\n", body.name, body.particles, body.exact,
                       body.content, 100 * body.difference(), body.thinnest);
}

} // namespace

std::string table_of(const ModelReport& report, std::size_t dimension) {
    const char* const unit = dimension == 3 ? "[m^3]" : "[m^2]";
    std::string text = fmt::format("{:<24} {:>10} {:>14} {:>14} {:>9} {:>10}\n", "", "",
                                   dimension == 3 ? "volume" : "area", "particles'", "differ-", "thinnest");
    text += fmt::format("{:<24} {:>10} {:>14} {:>14} {:>9} {:>10}\n", "body", "particles", unit, unit, "ence [%]",
                        "[cells]");
    for (std::size_t k = 0; k < std::min(most_rows, report.bodies.size()); ++k) text += row(report.bodies[k]);
    if (report.bodies.size() > most_rows) {
        const auto [least, most] = std::minmax_element(
            report.bodies.begin(), report.bodies.end(),
            [](const BodyReport& a, const BodyReport& b) { return a.difference() < b.difference(); });
        text += fmt::format("… and {} more; differences from {:.3f} to {:.3f} %\n", report.bodies.size() - most_rows,
                            100 * least->difference(), 100 * most->difference());
    }
    if (report.bodies.size() > 1) {
        BodyReport all{fmt::format("all {}", report.bodies.size()), 0, 0, 0, report.bodies.front().thinnest};
        for (const BodyReport& body : report.bodies) {
            all.particles += body.particles;
            all.content += body.content;
            all.exact += body.exact;
            all.thinnest = std::min(all.thinnest, body.thinnest);
        }
        text += row(all);
    }
    return text;
}

std::string size_advice(const Model& model, const GridSpec& grid) {
    constexpr double many = 100;
    Vector lower = model.position.at(0);
    Vector upper = lower;
    for (std::size_t p = 0; p < model.size(); ++p)
        for (std::size_t a = 0; a < 3; ++a) {
            lower[a] = std::min(lower[a], model.position[p][a] - model.half_size[p][a]);
            upper[a] = std::max(upper[a], model.position[p][a] + model.half_size[p][a]);
        }
    double ratio = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < 3; ++a)
        if (grid.upper[a] > grid.lower[a])
            ratio = std::min(ratio, (grid.upper[a] - grid.lower[a]) / (upper[a] - lower[a]));
    if (!(ratio >= many)) return {};
    return fmt::format("the grid is {:.0f} times larger than all bodies together: are their units right?", ratio);
}

std::vector<std::string> warnings_of(const ModelReport& report) {
    constexpr double enough = 2; // cells
    std::vector<const BodyReport*> thin;
    for (const BodyReport& body : report.bodies)
        if (body.thinnest < enough - 1e-6) thin.push_back(&body);
    if (thin.empty()) return {};
    std::sort(thin.begin(), thin.end(),
              [](const BodyReport* a, const BodyReport* b) { return a->thinnest < b->thinnest; });
    if (thin.size() == 1)
        return {fmt::format(
            "body \"{}\" is only {:.2g} cells wide at its thinnest; with less than two it bends and touches "
            "others poorly",
            thin[0]->name, thin[0]->thinnest)};
    return {
        fmt::format("{} bodies are less than two cells wide at their thinnest, \"{}\" only {:.2g}; they bend and touch "
                    "others poorly",
                    thin.size(), thin[0]->name, thin[0]->thinnest)};
}

} // namespace abut

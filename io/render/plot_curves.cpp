#include "io/render/plot_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace abut {
namespace {

/// Adds what shows the points [first, last) of `run`, all of one column of pixels.
void add_column(PixelRun& shown, const PixelRun& run, std::size_t first, std::size_t last) {
    std::array<std::size_t, 4> kept{first, first, first, last - 1};
    for (std::size_t i = first; i < last; ++i) {
        if (run[i][1] < run[kept[1]][1]) kept[1] = i;
        if (run[i][1] > run[kept[2]][1]) kept[2] = i;
    }
    std::sort(kept.begin(), kept.end());
    for (std::size_t k = 0; k < kept.size(); ++k)
        if (k == 0 || kept[k] != kept[k - 1]) shown.push_back(run[kept[k]]);
}

PixelRun decimated(const PixelRun& run) {
    PixelRun shown;
    for (std::size_t first = 0, last = 0; first < run.size(); first = last) {
        const double column = std::floor(run[first][0]);
        while (last < run.size() && std::floor(run[last][0]) == column) ++last;
        add_column(shown, run, first, last);
    }
    return shown;
}

/// Calls `at` along the run at every pixel or so.
template <class At>
bool any_along(const PixelRun& run, At at) {
    for (std::size_t i = 0; i < run.size(); ++i) {
        const Pixel& a = run[i];
        const Pixel& b = run[std::min(i + 1, run.size() - 1)];
        const int steps = 1 + static_cast<int>(std::hypot(b[0] - a[0], b[1] - a[1]));
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            if (at(Pixel{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])})) return true;
        }
    }
    return false;
}

} // namespace

std::vector<PixelRun> curve_pixels(const PlotCurve& curve, const PlotScale& x, const PlotScale& y,
                                   const PlotArea& area) {
    std::vector<PixelRun> runs(1);
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
        const double across = x.fraction(curve.x[i]), up = y.fraction(curve.y[i]);
        if (std::isnan(across) || std::isnan(up)) {
            if (!runs.back().empty()) runs.emplace_back();
            continue;
        }
        runs.back().push_back(
            {area.left + across * (area.right - area.left), area.bottom + up * (area.top - area.bottom)});
    }
    if (runs.back().empty()) runs.pop_back();
    for (PixelRun& run : runs) run = decimated(run);
    return runs;
}

std::vector<PixelRun> dashed(const std::vector<PixelRun>& runs, std::span<const double> pattern) {
    if (pattern.empty()) return runs;
    std::vector<PixelRun> dashes;
    for (const PixelRun& run : runs) {
        if (run.size() < 2) {
            dashes.push_back(run);
            continue;
        }
        std::size_t part = 0; // of the pattern; even ones are dashes
        double left = pattern[0];
        PixelRun dash{run.front()};
        for (std::size_t i = 0; i + 1 < run.size(); ++i) {
            const Pixel &a = run[i], &b = run[i + 1];
            const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
            double at = 0;
            while (length - at > left) {
                at += left;
                const Pixel point{a[0] + at / length * (b[0] - a[0]), a[1] + at / length * (b[1] - a[1])};
                dash.push_back(point);
                if (part % 2 == 0) dashes.push_back(dash);
                dash = {point};
                part = (part + 1) % pattern.size();
                left = pattern[part];
            }
            left -= length - at;
            dash.push_back(b);
        }
        if (part % 2 == 0) dashes.push_back(dash);
    }
    return dashes;
}

bool crosses(const std::vector<PixelRun>& runs, const PlotArea& rectangle) {
    const auto inside = [&](const Pixel& p) {
        return p[0] > rectangle.left && p[0] < rectangle.right && p[1] > rectangle.bottom && p[1] < rectangle.top;
    };
    return std::any_of(runs.begin(), runs.end(), [&](const PixelRun& run) { return any_along(run, inside); });
}

} // namespace abut

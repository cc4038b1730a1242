#include "io/render/series_source.h"

#include "io/results/read_frame.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

namespace abut {
namespace {

/// Edits (insert, remove, replace a letter) that turn one word into the other.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

} // namespace

PointFrame SeriesSource::particles(int index, const std::vector<std::string>& wanted) const {
    return read_points(folder / series.entries[static_cast<std::size_t>(index)].file, wanted);
}

PointFrame SeriesSource::contact(int index) const {
    const double time = series.entries[static_cast<std::size_t>(index)].time;
    const double tolerance = 1e-9 * std::abs(series.entries.back().time);
    for (const PvdEntry& entry : contacts->entries)
        if (std::abs(entry.time - time) <= tolerance) return read_points(folder / entry.file);
    return {time, {}, {{"normal", 3, std::vector<double>{}}, {"in_contact", 1, std::vector<std::int32_t>{}}}, {}, {}};
}

std::optional<Bounds> SeriesSource::grid_bounds() const {
    if (!std::filesystem::exists(folder / "grid.pvd")) return {};
    const PvdSeries grid_series = read_pvd(folder / "grid.pvd");
    if (grid_series.entries.empty()) return {};
    const GridFrame grid = read_grid(folder / grid_series.entries.front().file, {"none of the arrays"});
    Bounds bounds{grid.origin, grid.origin};
    for (std::size_t k = 0; k < 3; ++k) bounds.upper[k] += (grid.nodes[k] - 1) * grid.spacing[k];
    return bounds;
}

std::string SeriesSource::title() const {
    std::ifstream file(folder / "scene.json");
    const auto scene = nlohmann::json::parse(file, nullptr, false, true);
    if (!scene.is_object() || !scene.contains("title") || !scene["title"].is_string()) return {};
    return scene["title"].get<std::string>();
}

SeriesSource open_series(const std::filesystem::path& folder, bool with_contact) {
    if (!std::filesystem::is_directory(folder)) throw std::runtime_error(folder.string() + ": no such folder");
    if (!std::filesystem::exists(folder / "particles.pvd"))
        throw std::runtime_error(folder.string() + ": no particles.pvd; is it the result folder of a run?");
    SeriesSource source{folder, read_pvd(folder / "particles.pvd"), {}};
    if (source.series.entries.empty())
        throw std::runtime_error(source.series.path.string() + ": the series has no frames yet");
    if (with_contact) {
        if (!std::filesystem::exists(folder / "contact.pvd"))
            throw std::runtime_error(folder.string() + ": no contact.pvd, so no contact normals to draw");
        source.contacts = read_pvd(folder / "contact.pvd");
    }
    return source;
}

std::vector<std::string> array_names(const PointFrame& frame) {
    std::vector<std::string> names;
    for (const Array& array : frame.arrays) names.push_back(array.name);
    return names;
}

std::string no_such(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
    std::string message = fmt::format("no {} \"{}\"", what, name);
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
        return edit_distance(name, a) < edit_distance(name, b);
    });
    if (nearest != known.end() && edit_distance(name, *nearest) <= std::max<std::size_t>(2, name.size() / 3))
        message += fmt::format("; did you mean \"{}\"?", *nearest);
    return message + fmt::format(" (there are: {})", fmt::join(known, ", "));
}

} // namespace abut

#include "io/render/series_source.h"

#include "io/render/render_series.h"
#include "io/results/read_frame.h"
#include "io/results/vtk_end.h"
#include "scene/suggest.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace abut {
namespace {

void check_whole(const std::filesystem::path& path, int frame) {
    const auto fail = [&](const char* cause) {
        throw std::runtime_error(fmt::format("{}: cannot read: {} (frame {} of its series); nothing was drawn. "
                                             "--frames chooses others",
                                             path.string(), cause, frame));
    };
    if (!std::filesystem::is_regular_file(path)) fail("no such file");
    if (!std::ifstream(path)) fail("it can't be opened");
    if (!has_vtk_end(path)) fail("the file is cut off");
}

} // namespace

PointFrame SeriesSource::particles(int index, const std::vector<std::string>& wanted) const {
    return read_points(folder / series.entries[static_cast<std::size_t>(index)].file, wanted);
}

const PvdEntry* SeriesSource::contact_entry(int index) const {
    const double time = series.entries[static_cast<std::size_t>(index)].time;
    const double tolerance = 1e-9 * std::abs(series.entries.back().time);
    for (const PvdEntry& entry : contacts->entries)
        if (std::abs(entry.time - time) <= tolerance) return &entry;
    return nullptr;
}

PointFrame SeriesSource::contact(int index) const {
    return read_points(folder / contact_entry(index)->file);
}

void SeriesSource::check_files(const std::vector<int>& frames) const {
    for (const int index : frames) {
        check_whole(folder / series.entries[static_cast<std::size_t>(index)].file, index);
        if (!contacts) continue;
        if (const PvdEntry* entry = contact_entry(index)) check_whole(folder / entry->file, index);
    }
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
    if (!std::filesystem::is_directory(folder)) throw RenderRequestError(folder.string() + ": no such folder");
    if (!std::filesystem::exists(folder / "particles.pvd"))
        throw RenderRequestError(folder.string() + ": no particles.pvd; is it the result folder of a run?");
    SeriesSource source{folder, read_pvd(folder / "particles.pvd"), {}};
    if (source.series.entries.empty())
        throw RenderRequestError(source.series.path.string() + ": the series has no frames yet");
    if (with_contact) {
        if (!std::filesystem::exists(folder / "contact.pvd"))
            throw RenderRequestError(folder.string() + ": no contact.pvd, so no contact normals to draw");
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
    if (known.empty()) return fmt::format("no {} \"{}\": there are none", what, name);
    return fmt::format("no {} \"{}\"{} (there are: {})", what, name, did_you_mean(name, known), fmt::join(known, ", "));
}

} // namespace abut

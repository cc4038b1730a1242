#include "io/study/particle_frames.h"

#include "io/results/read_frame.h"
#include "io/study/reduce.h"
#include "results/arrays.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <stdexcept>

namespace abut {

namespace {

std::vector<std::string> suffixes(int components) {
    switch (components) {
    case 1:
        return {""};
    case 3:
        return {"_x", "_y", "_z"};
    case 6:
        return {"_xx", "_yy", "_zz", "_xy", "_yz", "_xz"}; // VTK's order
    default:
        return {"_xx", "_xy", "_xz", "_yx", "_yy", "_yz", "_zx", "_zy", "_zz"};
    }
}

} // namespace

PvdSeries particle_series(const std::filesystem::path& folder) {
    return read_pvd(folder / "particles.pvd");
}

const PvdEntry& frame_at(const PvdSeries& series, std::optional<double> time) {
    if (series.entries.empty()) throw NoValue("there is no frame of particles");
    if (!time) return series.entries.back();
    const double end = series.entries.back().time;
    if (*time > end && !same_time(*time, end))
        throw NoValue(fmt::format("its frames end at {:g} s, before {:g} s", end, *time));
    return *std::min_element(series.entries.begin(), series.entries.end(), [&](const PvdEntry& a, const PvdEntry& b) {
        return std::abs(a.time - *time) < std::abs(b.time - *time);
    });
}

PointFrame read_frame(const PvdSeries& series, const PvdEntry& entry, const std::vector<std::string>& wanted) {
    return read_points(series.path.parent_path() / entry.file, wanted);
}

double over_frames(const std::filesystem::path& folder, Reduction reduction, std::optional<double> at,
                   const std::vector<std::string>& wanted, const std::function<double(const PointFrame&)>& measure) {
    const PvdSeries series = particle_series(folder);
    const auto value_at = [&](const PvdEntry& entry) { return measure(read_frame(series, entry, wanted)); };
    if (at || reduction == Reduction::end) return value_at(frame_at(series, at));
    std::vector<double> times, values;
    for (const PvdEntry& entry : series.entries) {
        times.push_back(entry.time);
        values.push_back(value_at(entry));
    }
    if (values.empty()) throw NoValue("there is no frame of particles");
    Metric all;
    all.reduce = reduction;
    return reduce_in_time(all, times, values);
}

const Array& array_of(const PointFrame& frame, const std::string& name) {
    for (const Array& array : frame.arrays)
        if (array.name == name) return array;
    throw std::runtime_error(fmt::format("its particles have no array \"{}\"", name));
}

std::vector<double> component_of(const Array& array, int component) {
    std::vector<double> result;
    const auto stride = static_cast<std::size_t>(array.components);
    std::visit(
        [&](const auto& values) {
            for (auto i = static_cast<std::size_t>(component); i < values.size(); i += stride)
                result.push_back(static_cast<double>(values[i]));
        },
        array.values);
    return result;
}

std::vector<std::size_t> particles_of(const PointFrame& frame, const std::vector<std::string>& bodies) {
    std::vector<std::size_t> all(frame.points.size() / 3);
    std::iota(all.begin(), all.end(), 0);
    if (bodies.empty()) return all;
    const auto names = std::find_if(frame.words.begin(), frame.words.end(),
                                    [](const Words& words) { return words.name == "body_names"; });
    if (names == frame.words.end()) throw std::runtime_error("its particles have no names of bodies");
    const std::vector<double> body = component_of(array_of(frame, "body"), 0);
    std::vector<std::size_t> chosen;
    for (const std::size_t p : all) {
        const auto number = static_cast<std::size_t>(body.at(p));
        if (std::find(bodies.begin(), bodies.end(), names->values.at(number)) != bodies.end()) chosen.push_back(p);
    }
    return chosen;
}

std::vector<ParticleVariable> particle_variables(bool temperature, bool orientation) {
    std::vector<ParticleVariable> variables;
    for (int a = 0; a < 3; ++a) {
        variables.push_back({std::string(1, "XYZ"[a]), "", a});
        variables.push_back({std::string(1, "xyz"[a]), "", a});
    }
    variables.push_back({"t", "", 0});
    for (const ArrayInfo& info : particle_arrays()) {
        if ((info.name == "temperature" && !temperature) || (info.name == "orientation" && !orientation)) continue;
        const std::vector<std::string> ends = suffixes(info.components);
        for (int c = 0; c < info.components; ++c)
            variables.push_back(
                {std::string(info.name) + ends[static_cast<std::size_t>(c)], std::string(info.name), c});
    }
    return variables;
}

} // namespace abut

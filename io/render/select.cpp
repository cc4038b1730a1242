#include "io/render/select.h"

#include "io/render/domains.h"
#include "io/render/render_series.h"
#include "io/render/series_source.h"
#include "io/render/values.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace abut {
namespace {

/// Moves what is kept of tuples of `components` values to the front and cuts off the rest.
template <class Value>
void keep_tuples(std::vector<Value>& values, std::size_t components, const std::vector<std::size_t>& kept) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i)
        std::copy_n(&values[kept[i] * components], components, &values[i * components]);
    values.resize(kept.size() * components);
}

template <class IsKept>
void keep(PointFrame& frame, IsKept&& is_kept) {
    const std::size_t count = frame.points.size() / 3;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < count; ++i)
        if (is_kept(i)) kept.push_back(i);
    if (kept.size() == count) return;
    keep_tuples(frame.points, 3, kept);
    for (Array& array : frame.arrays)
        std::visit([&](auto& values) { keep_tuples(values, static_cast<std::size_t>(array.components), kept); },
                   array.values);
}

/// Whether a box about `point` that reaches so far meets the region, along the axes where it has an extent.
bool meets(const Bounds& region, const double* point, const Vector3& reach) {
    for (std::size_t k = 0; k < (region.flat() ? 2u : 3u); ++k)
        if (point[k] + reach[k] < region.lower[k] || point[k] - reach[k] > region.upper[k]) return false;
    return true;
}

/// Whether `body` is the group's name, a hyphen and digits.
bool is_of_group(const std::string& body, const std::string& group) {
    return body.size() > group.size() + 1 && body.starts_with(group) && body[group.size()] == '-' &&
           body.find_first_not_of("0123456789", group.size() + 1) == std::string::npos;
}

} // namespace

std::vector<std::string> bodies_named(const std::vector<std::string>& names, const std::vector<std::string>& known,
                                      const std::string& where) {
    std::vector<std::string> bodies;
    const auto add = [&](const std::string& body) {
        if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) bodies.push_back(body);
    };
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) {
            add(name);
            continue;
        }
        bool any = false;
        for (const std::string& body : known) {
            if (!is_of_group(body, name)) continue;
            add(body);
            any = true;
        }
        if (!any) throw RenderRequestError(fmt::format("{}: {}", where, no_such("body", name, known)));
    }
    return bodies;
}

std::set<int> body_numbers(const PointFrame& frame, const std::vector<std::string>& names, const std::string& where) {
    const auto words =
        std::find_if(frame.words.begin(), frame.words.end(), [](const Words& w) { return w.name == "body_names"; });
    if (words == frame.words.end() || !find_array(frame, "body"))
        throw RenderRequestError(where + ": the results don't tell the bodies of particles (array \"body\")");
    std::set<int> numbers;
    for (const std::string& body : bodies_named(names, words->values, where))
        numbers.insert(
            static_cast<int>(std::find(words->values.begin(), words->values.end(), body) - words->values.begin()));
    return numbers;
}

void check_region(const Bounds& region, const Bounds& box, bool all_there_is) {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, box.upper[k] - box.lower[k]);
    for (std::size_t k = 0; k < (region.flat() ? 2u : 3u); ++k) {
        const double lower = region.lower[k], upper = region.upper[k];
        if (all_there_is && (upper <= box.lower[k] || lower >= box.upper[k]))
            throw RenderRequestError(fmt::format("the region is outside the grid: {} from {} m to {} m, the grid from "
                                                 "{} m to {} m",
                                                 "xyz"[k], lower, upper, box.lower[k], box.upper[k]));
        if (size > 0 && upper - lower > 1e4 * size)
            throw RenderRequestError(fmt::format("the region is so large, {} from {} m to {} m, that nothing would be "
                                                 "seen of a scene of {} m",
                                                 "xyz"[k], lower, upper, size));
    }
}

Bounds region_of(const std::vector<double>& numbers, bool flat) {
    const std::size_t axes = flat ? 2 : 3;
    if (numbers.size() != 2 * axes)
        throw RenderRequestError(flat ? "the scene is plane: its region has 4 numbers, X0,Y0,X1,Y1"
                                      : "the scene has three dimensions: its region has 6 numbers, X0,Y0,Z0,X1,Y1,Z1");
    Bounds region;
    std::copy_n(numbers.begin(), axes, region.lower.begin());
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(axes), axes, region.upper.begin());
    return region;
}

void select_particles(PointFrame& frame, const Selection& selection) {
    if (const Array* body = find_array(frame, "body"); selection.bodies && body) {
        const std::vector<double> numbers = values_of(*body, -1);
        keep(frame, [&](std::size_t i) { return selection.bodies->count(static_cast<int>(numbers[i])) > 0; });
    }
    if (!selection.region) return;
    const Bounds& region = *selection.region;
    const std::optional<Domains> domains = region.flat() ? Domains::of(frame) : std::nullopt;
    keep(frame, [&](std::size_t i) {
        Vector3 reach{};
        if (domains)
            for (const Vector3& edge : domains->half_edges(i))
                for (std::size_t k = 0; k < 3; ++k) reach[k] += std::abs(edge[k]);
        return meets(region, &frame.points[3 * i], reach);
    });
}

void select_contacts(PointFrame& frame, const Selection& selection) {
    const Array *a = find_array(frame, "body_a"), *b = find_array(frame, "body_b");
    if (selection.bodies && a && b) {
        const std::vector<double> of_a = values_of(*a, -1), of_b = values_of(*b, -1);
        keep(frame, [&](std::size_t i) {
            return selection.bodies->count(static_cast<int>(of_a[i])) +
                       selection.bodies->count(static_cast<int>(of_b[i])) >
                   0;
        });
    }
    if (selection.region)
        keep(frame, [&](std::size_t i) { return meets(*selection.region, &frame.points[3 * i], {}); });
}

} // namespace abut

#include "scene/validate_parts.h"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

/// Times in ]0, end] between which ∫f is monotonous: the points of f, its changes of sign, and the end.
std::vector<double> turning_times(const TimeFunction& f, double end) {
    std::vector<double> times;
    for (std::size_t i = 0; i < f.time.size(); ++i) {
        if (i > 0 && f.value[i - 1] * f.value[i] < 0) {
            const double share = f.value[i - 1] / (f.value[i - 1] - f.value[i]);
            times.push_back(f.time[i - 1] + share * (f.time[i] - f.time[i - 1]));
        }
        times.push_back(f.time[i]);
    }
    std::erase_if(times, [end](double time) { return !(time > 0 && time < end); });
    times.push_back(end);
    return times;
}

/// When a wall leaves [lower, upper], widened by `tolerance`; nothing if it stays there up to the end.
std::optional<double> time_of_leaving(const WallSpec& wall, double lower, double upper, double tolerance, double end) {
    const auto inside = [&](double time, double margin) {
        const double position = wall.position + wall.velocity.integral(time);
        return position >= lower - margin && position <= upper + margin;
    };
    if (!(end > 0)) return {};
    double in = 0;
    for (double out : turning_times(wall.velocity, end)) {
        if (inside(out, tolerance)) {
            in = out;
            continue;
        }
        for (int i = 0; i < 30; ++i) { // to a part in 10^9
            const double middle = (in + out) / 2;
            (inside(middle, 0) ? in : out) = middle;
        }
        return in;
    }
    return {};
}

/// The checks of one boundary condition; one overload for each kind.
struct BoundaryCheck {
    const Scene& scene;
    const std::string pointer;
    Problems& problems;

    bool check_axis(int axis, const std::string& at) const {
        if (axis >= 0 && std::size_t(axis) < axes(scene)) return true;
        const char* all = "plane scenes have the axes x and y";
        if (scene.analysis == Analysis::axisymmetric) all = "axisymmetric scenes have the axes x (the radius) and y";
        if (scene.analysis == Analysis::three_d) all = "3d scenes have the axes x, y and z";
        problems.push_back({at + "/axis", all});
        return false;
    }

    void operator()(const WallSpec& wall) const {
        const std::string at = pointer + "/wall";
        if (!check_axis(wall.axis, at)) return;
        const double lower = scene.grid.lower[std::size_t(wall.axis)];
        const double upper = scene.grid.upper[std::size_t(wall.axis)];
        const double tolerance = place_rounding * (upper - lower);
        const std::string box = "the grid reaches from " + metres(lower) + " to " + metres(upper);
        if (!(wall.position >= lower - tolerance && wall.position <= upper + tolerance)) {
            problems.push_back({at + "/position", "outside the grid at " + metres(wall.position) + "; " + box});
        } else if (const auto time = time_of_leaving(wall, lower, upper, tolerance, scene.time.end)) {
            problems.push_back({at + "/velocity", "the wall moves out of the grid at t = " + with_unit(*time, "s") +
                                                      ", before the end; " + box});
        }
        demand(wall.depth >= 0, at + "/depth", "must not be negative", problems);
    }

    /// Whether the box is one, and meets the grid.
    void check_box(const Vector& lower, const Vector& upper, const std::string& at) const {
        for (std::size_t axis = 0; axis < axes(scene); ++axis) {
            const std::string along = std::string(" along ") + axis_names[axis];
            if (!(upper[axis] >= lower[axis])) {
                problems.push_back({at + "/upper", "must not lie below \"lower\"" + along});
                continue;
            }
            const double begin = scene.grid.lower[axis];
            const double end = scene.grid.upper[axis];
            const double tolerance = place_rounding * (end - begin);
            demand(upper[axis] >= begin - tolerance && lower[axis] <= end + tolerance, at,
                   "the box lies beside the grid" + along + ": it reaches from " + metres(lower[axis]) + " to " +
                       metres(upper[axis]) + ", the grid from " + metres(begin) + " to " + metres(end),
                   problems);
        }
    }

    void operator()(const VelocitySpec& velocity) const {
        const std::string at = pointer + "/velocity";
        check_box(velocity.lower, velocity.upper, at);
        const auto end = velocity.direction.begin() + std::ptrdiff_t(axes(scene));
        demand(std::any_of(velocity.direction.begin(), end, [](double component) { return component != 0; }),
               at + "/direction", "must not be zero", problems);
    }

    void operator()(const TractionSpec& traction) const {
        const std::string at = pointer + "/traction";
        check_axis(traction.axis, at);
        if (traction.within) check_box(traction.within->lower, traction.within->upper, at + "/within");
    }
};

} // namespace

void validate_boundaries(const Scene& scene, Problems& problems) {
    for (std::size_t i = 0; i < scene.boundaries.size(); ++i)
        std::visit(BoundaryCheck{scene, "/boundaries/" + std::to_string(i), problems}, scene.boundaries[i].condition);
}

} // namespace abut

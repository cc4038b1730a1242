#include "io/study/measures.h"
#include "io/study/particle_frames.h"
#include "io/study/reduce.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace abut {

namespace {

using Place = std::array<double, 3>;

/// Finds points by their places, which may be off by a small part of their distance.
class Places {
public:
    Places(const std::vector<Place>& points, double tolerance) : points_(points), tolerance_(tolerance) {
        for (std::size_t p = 0; p < points.size(); ++p) by_x_.emplace(points[p][0], p);
    }
    /// Nothing if no point is there.
    std::optional<std::size_t> at(const Place& place) const {
        const auto end = by_x_.upper_bound(place[0] + tolerance_);
        for (auto entry = by_x_.lower_bound(place[0] - tolerance_); entry != end; ++entry) {
            const Place& point = points_[entry->second];
            if (std::abs(point[1] - place[1]) <= tolerance_ && std::abs(point[2] - place[2]) <= tolerance_)
                return entry->second;
        }
        return {};
    }

private:
    const std::vector<Place>& points_;
    double tolerance_;
    std::multimap<double, std::size_t> by_x_;
};

/// Root of the sum of squares of the displacements less the mirrored ones, and of the displacements.
double asymmetry(const Metric& metric, const PointFrame& frame, double cell) {
    const Array& displacement = array_of(frame, "displacement");
    std::array<std::vector<double>, 3> moved;
    for (int a = 0; a < 3; ++a) moved[static_cast<std::size_t>(a)] = component_of(displacement, a);
    std::vector<Place> origins, moves;
    for (const std::size_t p : particles_of(frame, metric.bodies)) {
        Place& origin = origins.emplace_back();
        Place& move = moves.emplace_back();
        for (std::size_t a = 0; a < 3; ++a) {
            move[a] = moved[a][p];
            origin[a] = frame.points[3 * p + a] - move[a];
        }
    }
    if (origins.empty()) throw NoValue("there are no particles");
    const Places places(origins, 1e-3 * cell);
    const auto axis = static_cast<std::size_t>(metric.mirror);
    double differences = 0, all = 0;
    for (std::size_t p = 0; p < origins.size(); ++p) {
        Place image = origins[p];
        image[axis] = 2 * metric.plane - image[axis];
        const auto twin = places.at(image);
        if (!twin)
            throw NoValue(
                fmt::format("its particles are not symmetric at the start: none is the mirror image of that at "
                            "({:g}, {:g}, {:g}) m",
                            origins[p][0], origins[p][1], origins[p][2]));
        for (std::size_t a = 0; a < 3; ++a) {
            const double difference = moves[p][a] - (a == axis ? -1 : 1) * moves[*twin][a];
            differences += difference * difference;
            all += moves[p][a] * moves[p][a];
        }
    }
    if (!metric.scale.empty()) return std::sqrt(differences / static_cast<double>(origins.size()));
    return all > 0 ? std::sqrt(differences / all) : 0;
}

} // namespace

double measure_interpenetration(const Metric& metric, MeasuredRun& run) {
    if (run.columns.dimension == 3) throw NoValue("it isn't measured in 3D");
    if (!run.columns.contact) throw NoValue("the scene has no contact");
    return over_frames(run.folder, metric.reduce, metric.at, {"body"}, [](const PointFrame& frame) -> double {
        for (const Array& global : frame.globals)
            if (global.name == "interpenetration") return component_of(global, 0).at(0);
        throw NoValue("its frames don't tell it");
    });
}

double measure_symmetry(const Metric& metric, MeasuredRun& run) {
    const Scene& scene = run.variant.scene.scene;
    double cell = scene.grid.cell[0];
    for (int a = 1; a < dimension(scene.analysis); ++a)
        cell = std::min(cell, scene.grid.cell[static_cast<std::size_t>(a)]);
    const double value = over_frames(run.folder, metric.reduce, metric.at, {"displacement", "body"},
                                     [&](const PointFrame& frame) { return asymmetry(metric, frame, cell); });
    return value / scale_of(metric, run);
}

} // namespace abut

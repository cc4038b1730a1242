// The solid inside a closed mesh, by counting what a vertical line crosses.
//
// A line at (x, y) passes through a triangle if, seen from above, a ray from (x, y) towards larger x crosses an odd
// number of the triangle's edges. An edge is crossed if its ends lie on different sides of the ray (half-open: y0 <= y
// < y1) and the crossing lies beyond x. Whether it is depends on the edge and the line alone, not on the triangle: the
// test always starts from the end with the smaller y. Hence, for every line, the number of triangles it passes through
// is, modulo 2, the sum over all edges of (crossed) × (triangles at the edge), which is even for a closed mesh whatever
// round-off does: every line has an even number of crossings, also through edges, corners, and beside vertical faces,
// with no epsilon. What round-off can do is to see a line within round-off of an edge on its other side; heights then
// differ by as much as the edge's two triangles do there, as heights come from the crossed edges' own points.
#include "geometry/shapes/surface.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace abut {

namespace {

/// One triangle, corners in no particular order.
using Corners = std::array<Vector, 3>;

/// Where the line at (x, y) passes through a triangle. False if it doesn't.
bool crossing(const Corners& corners, double x, double y, double& z) {
    bool inside = false;
    std::array<double, 2> edge_x{}, edge_z{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector* a = &corners[i];
        const Vector* b = &corners[(i + 1) % 3];
        if (((*a)[1] <= y) == ((*b)[1] <= y)) continue;
        if ((*a)[1] > (*b)[1]) std::swap(a, b);
        const double run = (*b)[0] - (*a)[0], rise = (*b)[1] - (*a)[1], up = y - (*a)[1];
        // Beyond both ends is decided without arithmetic, so that no triangle is met outside its own box.
        const auto [least, most] = std::minmax((*a)[0], (*b)[0]);
        const bool beyond = x < least || (x < most && (x - (*a)[0]) * rise < run * up);
        inside ^= beyond;
        const double t = up / rise;
        edge_x[count] = (*a)[0] + t * run;
        edge_z[count] = (*a)[2] + t * ((*b)[2] - (*a)[2]);
        ++count;
    }
    if (!inside) return false;
    const double width = edge_x[1] - edge_x[0];
    const double t = width != 0 ? std::clamp((x - edge_x[0]) / width, 0.0, 1.0) : 0.5;
    z = edge_z[0] + t * (edge_z[1] - edge_z[0]);
    return true;
}

/// Triangles by the rectangles of a regular division of the plane that their boxes meet.
class Bins {
public:
    explicit Bins(const TriangleMesh& mesh) {
        corners_.reserve(mesh.triangles.size());
        for (const auto& triangle : mesh.triangles) {
            Corners& corners = corners_.emplace_back();
            for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.points[static_cast<std::size_t>(triangle[i])];
        }
        if (corners_.empty()) return;
        lower_ = upper_ = corners_.front().front();
        for (const Corners& corners : corners_)
            for (const Vector& point : corners)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    lower_[axis] = std::min(lower_[axis], point[axis]);
                    upper_[axis] = std::max(upper_[axis], point[axis]);
                }
        choose_counts();
        fill();
    }

    const Vector& lower() const { return lower_; }
    const Vector& upper() const { return upper_; }

    Spans spans(double x, double y) const {
        if (!(x >= lower_[0] && x <= upper_[0] && y >= lower_[1] && y <= upper_[1])) return {};
        const std::size_t bin = index(bin_of(x, 0), bin_of(y, 1));
        std::array<double, 32> few{};
        std::vector<double> many;
        std::size_t count = 0;
        for (std::size_t k = begins_[bin]; k < begins_[bin + 1]; ++k) {
            double z = 0;
            if (!crossing(corners_[entries_[k]], x, y, z)) continue;
            if (count == few.size()) many.assign(few.begin(), few.end());
            if (count >= few.size())
                many.push_back(z);
            else
                few[count] = z;
            ++count;
        }
        double* heights = many.empty() ? few.data() : many.data();
        std::sort(heights, heights + count);
        Spans spans;
        for (std::size_t k = 0; k + 1 < count; k += 2) {
            if (heights[k] == heights[k + 1]) continue;
            if (!spans.empty() && spans.back().to == heights[k])
                spans.back().to = heights[k + 1];
            else
                spans.push_back({heights[k], heights[k + 1]});
        }
        return spans;
    }

private:
    /// Never decreases with the coordinate: a line in a triangle's box is in one of the triangle's bins.
    std::size_t bin_of(double coordinate, std::size_t axis) const {
        const double bin = (coordinate - lower_[axis]) * per_length_[axis];
        return std::min(static_cast<std::size_t>(std::max(bin, 0.0)), counts_[axis] - 1);
    }
    std::size_t index(std::size_t i, std::size_t j) const { return j * counts_[0] + i; }

    std::array<std::array<std::size_t, 2>, 2> range(const Corners& corners) const {
        std::array<std::array<std::size_t, 2>, 2> bins{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
            bins[axis] = {bin_of(least, axis), bin_of(most, axis)};
        }
        return bins;
    }

    void set_counts(double bins) {
        std::array<double, 2> width{upper_[0] - lower_[0], upper_[1] - lower_[1]};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double other = width[1 - axis];
            const double ideal = width[axis] > 0 && other > 0 ? std::sqrt(bins * width[axis] / other) : 1;
            counts_[axis] = static_cast<std::size_t>(std::clamp(ideal, 1.0, std::max(1.0, bins)));
            per_length_[axis] = width[axis] > 0 ? static_cast<double>(counts_[axis]) / width[axis] : 0;
        }
    }

    /// About one bin for two triangles, fewer where triangles are so long that they would fill memory.
    void choose_counts() {
        const std::size_t most = 16 * corners_.size() + 1024;
        for (double bins = std::max(1.0, static_cast<double>(corners_.size()) / 2);; bins /= 4) {
            set_counts(bins);
            if (counts_[0] * counts_[1] == 1) return;
            std::size_t total = 0;
            for (const Corners& corners : corners_) {
                const auto bin = range(corners);
                total += (bin[0][1] - bin[0][0] + 1) * (bin[1][1] - bin[1][0] + 1);
                if (total > most) break;
            }
            if (total <= most) return;
        }
    }

    template <class Visit>
    void for_each_entry(Visit&& visit) const {
        for (std::size_t triangle = 0; triangle < corners_.size(); ++triangle) {
            const auto bin = range(corners_[triangle]);
            for (std::size_t j = bin[1][0]; j <= bin[1][1]; ++j)
                for (std::size_t i = bin[0][0]; i <= bin[0][1]; ++i) visit(index(i, j), triangle);
        }
    }

    void fill() {
        begins_.assign(counts_[0] * counts_[1] + 1, 0);
        for_each_entry([&](std::size_t bin, std::size_t) { ++begins_[bin + 1]; });
        for (std::size_t bin = 0; bin + 1 < begins_.size(); ++bin) begins_[bin + 1] += begins_[bin];
        entries_.resize(begins_.back());
        std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
        for_each_entry(
            [&](std::size_t bin, std::size_t triangle) { entries_[next[bin]++] = static_cast<unsigned>(triangle); });
    }

    std::vector<Corners> corners_;
    Vector lower_{}, upper_{};
    std::array<std::size_t, 2> counts_{1, 1};
    std::array<double, 2> per_length_{};
    std::vector<std::size_t> begins_{0, 0}; ///< of each bin's entries, and the end of the last
    std::vector<unsigned> entries_;         ///< triangles
};

/// Different coordinates of the points along an axis, ascending; none if they are too many to be worth it.
std::vector<double> breaks_along(const TriangleMesh& mesh, std::size_t axis) {
    constexpr std::size_t most = 200;
    std::vector<double> breaks;
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) {
            const double value = mesh.points[static_cast<std::size_t>(corner)][axis];
            const auto place = std::lower_bound(breaks.begin(), breaks.end(), value);
            if (place != breaks.end() && *place == value) continue;
            if (breaks.size() == most) return {};
            breaks.insert(place, value);
        }
    return breaks;
}

} // namespace

Solid solid_of(const TriangleMesh& mesh) {
    const auto bins = std::make_shared<const Bins>(mesh);
    Solid solid;
    solid.half_open = true;
    solid.lower = bins->lower();
    solid.upper = bins->upper();
    for (std::size_t axis = 0; axis < 2; ++axis) solid.breaks[axis] = breaks_along(mesh, axis);
    solid.spans = [bins](double x, double y) { return bins->spans(x, y); };
    return solid;
}

} // namespace abut

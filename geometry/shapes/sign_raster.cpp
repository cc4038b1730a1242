#include "geometry/shapes/sign_raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>

namespace abut {

namespace {

class Raster {
public:
    Raster(const std::function<double(const Vector&)>& value, const Vector& lower, const Vector& upper, double unit,
           int count)
        : value_(value), lower_(lower), upper_(upper), unit_(unit), count_(count),
          negative_(static_cast<std::size_t>(count) * count * count) {
        for (int k = 0; k < count; ++k)
            for (int j = 0; j < count; ++j)
                for (int i = 0; i < count; ++i) sample({i, j, k});
    }

    SignRaster result() {
        label_regions();
        SignRaster raster;
        const Vector step = spacing();
        const double cell = step[0] * step[1] * step[2];
        raster.volume = cell * static_cast<double>(std::count(negative_.begin(), negative_.end(), true));
        // Points of each piece of the surface (told by the regions on its two sides): one in each coarse box.
        std::map<std::pair<int, int>, std::pair<std::set<Place>, std::vector<Vector>>> pieces;
        std::size_t changes = 0;
        for_each_edge([&](const Place& a, const Place& b) {
            if (negative_[index(a)] == negative_[index(b)]) return;
            ++changes;
            const bool first = negative_[index(a)];
            const std::pair piece{region_[index(first ? a : b)], region_[index(first ? b : a)]};
            auto& [boxes, points] = pieces[piece];
            const int width = points.size() < few ? 1 : coarse;
            if (boxes.insert({a[0] / width, a[1] / width, a[2] / width}).second)
                points.push_back(surface_between(point(first ? a : b), point(first ? b : a)));
        });
        for (auto& [piece, found] : pieces)
            raster.points.insert(raster.points.end(), found.second.begin(), found.second.end());
        raster.doubt = cell * static_cast<double>(changes);
        return raster;
    }

private:
    using Place = std::array<int, 3>;
    static constexpr int coarse = 4;       ///< steps of the raster between points
    static constexpr std::size_t few = 12; ///< points of a piece that are taken wherever they are

    std::size_t index(const Place& p) const {
        return (static_cast<std::size_t>(p[2]) * count_ + static_cast<std::size_t>(p[1])) * count_ +
               static_cast<std::size_t>(p[0]);
    }
    Vector spacing() const {
        Vector step{};
        for (std::size_t axis = 0; axis < 3; ++axis) step[axis] = (upper_[axis] - lower_[axis]) / (count_ - 1);
        return step;
    }
    Vector point(const Place& p) const {
        Vector x{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double share = static_cast<double>(p[axis]) / (count_ - 1);
            x[axis] = (1 - share) * lower_[axis] + share * upper_[axis];
        }
        return x;
    }
    std::string text(const Vector& x) const {
        return fmt::format("x = {:.4g}, y = {:.4g}, z = {:.4g}", x[0] / unit_, x[1] / unit_, x[2] / unit_);
    }

    void sample(const Place& p) {
        const Vector x = point(p);
        const double value = value_(x);
        if (std::isnan(value)) throw std::runtime_error(fmt::format("is not a number at {}", text(x)));
        negative_[index(p)] = value < 0;
        if (!(value < 0)) return;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (p[axis] == 0 || p[axis] == count_ - 1)
                throw std::runtime_error(fmt::format("reaches out of its box at {} = {:.4g}: it is negative at {}",
                                                     "xyz"[axis], x[axis] / unit_, text(x)));
    }

    template <class Visit>
    void for_each_edge(Visit&& visit) const {
        for (int k = 0; k < count_; ++k)
            for (int j = 0; j < count_; ++j)
                for (int i = 0; i < count_; ++i)
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        const Place a{i, j, k};
                        Place b = a;
                        if (++b[axis] < count_) visit(a, b);
                    }
    }

    /// Numbers the connected regions of equal sign.
    void label_regions() {
        region_.assign(negative_.size(), -1);
        int regions = 0;
        std::vector<Place> open;
        for (int k = 0; k < count_; ++k)
            for (int j = 0; j < count_; ++j)
                for (int i = 0; i < count_; ++i) {
                    if (region_[index({i, j, k})] >= 0) continue;
                    region_[index({i, j, k})] = regions;
                    open.push_back({i, j, k});
                    while (!open.empty()) spread(open);
                    ++regions;
                }
    }
    void spread(std::vector<Place>& open) {
        const Place p = open.back();
        open.pop_back();
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                Place q = p;
                q[axis] += step;
                if (q[axis] < 0 || q[axis] >= count_ || region_[index(q)] >= 0 ||
                    negative_[index(q)] != negative_[index(p)])
                    continue;
                region_[index(q)] = region_[index(p)];
                open.push_back(q);
            }
    }

    Vector surface_between(Vector inside, Vector outside) const {
        Vector middle{};
        for (int step = 0; step < 50; ++step) {
            for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = (inside[axis] + outside[axis]) / 2;
            (value_(middle) < 0 ? inside : outside) = middle;
        }
        return middle;
    }

    const std::function<double(const Vector&)>& value_;
    Vector lower_, upper_;
    double unit_;
    int count_;
    std::vector<bool> negative_;
    std::vector<int> region_;
};

} // namespace

SignRaster sample_signs(const std::function<double(const Vector&)>& value, const Vector& lower, const Vector& upper,
                        double unit, int count) {
    return Raster(value, lower, upper, unit, count).result();
}

} // namespace abut

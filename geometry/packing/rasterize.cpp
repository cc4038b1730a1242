#include "geometry/packing/draw_grains.h"
#include "geometry/packing/ellipse_contact.h"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// The labels of one slice, with y up.
class Canvas {
public:
    Canvas(int width, int height) : width_(width), height_(height) {
        label_.resize(static_cast<std::size_t>(width) * height, 0);
    }

    void set(int right, int up, int label) {
        label_[static_cast<std::size_t>(height_ - 1 - up) * width_ + right] = label;
    }
    int column(double x) const { return std::clamp(static_cast<int>(std::floor(x)), 0, width_ - 1); }
    int row(double y) const { return std::clamp(static_cast<int>(std::floor(y)), 0, height_ - 1); }
    std::vector<int> take() { return std::move(label_); }

private:
    int width_, height_;
    std::vector<int> label_;
};

void draw(Canvas& canvas, const Ellipse& ellipse, int label) {
    const std::array<double, 2> extent = half_extent(ellipse);
    const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
    for (int up = canvas.row(ellipse.center[1] - extent[1]); up <= canvas.row(ellipse.center[1] + extent[1]); ++up)
        for (int right = canvas.column(ellipse.center[0] - extent[0]);
             right <= canvas.column(ellipse.center[0] + extent[0]); ++right) {
            const double x = right + 0.5 - ellipse.center[0], y = up + 0.5 - ellipse.center[1];
            const double u = (c * x + s * y) / ellipse.semi_axes[0], v = (c * y - s * x) / ellipse.semi_axes[1];
            if (u * u + v * v <= 1) canvas.set(right, up, label);
        }
}

/// Even-odd along each row of pixel centres.
void draw(Canvas& canvas, const Polygon& polygon, int label) {
    double lowest = polygon.points[0][1], highest = lowest;
    for (const PlanePoint& p : polygon.points) {
        lowest = std::min(lowest, p[1]);
        highest = std::max(highest, p[1]);
    }
    for (int up = canvas.row(lowest); up <= canvas.row(highest); ++up) {
        const double y = up + 0.5;
        std::vector<double> crossings;
        for (std::size_t k = 0; k < polygon.points.size(); ++k) {
            const PlanePoint &p = polygon.points[k], &q = polygon.points[(k + 1) % polygon.points.size()];
            if ((p[1] <= y) == (q[1] <= y)) continue;
            crossings.push_back(p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]));
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
            for (int right = canvas.column(crossings[k]); right <= canvas.column(crossings[k + 1]); ++right)
                if (right + 0.5 >= crossings[k] && right + 0.5 < crossings[k + 1]) canvas.set(right, up, label);
    }
}

void draw_disk(Canvas& canvas, const Vector& center, double square, int label) {
    const double radius = std::sqrt(square);
    for (int up = canvas.row(center[1] - radius); up <= canvas.row(center[1] + radius); ++up)
        for (int right = canvas.column(center[0] - radius); right <= canvas.column(center[0] + radius); ++right) {
            const double x = right + 0.5 - center[0], y = up + 0.5 - center[1];
            if (x * x + y * y <= square) canvas.set(right, up, label);
        }
}

} // namespace

std::vector<int> rasterize(const std::vector<ShapeSpec>& grains, int width, int height, int slice) {
    Canvas canvas(width, height);
    for (std::size_t k = 0; k < grains.size(); ++k) {
        const int label = static_cast<int>(k) + 1;
        if (const auto* ellipse = std::get_if<Ellipse>(&grains[k]))
            draw(canvas, *ellipse, label);
        else if (const auto* polygon = std::get_if<Polygon>(&grains[k]))
            draw(canvas, *polygon, label);
        else if (const auto* disk = std::get_if<Disk>(&grains[k]))
            draw_disk(canvas, disk->center, disk->radius * disk->radius, label);
        else if (const auto* ball = std::get_if<Ball>(&grains[k])) {
            const double z = slice + 0.5 - ball->center[2], square = ball->radius * ball->radius - z * z;
            if (square > 0) draw_disk(canvas, ball->center, square, label);
        }
    }
    return canvas.take();
}

} // namespace abut

// The path data of SVG 1.1, section 8.3.
#include "geometry/shapes/path_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace abut {

namespace {

PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) {
    return {a[0] + b[0], a[1] + b[1]};
}
PlanePoint mixed(const PlanePoint& a, const PlanePoint& b, double share) {
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}
double distance(const PlanePoint& a, const PlanePoint& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

constexpr std::size_t most_points = 10'000'000;

/// Reads the data letter by letter.
class Reader {
public:
    explicit Reader(const std::string& data) : data_(data) {}

    bool at_end() {
        skip();
        return at_ == data_.size();
    }
    bool at_command() {
        skip();
        return at_ < data_.size() && std::isalpha(static_cast<unsigned char>(data_[at_]));
    }
    char command() { return data_[at_++]; }
    double number() {
        skip();
        const char* first = data_.data() + at_;
        const char* const last = data_.data() + data_.size();
        if (first != last && *first == '+') ++first;
        double value = 0;
        const auto [end, error] = std::from_chars(first, last, value);
        if (error != std::errc() || !std::isfinite(value)) fail();
        at_ = static_cast<std::size_t>(end - data_.data());
        return value;
    }
    PlanePoint point() {
        const double x = number();
        return {x, number()};
    }
    /// 0 or 1, which need nothing between them and the next number.
    bool flag() {
        skip();
        if (at_ == data_.size() || (data_[at_] != '0' && data_[at_] != '1')) fail();
        return data_[at_++] == '1';
    }
    [[noreturn]] void fail() const {
        throw std::runtime_error(fmt::format("path data that can't be understood at \"{}\"", data_.substr(at_, 20)));
    }

private:
    void skip() {
        while (at_ < data_.size() && (std::isspace(static_cast<unsigned char>(data_[at_])) || data_[at_] == ',')) ++at_;
    }
    const std::string& data_;
    std::size_t at_ = 0;
};

class Pen {
public:
    explicit Pen(double chord_tolerance) : tolerance_(chord_tolerance) {}
    std::vector<Outline2D> outlines;
    bool open = false; ///< a subpath was neither closed nor ended where it began

    void move(const PlanePoint& to) {
        finish();
        here = start = to;
        current_.push_back(to);
    }
    void line(const PlanePoint& to) {
        if (current_.empty()) current_.push_back(here);
        // Short commands make many points: a file of 64 MiB could ask for more than memory holds.
        if (++points_ > most_points) throw std::runtime_error("path data of more than ten million points");
        current_.push_back(to);
        here = to;
    }
    void close() {
        finish(true);
        here = start;
    }
    void finish(bool closed = false) {
        if (current_.size() > 1) {
            Outline2D outline = without_slivers(current_);
            const bool back = distance(current_.front(), current_.back()) <= same_ * distance_across_;
            open = open || !(closed || back);
            outlines.push_back(std::move(outline));
        }
        current_.clear();
    }
    void cubic(const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
        const PlanePoint a = here;
        const double size = distance(a, b) + distance(b, c) + distance(c, d);
        // The chord of a piece of 1/n is off by at most |second derivative| / (8 n²); that is 6 max |second
        // difference|.
        const double second = 6 * std::max(std::hypot(a[0] - 2 * b[0] + c[0], a[1] - 2 * b[1] + c[1]),
                                           std::hypot(b[0] - 2 * c[0] + d[0], b[1] - 2 * c[1] + d[1]));
        const int pieces =
            size > 0 ? static_cast<int>(std::clamp(std::ceil(std::sqrt(second / (8 * tolerance_ * size))), 1.0, 1e5))
                     : 1;
        for (int k = 1; k <= pieces; ++k) {
            const double t = static_cast<double>(k) / pieces;
            const PlanePoint ab = mixed(a, b, t), bc = mixed(b, c, t), cd = mixed(c, d, t);
            line(k == pieces ? d : mixed(mixed(ab, bc, t), mixed(bc, cd, t), t));
        }
    }
    void quadratic(const PlanePoint& b, const PlanePoint& c) { // the same curve as a cubic
        const PlanePoint a = here;
        cubic(mixed(a, b, 2.0 / 3), mixed(c, b, 2.0 / 3), c);
    }
    /// From end points to centre: SVG 1.1, appendix F.6.
    void arc(double rx, double ry, double degrees, bool large, bool sweep, const PlanePoint& to) {
        rx = std::abs(rx);
        ry = std::abs(ry);
        if (rx == 0 || ry == 0 || to == here) return line(to);
        const double phi = degrees * std::numbers::pi / 180;
        const double c = std::cos(phi), s = std::sin(phi);
        const double dx = (here[0] - to[0]) / 2, dy = (here[1] - to[1]) / 2;
        const double x = c * dx + s * dy, y = c * dy - s * dx;
        const double excess = (x / rx) * (x / rx) + (y / ry) * (y / ry);
        if (excess > 1) {
            rx *= std::sqrt(excess);
            ry *= std::sqrt(excess);
        }
        const double a = rx * rx * ry * ry, b = rx * rx * y * y + ry * ry * x * x;
        const double root = std::sqrt(std::max(0.0, (a - b) / b)) * (large == sweep ? -1 : 1);
        const double cx = root * rx * y / ry, cy = -root * ry * x / rx;
        const PlanePoint middle{c * cx - s * cy + (here[0] + to[0]) / 2, s * cx + c * cy + (here[1] + to[1]) / 2};
        const double from = std::atan2((y - cy) / ry, (x - cx) / rx);
        double way = std::atan2((-y - cy) / ry, (-x - cx) / rx) - from;
        if (sweep && way < 0) way += 2 * std::numbers::pi;
        if (!sweep && way > 0) way -= 2 * std::numbers::pi;
        // A chord over the angle w is off by r w²/8.
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(way) / std::sqrt(8 * tolerance_))));
        for (int k = 1; k <= pieces; ++k) {
            const double angle = from + way * k / pieces;
            const double u = rx * std::cos(angle), v = ry * std::sin(angle);
            line(k == pieces ? to : middle + PlanePoint{c * u - s * v, s * u + c * v});
        }
    }

    PlanePoint here{}, start{};

private:
    static constexpr double same_ = 1e-9;
    double tolerance_;
    double distance_across_ = 0; ///< of the last subpath
    std::size_t points_ = 0;
    Outline2D current_;

    Outline2D without_slivers(const Outline2D& points) {
        distance_across_ = 0;
        for (const PlanePoint& point : points)
            distance_across_ = std::max(distance_across_, distance(point, points.front()));
        Outline2D result;
        for (const PlanePoint& point : points)
            if (result.empty() || distance(point, result.back()) > same_ * distance_across_) result.push_back(point);
        while (result.size() > 1 && distance(result.back(), result.front()) <= same_ * distance_across_)
            result.pop_back();
        return result;
    }
};

} // namespace

std::vector<Outline2D> svg_path_outlines(const std::string& data, double tolerance, bool* open) {
    Reader reader(data);
    Pen pen(tolerance);
    PlanePoint control{}; // of the curve before
    char command = 0, before = 0;
    while (!reader.at_end()) {
        if (reader.at_command())
            command = reader.command();
        else if (command == 0 || command == 'Z' || command == 'z')
            reader.fail();
        const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
        const PlanePoint origin = relative ? pen.here : PlanePoint{0, 0};
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
        if (before == 0 && kind != 'M') reader.fail();
        const auto reflected = [&](char same, char long_form) { // the control point of smooth curves
            if (before != same && before != long_form) return pen.here;
            return PlanePoint{2 * pen.here[0] - control[0], 2 * pen.here[1] - control[1]};
        };
        switch (kind) {
        case 'M':
            pen.move(origin + reader.point());
            command = relative ? 'l' : 'L'; // more points are lines
            break;
        case 'L':
            pen.line(origin + reader.point());
            break;
        case 'H':
            pen.line({origin[0] + reader.number(), pen.here[1]});
            break;
        case 'V':
            pen.line({pen.here[0], origin[1] + reader.number()});
            break;
        case 'C':
        case 'S': {
            const PlanePoint first = kind == 'C' ? origin + reader.point() : reflected('C', 'S');
            control = origin + reader.point();
            pen.cubic(first, control, origin + reader.point());
            break;
        }
        case 'Q':
        case 'T':
            control = kind == 'Q' ? origin + reader.point() : reflected('Q', 'T');
            pen.quadratic(control, origin + reader.point());
            break;
        case 'A': {
            const PlanePoint radii = reader.point();
            const double angle = reader.number();
            const bool large = reader.flag();
            const bool sweep = reader.flag();
            pen.arc(radii[0], radii[1], angle, large, sweep, origin + reader.point());
            break;
        }
        case 'Z':
            pen.close();
            break;
        default:
            throw std::runtime_error(fmt::format("unknown path command \"{}\"", command));
        }
        before = kind;
    }
    pen.finish();
    if (open) *open = pen.open;
    return pen.outlines;
}

} // namespace abut

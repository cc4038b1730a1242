#pragma once
#include "math/linear_algebra.h"

#include <algorithm>
#include <cmath>

namespace abut {

/// Separation of two bodies' edges along n, and its derivative by n (of the particles that are nearest).
template <int D>
struct Gap {
    double width = 0;
    Vec<D> slope = Vec<D>::Zero();
};

inline constexpr double largest_turn = 0.1; // tangent, of one turn
template <int D>
inline constexpr int turns = D == 2 ? 1 : 3;
/// How far from the normal the search may come, as a tangent: turns one after the other.
template <int D>
inline constexpr double most_turned = D == 2 ? largest_turn : 0.34;

/// The largest separation over planes that are turned a little from a normal.
///
/// The separation along any n is at most the distance of the bodies' convex hulls, which it equals for the one n that
/// points from the nearest place of the one to the nearest place of the other. A normal that is a degree off makes
/// bodies touch early, by the tilt times the width of the cloud: some hundredths of a cell. As a function of n,
///   δ(n) = min_b (x_b·n − R_b(n)) − max_a (x_a·n + R_a(n))
/// is concave, R being convex in n. So it is maximized along the steepest direction across n by cutting planes (its two
/// tangents' intersection is the next place to look at, and a bound for the maximum); in 3D a few times.
/// \param at   the gap along a vector n of any length
/// \param gap  at the normal
/// \param fine accuracy [m]
/// \param wide stops there: bodies are apart for certain [m]
/// \param direction takes the vector along which the gap is widest; null: not wanted, and then the search stops too
///   where bodies overlap for certain
template <int D, class At>
double widest_gap(const Vec<D>& normal, Gap<D> gap, double fine, double wide, At&& at, Vec<D>* direction = nullptr) {
    constexpr double turn = largest_turn;
    constexpr int lines = turns<D>;
    constexpr int cuts = 6;
    Vec<D> n = normal;
    double best = gap.width;
    for (int line = 0; line < lines && best < wide; ++line) {
        Vec<D> across = gap.slope - gap.slope.dot(n) * n;
        const double length = across.norm();
        if (!(length > 0) || (!direction && gap.width + turn * length < 0)) break; // overlap for certain
        across /= length;
        const Vec<D> from = n;
        const auto look = [&](double turned) { return at(Vec<D>(from + turned * across)); };
        double low = 0;
        double high = turn;
        Gap<D> left = gap;
        Gap<D> right = look(high);
        if (right.slope.dot(across) >= 0) {
            n = (from + high * across).normalized();
            gap = at(n);
            if (gap.width > best && direction) *direction = n;
            best = std::max(best, gap.width);
            continue;
        }
        double bound = 0;
        for (int cut = 0; cut < cuts; ++cut) {
            const double rise = left.slope.dot(across);
            const double fall = right.slope.dot(across);
            const double turned = (right.width - left.width + rise * low - fall * high) / (rise - fall);
            bound = left.width + rise * (turned - low);
            if (!(turned > low && turned < high)) break;
            const Gap<D> middle = look(turned);
            const double width = middle.width / std::hypot(1.0, turned);
            if (width > best) {
                best = width;
                n = (from + turned * across).normalized();
                if (direction) *direction = n;
            }
            if ((bound < 0 && !direction) || best > wide || middle.width > bound - fine) break;
            if (middle.slope.dot(across) > 0) {
                low = turned;
                left = middle;
            } else {
                high = turned;
                right = middle;
            }
        }
        if (bound < 0 && D == 2 && !direction) break;
        if (line + 1 < lines) gap = at(n);
    }
    return best;
}

} // namespace abut

#include "geometry/cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>

namespace abut {

namespace {

/// A line along the last axis: where it is, and what part of its column of places it stands for.
struct Line {
    double at = 0;     ///< [edges from the column's lower side]
    double weight = 0; ///< they add up to 1
};

/// Gauss' points between two ends, in as many equal pieces as their share of the column needs.
void add_gauss(std::vector<Line>& lines, double from, double to, int pieces_per_column) {
    // Three points integrate straight and round outlines alike; more pieces follow the kinks at the places' own edges.
    static const std::array<double, 3> points{-std::sqrt(0.6), 0, std::sqrt(0.6)};
    static const std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) * pieces_per_column)));
    const double piece = (to - from) / pieces;
    for (int k = 0; k < pieces; ++k)
        for (std::size_t q = 0; q < points.size(); ++q)
            lines.push_back({from + (k + 0.5 * (1 + points[q])) * piece, weights[q] * piece});
}

/// The lines of one column of places [lower, lower + edge] that integrate piece by piece between the breaks.
std::vector<Line> lines_across(double lower, double edge, const std::vector<double>& breaks, int pieces_per_column) {
    std::vector<Line> lines;
    double from = 0;
    for (auto next = std::upper_bound(breaks.begin(), breaks.end(), lower);
         next != breaks.end() && *next < lower + edge; ++next) {
        const double to = (*next - lower) / edge;
        if (!(to > from)) continue;
        add_gauss(lines, from, to, pieces_per_column);
        from = to;
    }
    add_gauss(lines, from, 1, pieces_per_column);
    return lines;
}

/// Places along an axis that the solid's box reaches.
struct Reach {
    std::int32_t first = 0, last = 0;
    std::int32_t count() const { return last - first + 1; }
};

Reach reach_of(const Solid& solid, const Lattice& lattice, std::size_t axis) {
    if (axis >= lattice.dimension) return {};
    const double slack = 1e-9 * lattice.edge[axis];
    return {lattice.place(axis, solid.lower[axis] - slack), lattice.place(axis, solid.upper[axis] + slack)};
}

/// Calls column(i, j, places) for every column of places (j is 0 in the plane) and gathers what they add, x fastest.
template <class Column>
std::vector<Covered> for_columns(const Solid& solid, const Lattice& lattice, Column&& column) {
    const std::size_t last_axis = lattice.dimension - 1;
    const Reach x = reach_of(solid, lattice, 0);
    const Reach y = lattice.dimension == 3 ? reach_of(solid, lattice, 1) : Reach{};
    const std::int64_t columns = std::int64_t{x.count()} * y.count();
    std::vector<std::vector<Covered>> of_column(static_cast<std::size_t>(columns));
    std::exception_ptr failed; // out of memory, say: loops of threads must not throw
#pragma omp parallel for schedule(dynamic, 16)
    for (std::int64_t c = 0; c < columns; ++c) try {
            column(x.first + static_cast<std::int32_t>(c % x.count()),
                   y.first + static_cast<std::int32_t>(c / x.count()), of_column[static_cast<std::size_t>(c)]);
        } catch (...) {
#pragma omp critical
            failed = std::current_exception();
        }
    if (failed) std::rethrow_exception(failed);
    // From columns along the last axis to rows along x.
    std::vector<Covered> places;
    std::size_t count = 0;
    for (const auto& each : of_column) count += each.size();
    places.reserve(count);
    std::vector<std::size_t> next(of_column.size(), 0);
    const Reach last = reach_of(solid, lattice, last_axis);
    for (std::int32_t l = last.first; l <= last.last; ++l)
        for (std::size_t c = 0; c < of_column.size(); ++c)
            while (next[c] < of_column[c].size() && of_column[c][next[c]].place[last_axis] <= l)
                places.push_back(of_column[c][next[c]++]);
    return places;
}

Place place_in(std::size_t dimension, std::int32_t i, std::int32_t j, std::int32_t along) {
    return dimension == 3 ? Place{i, j, along} : Place{i, along, 0};
}

} // namespace

Covered whole(const Lattice& lattice, const Place& place) {
    Covered covered{place, 1, lattice.centre(place), {}, 0};
    for (std::size_t a = 0; a < lattice.dimension; ++a) covered.variance[a] = lattice.edge[a] * lattice.edge[a] / 12;
    return covered;
}

Covered Moments::covered(const Lattice& lattice, const Place& place) const {
    Covered covered{place, std::min(1.0, content), {}, {}, 0};
    Vector mean{};
    for (std::size_t a = 0; a < lattice.dimension; ++a) {
        mean[a] = first[a] / content;
        covered.centre[a] = lattice.lower[a] + (place[a] + mean[a]) * lattice.edge[a];
        covered.variance[a] =
            std::max(0.0, second[a] / content - mean[a] * mean[a]) * lattice.edge[a] * lattice.edge[a];
    }
    covered.covariance = (mixed / content - mean[0] * mean[1]) * lattice.edge[0] * lattice.edge[1];
    return covered;
}

namespace {

/// A coordinate that is moved by round-off towards the middle of the solid: a line that would only touch the outline,
/// where it may meet a centre, then has a span there.
double moved_inwards(double x, const Solid& solid, const Lattice& lattice, std::size_t axis) {
    const double middle = (solid.lower[axis] + solid.upper[axis]) / 2;
    const double slack = 1e-9 * lattice.edge[axis];
    if (std::abs(x - middle) <= slack) return x;
    return x < middle ? x + slack : x - slack;
}

} // namespace

std::vector<Covered> places_by_centre(const Solid& solid, const Lattice& lattice) {
    const std::size_t along = lattice.dimension - 1;
    // Without it, round-off would take one of two mirror-image places on the outline and leave the other.
    const double slack = 1e-9 * lattice.edge[along];
    return for_columns(solid, lattice, [&](std::int32_t i, std::int32_t j, std::vector<Covered>& places) {
        std::int32_t next = std::numeric_limits<std::int32_t>::min();
        const auto moved = [&](double at, std::size_t axis) {
            return solid.half_open ? at + slack : moved_inwards(at, solid, lattice, axis);
        };
        const double x = moved(lattice.centre(0, i), 0);
        const double y = along == 2 ? moved(lattice.centre(1, j), 1) : 0;
        for (const Span& span : solid.spans(x, y)) {
            // The first place whose centre is not below the span, the last whose centre is not above it.
            const double origin = lattice.lower[along];
            const auto first =
                static_cast<std::int32_t>(std::ceil((span.from - slack - origin) / lattice.edge[along] - 0.5));
            const auto last = static_cast<std::int32_t>(
                std::floor((span.to + (solid.half_open ? -slack : slack) - origin) / lattice.edge[along] - 0.5));
            for (std::int32_t l = std::max(first, next); l <= last; ++l)
                places.push_back(whole(lattice, place_in(lattice.dimension, i, j, l)));
            next = std::max(next, last + 1);
        }
    });
}

std::vector<Covered> places_by_fraction(const Solid& solid, const Lattice& lattice) {
    const bool space = lattice.dimension == 3;
    const std::size_t along = lattice.dimension - 1;
    const int pieces = space ? 3 : 8;
    const Reach reach = reach_of(solid, lattice, along);
    return for_columns(solid, lattice, [&](std::int32_t i, std::int32_t j, std::vector<Covered>& places) {
        std::vector<Moments> moments(static_cast<std::size_t>(reach.count()));
        const double x0 = lattice.lower[0] + i * lattice.edge[0];
        const std::vector<Line> across_x = lines_across(x0, lattice.edge[0], solid.breaks[0], pieces);
        const double y0 = space ? lattice.lower[1] + j * lattice.edge[1] : 0;
        const std::vector<Line> across_y =
            space ? lines_across(y0, lattice.edge[1], solid.breaks[1], pieces) : std::vector<Line>{{0, 1}};
        for (const Line& line_y : across_y) {
            for (const Line& line_x : across_x) {
                const double weight = line_x.weight * line_y.weight;
                const Spans spans =
                    solid.spans(x0 + line_x.at * lattice.edge[0], space ? y0 + line_y.at * lattice.edge[1] : 0);
                for (const Span& span : spans) {
                    const double from = (span.from - lattice.lower[along]) / lattice.edge[along] - reach.first;
                    const double to = (span.to - lattice.lower[along]) / lattice.edge[along] - reach.first;
                    const int first = std::max(0, static_cast<int>(std::floor(from)));
                    const int last = std::min(reach.count() - 1, static_cast<int>(std::ceil(to)) - 1);
                    for (int l = first; l <= last; ++l) {
                        const double a = std::max(0.0, from - l);
                        const double b = std::min(1.0, to - l);
                        if (!(b > a)) continue;
                        Moments& m = moments[static_cast<std::size_t>(l)];
                        const double content = weight * (b - a);
                        const double middle = (a + b) / 2;
                        m.content += content;
                        m.first[along] += content * middle;
                        m.second[along] += content * (middle * middle + (b - a) * (b - a) / 12);
                        m.first[0] += content * line_x.at;
                        m.second[0] += content * line_x.at * line_x.at;
                        if (space) {
                            m.first[1] += content * line_y.at;
                            m.second[1] += content * line_y.at * line_y.at;
                        }
                        m.mixed += content * line_x.at * (space ? line_y.at : middle);
                    }
                }
            }
        }
        for (std::int32_t l = 0; l < reach.count(); ++l) {
            const Moments& m = moments[static_cast<std::size_t>(l)];
            if (m.content < least_fraction) continue;
            const Place place = place_in(lattice.dimension, i, j, reach.first + l);
            places.push_back(m.content > 1 - 1e-12 ? whole(lattice, place) : m.covered(lattice, place));
        }
    });
}

double content_of(const Solid& solid, std::size_t dimension, double spacing) {
    Lattice lattice{dimension, solid.lower, {}};
    for (std::size_t a = 0; a < dimension; ++a) {
        const double extent = std::max(solid.upper[a] - solid.lower[a], 1e-300);
        lattice.edge[a] = extent / std::ceil(extent / spacing);
    }
    lattice.edge[dimension - 1] = std::max(solid.upper[dimension - 1] - solid.lower[dimension - 1], 1e-300);
    double content = 0;
    for (const Covered& covered : places_by_fraction(solid, lattice)) content += covered.fraction;
    return content * lattice.content();
}

namespace {

/// The moments of two parts together.
Covered joined(const Covered& a, const Covered& b) {
    Covered both = a;
    both.fraction = a.fraction + b.fraction;
    const double share = b.fraction / both.fraction;
    Vector way{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        way[axis] = b.centre[axis] - a.centre[axis];
        both.centre[axis] = a.centre[axis] + share * way[axis];
        both.variance[axis] =
            (1 - share) * a.variance[axis] + share * b.variance[axis] + share * (1 - share) * way[axis] * way[axis];
    }
    both.covariance = (1 - share) * a.covariance + share * b.covariance + share * (1 - share) * way[0] * way[1];
    return both;
}

} // namespace

void join_slivers(std::vector<Covered>& places) {
    constexpr double thin = 0.1;
    const auto before = [](const Place& a, const Place& b) {
        return std::array{a[2], a[1], a[0]} < std::array{b[2], b[1], b[0]};
    };
    std::vector<char> gone(places.size(), 0);
    const auto find = [&](const Place& place) { // they are in rows along x
        const auto found = std::lower_bound(places.begin(), places.end(), place,
                                            [&](const Covered& c, const Place& p) { return before(c.place, p); });
        return found != places.end() && found->place == place ? static_cast<std::size_t>(found - places.begin())
                                                              : places.size();
    };
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k].fraction >= thin) continue;
        // Beside it across a face; only where there is none, as at corners, across an edge or a corner.
        std::array<std::size_t, 2> best{places.size(), places.size()};
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const Place& own = places[k].place;
                    const std::size_t beside = find({own[0] + dx, own[1] + dy, own[2] + dz});
                    if (beside == places.size() || gone[beside] || places[beside].fraction < thin) continue;
                    std::size_t& choice = best[std::abs(dx) + std::abs(dy) + std::abs(dz) == 1 ? 0 : 1];
                    if (choice == places.size() || places[beside].fraction > places[choice].fraction) choice = beside;
                }
        const std::size_t taker = best[0] < places.size() ? best[0] : best[1];
        if (taker == places.size()) continue;
        places[taker] = joined(places[taker], places[k]);
        gone[k] = 1;
    }
    std::size_t next = 0;
    for (std::size_t k = 0; k < places.size(); ++k)
        if (!gone[k]) places[next++] = places[k];
    places.resize(next);
}

PlacedParticle particle_of(const Covered& covered, const Lattice& lattice, bool turned) {
    if (covered.fraction == 1) return {lattice.centre(covered.place), lattice.half_size(), 0};
    PlacedParticle particle{covered.centre, {}, 0};
    Vector variance = covered.variance;
    Vector most = lattice.half_size();
    for (double& half : most) half *= std::max(1.0, covered.fraction); // a whole place with slivers is longer
    if (turned && lattice.dimension == 2) {
        // Principal axes of the second moments. The angle stays within 45 degrees, so that x remains x.
        const double half_difference = (variance[0] - variance[1]) / 2;
        const double radius = std::hypot(half_difference, covered.covariance);
        const double mean = (variance[0] + variance[1]) / 2;
        if (radius > 1e-9 * mean) {
            double angle = std::atan2(covered.covariance, half_difference) / 2;
            const bool exchanged = std::abs(angle) > std::numbers::pi / 4 + 1e-9;
            if (exchanged) angle -= std::copysign(std::numbers::pi / 2, angle);
            particle.angle = std::abs(angle) < 1e-9 ? 0 : angle;
            variance[exchanged ? 1 : 0] = mean + radius;
            variance[exchanged ? 0 : 1] = mean - radius;
            const double reach = std::hypot(most[0], most[1]);
            most = {reach, reach, most[2]};
        }
    }
    // Half edges of a box with these variances, scaled to the covered content; none longer than the place.
    double wanted = covered.fraction;
    for (std::size_t a = 0; a < lattice.dimension; ++a) wanted *= lattice.edge[a] / 2;
    double product = 1;
    for (std::size_t a = 0; a < lattice.dimension; ++a) {
        const double thinnest = 1e-6 * lattice.edge[a];
        particle.half_size[a] = std::max(std::sqrt(3 * std::max(0.0, variance[a])), thinnest);
        product *= particle.half_size[a];
    }
    const auto axes = static_cast<double>(lattice.dimension);
    for (int pass = 0; pass < 3; ++pass) { // what one axis must not take, the others do
        const double scale = std::pow(wanted / product, 1 / axes);
        product = 1;
        for (std::size_t a = 0; a < lattice.dimension; ++a) {
            particle.half_size[a] = std::min(particle.half_size[a] * scale, most[a]);
            product *= particle.half_size[a];
        }
    }
    // The last word has the content: on the axis that has the most room.
    std::size_t free = 0;
    for (std::size_t a = 1; a < lattice.dimension; ++a)
        if (particle.half_size[a] / most[a] < particle.half_size[free] / most[free]) free = a;
    particle.half_size[free] *= wanted / product;
    return particle;
}

} // namespace abut

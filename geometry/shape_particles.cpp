#include "geometry/shape_particles.h"

#include "grid/effective_cell.h"
#include "scene/turn.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abut {

namespace {

using Place = std::array<long, 3>;

/// Axes beyond its dimension have the one place 0 and no extent.
struct Lattice {
    std::size_t dimension = 2;
    Vector lower{}; ///< an outer corner of the lattice, not a centre [m]
    Vector edge{};  ///< of a particle [m]
    Vector cell{};  ///< of the grid [m]

    double centre(std::size_t axis, long place) const {
        return lower[axis] + (static_cast<double>(place) + 0.5) * edge[axis];
    }
    Vector half_size() const { return {edge[0] / 2, edge[1] / 2, edge[2] / 2}; }

    /// Calls visit(centre) for the places from `first` to `last`, both included.
    template <class Visit>
    void for_each(const Place& first, const Place& last, Visit&& visit) const {
        for (long k = first[2]; k <= last[2]; ++k)
            for (long j = first[1]; j <= last[1]; ++j)
                for (long i = first[0]; i <= last[0]; ++i) visit(Vector{centre(0, i), centre(1, j), centre(2, k)});
    }
};

Lattice particle_lattice(const GridSpec& grid, int particles_per_cell, std::size_t dimension) {
    const Vector cell = effective_cell(grid);
    Lattice lattice{dimension, {}, {}, cell};
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        lattice.lower[axis] = grid.lower[axis];
        lattice.edge[axis] = cell[axis] / particles_per_cell;
    }
    return lattice;
}

ShapeParticles fill(const Box& box, const Lattice& grid_lattice) {
    Lattice lattice{grid_lattice.dimension, {}, {}, {}};
    const Vector wanted = turned_cell(grid_lattice.edge, box.angle);
    const Vector widest = turned_cell(grid_lattice.cell, box.angle);
    Place last{};
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < lattice.dimension; ++axis) {
        const double edge = box.upper[axis] - box.lower[axis];
        // ugimp needs particles that are no wider than a cell, also where one particle a cell is rounded down.
        const long fewest = std::max(1L, static_cast<long>(std::ceil(edge / widest[axis] - 1e-9)));
        const long particles = std::max(fewest, std::lround(edge / wanted[axis]));
        lattice.lower[axis] = box.lower[axis];
        lattice.edge[axis] = edge / static_cast<double>(particles);
        last[axis] = particles - 1;
        count *= static_cast<std::size_t>(particles);
    }
    ShapeParticles particles{lattice.half_size(), {}, box.angle};
    particles.position.reserve(count);
    const Vector middle = center(box);
    lattice.for_each({}, last, [&](const Vector& x) {
        particles.position.push_back(box.angle == 0 ? x : turned_about(middle, x, box.angle));
    });
    return particles;
}

/// The places within `reach` of a centre for which inside(x, y, z) holds, where x, y, z are relative to that centre.
template <class Inside>
ShapeParticles fill_inside(const Vector& center, const Vector& reach, const Lattice& lattice, Inside&& inside) {
    Place first{}, last{};
    for (std::size_t axis = 0; axis < lattice.dimension; ++axis) {
        const double offset = center[axis] - lattice.lower[axis];
        first[axis] = std::lround((offset - reach[axis]) / lattice.edge[axis]) - 1;
        last[axis] = std::lround((offset + reach[axis]) / lattice.edge[axis]) + 1;
    }
    ShapeParticles particles{lattice.half_size(), {}, 0};
    lattice.for_each(first, last, [&](const Vector& x) {
        if (inside(x[0] - center[0], x[1] - center[1], x[2] - center[2])) particles.position.push_back(x);
    });
    return particles;
}

// Without it, round-off would take one of two mirror-image particles on the outline and leave the other.
constexpr double on_outline = 1 + 1e-9;

ShapeParticles fill(const Ellipse& ellipse, const Lattice& lattice) {
    const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
    const double a = ellipse.semi_axes[0], b = ellipse.semi_axes[1];
    const Vector reach{std::hypot(a * c, b * s), std::hypot(a * s, b * c), 0}; // of its bounding box
    return fill_inside(ellipse.center, reach, lattice, [&](double x, double y, double) {
        const double u = x * c + y * s;
        const double v = y * c - x * s;
        return (u / a) * (u / a) + (v / b) * (v / b) <= on_outline;
    });
}

ShapeParticles fill(const Disk& disk, const Lattice& lattice) {
    return fill(Ellipse{disk.center, {disk.radius, disk.radius}, 0}, lattice);
}

ShapeParticles fill(const Ball& ball, const Lattice& lattice) {
    const double r = ball.radius;
    return fill_inside(ball.center, {r, r, r}, lattice, [&](double x, double y, double z) {
        return (x / r) * (x / r) + (y / r) * (y / r) + (z / r) * (z / r) <= on_outline;
    });
}

template <class Other>
ShapeParticles fill(const Other&, const Lattice&) {
    return {};
}

} // namespace

bool exists_in(const ShapeSpec& shape, int dimension) {
    return std::holds_alternative<Box>(shape) || std::holds_alternative<Ball>(shape) == (dimension == 3);
}

ShapeParticles shape_particles(const ShapeSpec& shape, int particles_per_cell, const GridSpec& grid, int dimension) {
    if (!exists_in(shape, dimension)) throw std::invalid_argument("a shape of the other dimension");
    const Lattice lattice = particle_lattice(grid, particles_per_cell, static_cast<std::size_t>(dimension));
    return std::visit([&](const auto& each) { return fill(each, lattice); }, shape);
}

} // namespace abut

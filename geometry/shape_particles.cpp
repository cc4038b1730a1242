#include "geometry/shape_particles.h"

#include "grid/effective_cell.h"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

struct Lattice {
    Vector lower{}; ///< an outer corner of the lattice, not a centre [m]
    Vector edge{};  ///< of a particle [m]
    Vector cell{};  ///< of the grid [m]

    double centre(std::size_t axis, long place) const {
        return lower[axis] + (static_cast<double>(place) + 0.5) * edge[axis];
    }
};

Lattice particle_lattice(const GridSpec& grid, int particles_per_cell) {
    const Vector cell = effective_cell(grid);
    return {grid.lower, {cell[0] / particles_per_cell, cell[1] / particles_per_cell, 0}, cell};
}

ShapeParticles fill(const Box& box, const Lattice& grid_lattice) {
    Lattice lattice{box.lower, {}, {}};
    std::array<long, 2> count{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double edge = box.upper[axis] - box.lower[axis];
        // ugimp needs particles that are no wider than a cell, also where one particle a cell is rounded down.
        const long fewest = std::max(1L, static_cast<long>(std::ceil(edge / grid_lattice.cell[axis] - 1e-9)));
        count[axis] = std::max(fewest, std::lround(edge / grid_lattice.edge[axis]));
        lattice.edge[axis] = edge / static_cast<double>(count[axis]);
    }
    ShapeParticles particles;
    particles.half_size = {lattice.edge[0] / 2, lattice.edge[1] / 2, 0};
    particles.position.reserve(count[0] * count[1]);
    for (long j = 0; j < count[1]; ++j)
        for (long i = 0; i < count[0]; ++i)
            particles.position.push_back({lattice.centre(0, i), lattice.centre(1, j), 0});
    return particles;
}

ShapeParticles fill(const Ellipse& ellipse, const Lattice& lattice) {
    const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
    const auto [a, b] = ellipse.semi_axes;
    const std::array<double, 2> reach{std::hypot(a * c, b * s), std::hypot(a * s, b * c)}; // of its bounding box
    std::array<long, 2> first{}, last{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double offset = ellipse.center[axis] - lattice.lower[axis];
        first[axis] = std::lround((offset - reach[axis]) / lattice.edge[axis]) - 1;
        last[axis] = std::lround((offset + reach[axis]) / lattice.edge[axis]) + 1;
    }
    // Without it, round-off would take one of two mirror-image particles on the outline and leave the other.
    constexpr double on_outline = 1 + 1e-9;
    ShapeParticles particles;
    particles.half_size = {lattice.edge[0] / 2, lattice.edge[1] / 2, 0};
    for (long j = first[1]; j <= last[1]; ++j) {
        for (long i = first[0]; i <= last[0]; ++i) {
            const double x = lattice.centre(0, i), y = lattice.centre(1, j);
            const double u = (x - ellipse.center[0]) * c + (y - ellipse.center[1]) * s;
            const double v = (y - ellipse.center[1]) * c - (x - ellipse.center[0]) * s;
            if ((u / a) * (u / a) + (v / b) * (v / b) <= on_outline) particles.position.push_back({x, y, 0});
        }
    }
    return particles;
}

ShapeParticles fill(const Disk& disk, const Lattice& lattice) {
    return fill(Ellipse{disk.center, {disk.radius, disk.radius}, 0}, lattice);
}

} // namespace

ShapeParticles shape_particles(const std::variant<Box, Disk, Ellipse>& shape, int particles_per_cell,
                               const GridSpec& grid) {
    const Lattice lattice = particle_lattice(grid, particles_per_cell);
    return std::visit([&](const auto& each) { return fill(each, lattice); }, shape);
}

} // namespace abut

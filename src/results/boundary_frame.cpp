#include "results/boundary_frame.h"

#include <algorithm>

namespace abut {

namespace {

/// Cells with the values of their arrays.
struct Cells {
    CellFrame frame;
    std::vector<std::int32_t> boundary, axis;
    std::vector<double> velocity, traction;

    void add(const std::vector<Vector>& corners, int number, int across, const Vector& v, const Vector& t) {
        std::vector<std::int32_t> points;
        for (const Vector& corner : corners) {
            points.push_back(static_cast<std::int32_t>(frame.points.size() / 3));
            frame.points.insert(frame.points.end(), corner.begin(), corner.end());
        }
        frame.cells.push_back(std::move(points));
        boundary.push_back(number);
        axis.push_back(across);
        velocity.insert(velocity.end(), v.begin(), v.end());
        traction.insert(traction.end(), t.begin(), t.end());
    }
};

/// The corners of the part of a box that lies in a plane across an axis: 2 in the plane, 4 in order around it in space.
template <int D>
std::vector<Vector> cross_section(const Vector& lower, const Vector& upper, int axis, double position) {
    const auto corner = [&](bool b_upper, bool c_upper) {
        const int b = (axis + 1) % D, c = (axis + 2) % D; // c is the axis itself in the plane
        Vector x{};
        if (D == 3) x[c] = c_upper ? upper[c] : lower[c];
        x[b] = b_upper ? upper[b] : lower[b];
        x[axis] = position;
        return x;
    };
    if (D == 2) return {corner(false, false), corner(true, false)};
    return {corner(false, false), corner(true, false), corner(true, true), corner(false, true)};
}

template <int D>
void add_wall(Cells& cells, const State<D>& state, int number, const WallSpec& wall) {
    Vector velocity{};
    velocity[wall.axis] = wall.velocity.at(state.time);
    cells.add(cross_section<D>(to_array<D>(state.grid.lower()), to_array<D>(state.grid.upper()), wall.axis,
                               wall_position(wall, state.time)),
              number, wall.axis, velocity, {});
}

template <int D>
void add_velocity_condition(Cells& cells, const State<D>& state, int number, const VelocitySpec& condition) {
    const Vec<D> direction = to_vec<D>(condition.direction).normalized();
    const Vector velocity = to_array<D>(Vec<D>(condition.velocity.at(state.time) * direction));
    for (int axis = 0; axis < D; ++axis)
        for (int corner = 0; corner < (1 << D); ++corner) {
            if ((corner >> axis & 1) != 0) continue; // each edge once, from its lower end
            Vector from{};
            for (int a = 0; a < D; ++a) from[a] = (corner >> a & 1) != 0 ? condition.upper[a] : condition.lower[a];
            Vector to = from;
            to[axis] = condition.upper[axis];
            cells.add({from, to}, number, -1, velocity, {});
        }
}

template <int D>
void add_faces(Cells& cells, const State<D>& state, int number, const TractionSpec& condition) {
    std::vector<std::int32_t> by_id(state.particles.size());
    for (std::size_t p = 0; p < by_id.size(); ++p) by_id[state.particles.id[p]] = static_cast<std::int32_t>(p);
    Vec<D> traction;
    for (int a = 0; a < D; ++a) traction[a] = condition.traction[a].at(state.time);
    for (const TractionFace& face : state.traction_faces) {
        if (face.boundary != number) continue;
        const DeformedFace<D> shape =
            deformed_face(state.particles, by_id[face.id], face.axis, face.outward, false, 1.0);
        std::vector<Vector> corners;
        if constexpr (D == 2) {
            for (const double s : {-1.0, 1.0}) corners.push_back(to_array<D>(Vec<D>(shape.center + s * shape.edge[0])));
        } else {
            for (const auto& [s, t] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
                corners.push_back(to_array<D>(Vec<D>(shape.center + s * shape.edge[0] + t * shape.edge[1])));
        }
        const Vec<D> total = traction - condition.pressure.at(state.time) * shape.outward;
        cells.add(corners, number, face.axis, {}, to_array<D>(total));
    }
}

/// VTK numbers the lines of a surface before its polygons.
void put_lines_first(Cells& cells) {
    std::vector<std::size_t> order(cells.frame.cells.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t cell) { return cells.frame.cells[cell].size() == 2; });
    const auto reorder = [&](auto& values, std::size_t components) {
        std::remove_reference_t<decltype(values)> ordered;
        for (const std::size_t cell : order)
            for (std::size_t c = 0; c < components; ++c) ordered.push_back(std::move(values[cell * components + c]));
        values = std::move(ordered);
    };
    reorder(cells.frame.cells, 1);
    reorder(cells.boundary, 1);
    reorder(cells.axis, 1);
    reorder(cells.velocity, 3);
    reorder(cells.traction, 3);
}

} // namespace

template <int D>
CellFrame boundary_frame(const State<D>& state) {
    Cells cells;
    cells.frame.time = state.time;
    Words names{"boundary_names", {}};
    for (std::size_t i = 0; i < state.boundaries.size(); ++i) {
        const int number = static_cast<int>(i);
        const auto& condition = state.boundaries[i].condition;
        names.values.push_back(state.boundaries[i].name);
        if (const auto* wall = std::get_if<WallSpec>(&condition)) add_wall(cells, state, number, *wall);
        if (const auto* box = std::get_if<VelocitySpec>(&condition)) add_velocity_condition(cells, state, number, *box);
        if (const auto* faces = std::get_if<TractionSpec>(&condition)) add_faces(cells, state, number, *faces);
    }
    put_lines_first(cells);
    CellFrame frame = std::move(cells.frame);
    frame.arrays = {{"boundary", 1, std::move(cells.boundary), ""},
                    {"axis", 1, std::move(cells.axis), ""},
                    {"velocity", 3, std::move(cells.velocity), "m/s"},
                    {"traction", 3, std::move(cells.traction), "Pa"}};
    frame.words.push_back(std::move(names));
    return frame;
}

template CellFrame boundary_frame<2>(const State<2>&);
template CellFrame boundary_frame<3>(const State<3>&);

} // namespace abut

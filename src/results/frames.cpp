#include "results/frames.h"

#include "boundary/rigid_body.h"
#include "contact/contact_totals.h"
#include "contact/find_contacts.h"
#include "contact/group_view.h"
#include "results/frame_parts.h"
#include "step/tasks.h"

#include <map>
#include <set>
#include <tuple>

namespace abut {

namespace {

void append(std::vector<double>& values, const Vector& v) {
    values.insert(values.end(), v.begin(), v.end());
}

template <int D>
double point_area(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point,
                  const std::vector<Pack>& gradients) {
    return contact_area<D>(vector_of<D>(gradients[point.slot_a]),
                           vector_of<D>(sum_of_others(state.contact, group, point, gradients)), point.normal);
}

} // namespace

template <int D>
void look(State<D>& state) {
    const Contact<D> last = state.contact;
    find_velocity_fields(state);
    if (state.effects.stored_stencils) store_stencils(state);
    extrapolate_momenta_and_forces(state);
    find_velocities(state);
    state.nodes.end_velocity = state.nodes.velocity;
    if (!state.effects.contact) return;
    find_groups(state);
    if (state.effects.clouds) gather_clouds(state);
    if (state.effects.contact_fields()) extrapolate_contact_fields(state);
    if (state.effects.planes) {
        find_normals(state);
        find_separations(state);
    }
    if (state.effects.areas) find_areas_and_displacements(state);

    // Forces stay those of the last step; lumped points are apart from the pairs' of the same node.
    using PointKey = std::tuple<Index<D>, std::int32_t, std::int32_t, bool>;
    const auto key = [](const ContactGroup<D>& group, const ContactPoint<D>& point) {
        return PointKey{group.node, point.body_a, point.body_b, point.slot_b < 0};
    };
    std::map<PointKey, const ContactPoint<D>*> last_points;
    std::set<Index<D>> lumped;
    for (const ContactGroup<D>& group : last.groups) {
        for_each_point(last, group, [&](const ContactPoint<D>& point) { last_points[key(group, point)] = &point; });
        if (group.uses_lumped) lumped.insert(group.node);
    }
    for (ContactGroup<D>& group : state.contact.groups) {
        group.uses_lumped = group.first_lumped < group.last_lumped && lumped.count(group.node) > 0;
        for_each_point(state.contact, group, [&](ContactPoint<D>& point) {
            const auto found = last_points.find(key(group, point));
            if (found == last_points.end()) return;
            point.impulse = found->second->impulse;
            point.touching = found->second->touching;
        });
    }
}

template <int D>
GridFrame empty_grid_frame(const State<D>& state) {
    const Grid<D>& grid = state.grid;
    GridFrame frame;
    frame.time = state.time;
    for (int a = 0; a < D; ++a) {
        frame.nodes[a] = grid.cells[a] + 1;
        frame.origin[a] = grid.lower()[a];
        frame.spacing[a] = grid.cell[a];
    }
    return frame;
}

template <int D>
GridFrame grid_frame(const State<D>& state, const FrameChoice& choice) {
    GridFrame frame = empty_grid_frame(state);
    std::size_t n = 1;
    for (int a = 0; a < D; ++a) n *= frame.nodes[a];
    // Place of a node in the frame; n for the margin.
    const auto place = [&](const Index<D>& node) {
        std::size_t number = 0;
        for (int a = D - 1; a >= 0; --a) {
            const int i = node[a] - grid_margin;
            if (i < 0 || i >= frame.nodes[a]) return n;
            number = number * frame.nodes[a] + i;
        }
        return number;
    };
    std::vector<double> mass(n, 0), velocity(3 * n, 0);
    std::vector<std::int32_t> count(n, 0);
    for (const auto& block : state.fields.blocks)
        for (std::size_t local = 0; local < nodes_per_block<D>; ++local) {
            const std::size_t i = place(block.node(static_cast<int>(local)));
            if (i == n) continue;
            Pack momentum{};
            for (std::int32_t slot = block.first_slot[local]; slot < block.first_slot[local + 1]; ++slot) {
                const Pack v = state.nodes.end_velocity[slot];
                if (!(v[0] > 0) || is_rigid(state, state.fields.field[slot])) continue;
                mass[i] += v[0];
                momentum += v[0] * v;
                ++count[i];
            }
            for (int a = 0; a < 3 && mass[i] > 0; ++a) velocity[3 * i + a] = momentum[a + 1] / mass[i];
        }
    frame.arrays = {
        {"mass", 1, std::move(mass)}, {"velocity", 3, std::move(velocity)}, {"body_count", 1, std::move(count)}};
    if (state.effects.contact && (choice.wants("contact_normal") || choice.wants("contact_separation"))) {
        std::vector<double> normal(3 * n, 0), separation(n, 0);
        for (const ContactGroup<D>& group : state.contact.groups) {
            const std::size_t i = place(group.node);
            if (i == n) continue;
            const ContactPoint<D>& point = state.contact.points[group.first_point];
            const Vector v = to_array<D>(point.normal);
            std::copy(v.begin(), v.end(), normal.begin() + 3 * static_cast<std::ptrdiff_t>(i));
            separation[i] = point.separation;
        }
        frame.arrays.push_back({"contact_normal", 3, std::move(normal)});
        frame.arrays.push_back({"contact_separation", 1, std::move(separation)});
    }
    keep_wanted(frame.arrays, choice);
    frame.globals.push_back(step_number(state.step));
    return frame;
}

template <int D>
PointFrame contact_frame(State<D>& state, const FrameChoice& choice) {
    PointFrame frame;
    frame.time = state.time;
    const bool areas = choice.wants("area");
    std::vector<double> normal, separation, area, force;
    std::vector<std::int32_t> in_contact, body_a, body_b, cloud_size, iterations;
    const std::vector<Pack> gradients = areas ? volume_gradients(state) : std::vector<Pack>{};
    for (const ContactGroup<D>& group : state.contact.groups) {
        const Range points = points_in_use(group);
        for (std::int32_t i = points.first; i < points.last; ++i) {
            const ContactPoint<D>& point = state.contact.points[i];
            if (!choice.has(point.body_a) && !choice.has(point.body_b)) continue;
            append(frame.points, to_array<D>(state.grid.node_position(group.node)));
            append(normal, to_array<D>(point.normal));
            separation.push_back(point.separation);
            in_contact.push_back(!point.impulse.isZero(0));
            body_a.push_back(point.body_a);
            body_b.push_back(point.body_b);
            area.push_back(areas ? point_area(state, group, point, gradients) : 0);
            append(force, to_array<D>(state.dt > 0 ? Vec<D>(point.impulse / state.dt) : Vec<D>::Zero()));
            cloud_size.push_back(point.cloud_size);
            iterations.push_back(point.iterations);
        }
    }
    frame.arrays = {{"normal", 3, std::move(normal)},         {"separation", 1, std::move(separation)},
                    {"in_contact", 1, std::move(in_contact)}, {"body_a", 1, std::move(body_a)},
                    {"body_b", 1, std::move(body_b)},         {"area", 1, std::move(area)},
                    {"force", 3, std::move(force)},           {"cloud_size", 1, std::move(cloud_size)},
                    {"iterations", 1, std::move(iterations)}};
    keep_wanted(frame.arrays, choice);
    frame.globals.push_back(step_number(state.step));
    frame.words.push_back(body_names(state));
    return frame;
}

template void look<2>(State<2>&);
template void look<3>(State<3>&);
template GridFrame empty_grid_frame<2>(const State<2>&);
template GridFrame empty_grid_frame<3>(const State<3>&);
template GridFrame grid_frame<2>(const State<2>&, const FrameChoice&);
template GridFrame grid_frame<3>(const State<3>&, const FrameChoice&);
template PointFrame contact_frame<2>(State<2>&, const FrameChoice&);
template PointFrame contact_frame<3>(State<3>&, const FrameChoice&);

} // namespace abut

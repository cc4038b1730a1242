#include "step/check_state.h"

#include "boundary/rigid_body.h"
#include "plan/time_step.h"
#include "scene/suggest.h"
#include "step/step.h"
#include "step/tasks.h"

#include <algorithm>
#include <sstream>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

template <int D>
void check_time_step(const State<D>& state, Problems& problems) {
    const Scene& scene = state.scene;
    const double limit = cfl_limit(scene);
    const double crossing = crossing_time(state);
    const double cfl = scene.time.step ? *scene.time.step / crossing : std::min(scene.time.cfl, limit);
    if (cfl > limit) {
        std::ostringstream text;
        text << *scene.time.step << " s is above the stable step, " << limit * crossing << " s (" << limit
             << " cell / wave speed)";
        problems.push_back({"/time/step", text.str()});
    } else if (state.effects.periodic && *scene.method.transfer.every_cfl < cfl * (1 - 1e-9)) {
        std::ostringstream text;
        text << *scene.method.transfer.every_cfl << " is less than a time step, " << cfl
             << " cell / wave speed: every step would be one with this scheme; leave this key out for that";
        problems.push_back({"/method/transfer/every_cfl", text.str()});
    }
}

bool moves(const RigidSpec& rigid) {
    return !rigid.angular_velocity.is_zero() || !std::all_of(rigid.velocity.begin(), rigid.velocity.end(),
                                                             [](const TimeFunction& v) { return v.is_zero(); });
}

/// Whether anything in the scene but the wall itself could bring material to a wall that doesn't reach any.
template <int D>
bool anything_moves(const State<D>& state, std::int32_t wall_number) {
    const auto is_still = [](const InitialVelocity& v) { return v == InitialVelocity{{}, {}, v.center}; };
    if (state.effects.gravity || state.effects.tractions || state.effects.prestress) return true;
    if (!std::all_of(state.bodies.begin(), state.bodies.end(), [&](const ModelBody& body) {
            return is_still(body.velocity) && !(body.rigid && moves(*body.rigid));
        }))
        return true;
    return std::any_of(state.boundaries.begin(), state.boundaries.end(), [&](const Boundary& boundary) {
        if (&boundary == &state.boundaries[wall_number]) return false; // see approaches()
        const auto* wall = std::get_if<WallSpec>(&boundary.condition);
        const auto* box = std::get_if<VelocitySpec>(&boundary.condition);
        return (wall && !wall->velocity.is_zero()) || (box && !box->velocity.is_zero());
    });
}

/// Whether a wall comes nearer to the material in front of it at some time.
bool approaches(const WallSpec& wall) {
    return wall.side == Side::lower ? wall.velocity.largest() > 0 : wall.velocity.smallest() < 0;
}

template <int D>
void check_wall(const State<D>& state, const WallSpec& wall, std::int32_t number, Problems& problems) {
    const std::string pointer = "/boundaries/" + std::to_string(number) + "/wall";
    const double inward = wall.side == Side::lower ? 1 : -1;
    const auto behind = [&](const Vec<D>& x) { return (x[wall.axis] - wall.position) * inward < 0; };
    if (std::all_of(state.particles.position.begin(), state.particles.position.end(), behind)) {
        problems.push_back({pointer + "/side", "all material lies behind the wall, and would move with it; side \"" +
                                                   std::string(wall.side == Side::lower ? "upper" : "lower") +
                                                   "\" is meant?"});
        return;
    }
    const bool reaches = std::any_of(state.controls.begin(), state.controls.end(), [&](const Control& control) {
        return control.boundary == number && state.nodes.velocity[control.slot][0] > 0;
    });
    if (!reaches && !approaches(wall) && !anything_moves(state, number))
        problems.push_back({pointer,
                            "the wall grips nothing: no material is within its depth, and nothing in the scene "
                            "moves material or wall towards the other"});
}

/// Where a scene names a rigid body.
std::string pointer_of(const Scene& scene, const std::string& rigid_body) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].name == rigid_body) return "/bodies/" + std::to_string(i) + "/rigid";
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        for (std::size_t k = 0; k < scene.images[i].legend.size(); ++k)
            if (scene.images[i].legend[k].body == rigid_body)
                return "/images/" + std::to_string(i) + "/legend/" + std::to_string(k) + "/rigid";
    return "/bodies";
}

/// Rigid bodies that will leave the grid, as far as a hundred looks on the way show.
template <int D>
void check_rigid(const State<D>& state, Problems& problems) {
    constexpr int looks = 100;
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        const auto& rigid = state.bodies[b].rigid;
        if (!rigid || !moves(*rigid)) continue;
        std::vector<Vector> places;
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            if (state.particles.body[p] == static_cast<std::int32_t>(b))
                places.push_back(to_array<D>(state.particles.position[p]));
        for (int i = 0; i <= looks; ++i) {
            const double time = state.scene.time.end * i / looks;
            const RigidPose pose = rigid_pose(*rigid, time);
            if (std::all_of(places.begin(), places.end(),
                            [&](const Vector& x0) { return state.grid.contains(to_vec<D>(pose.position_of(x0))); }))
                continue;
            std::ostringstream text;
            text << "rigid body \"" << state.bodies[b].name << "\" moves out of the grid before t = " << time << " s";
            problems.push_back({pointer_of(state.scene, state.bodies[b].name), text.str()});
            break;
        }
    }
}

/// Which bodies an image gives is known only now.
void check_output_bodies(const std::vector<std::string>& names, const std::vector<ModelBody>& bodies,
                         Problems& problems) {
    std::vector<std::string> known;
    for (const ModelBody& body : bodies) known.push_back(body.name);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (std::none_of(bodies.begin(), bodies.end(), [&](const ModelBody& b) { return b.is_called(names[i]); }))
            problems.push_back({"/output/bodies/" + std::to_string(i),
                                "no body \"" + names[i] + "\"" + did_you_mean(names[i], known)});
}

} // namespace

template <int D>
std::vector<Problem> check_state(State<D>& state) {
    Problems problems;
    if (state.effects.rigid) check_rigid(state, problems);
    check_time_step(state, problems);
    for (std::size_t b = 0; b < state.boundaries.size(); ++b) {
        const auto* traction = std::get_if<TractionSpec>(&state.boundaries[b].condition);
        const bool has_face = std::any_of(state.traction_faces.begin(), state.traction_faces.end(),
                                          [&](const TractionFace& face) { return face.boundary == int(b); });
        if (traction && !has_face)
            problems.push_back({"/boundaries/" + std::to_string(b) + "/traction",
                                "body \"" + traction->body + "\" has no such face" +
                                    (traction->within ? " within the given box" : "")});
    }
    for (std::size_t b = 0; b < state.boundaries.size(); ++b) {
        const auto* box = std::get_if<VelocitySpec>(&state.boundaries[b].condition);
        if (!box) continue;
        const Window<D> nodes = nodes_in(*box, state.grid);
        for (int a = 0; a < D; ++a)
            if (nodes.lower[a] > nodes.upper[a]) {
                std::ostringstream text;
                text << "the box holds no node: along "
                     << "xyz"[a] << " nodes lie every " << state.grid.cell[a] << " m from " << state.grid.lower()[a]
                     << " m";
                problems.push_back({"/boundaries/" + std::to_string(b) + "/velocity", text.str()});
                break;
            }
    }
    check_output_bodies(state.scene.output.bodies, state.bodies, problems);
    if (!state.effects.velocity_conditions) return problems;
    find_velocity_fields(state);
    if (state.effects.stored_stencils) store_stencils(state);
    extrapolate_momenta(state);
    find_velocities(state);
    find_controls(state);
    for (std::size_t b = 0; b < state.boundaries.size(); ++b)
        if (const auto* wall = std::get_if<WallSpec>(&state.boundaries[b].condition))
            check_wall(state, *wall, static_cast<std::int32_t>(b), problems);
    return problems;
}

template std::vector<Problem> check_state<2>(State<2>&);
template std::vector<Problem> check_state<3>(State<3>&);

} // namespace abut

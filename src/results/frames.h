#pragma once
#include "results/frame.h"
#include "step/state.h"

#include <algorithm>
#include <string_view>

namespace abut {

/// Makes node and contact arrays fit the particles as they are now, without advancing them; call it before making
/// frames. Contact forces stay those of the last step. Running on afterwards gives the same results as if this had not
/// been called.
template <int D>
void look(State<D>& state);

/// What of the state a frame shows.
struct FrameChoice {
    std::vector<std::string> arrays; ///< names; empty: all of results/arrays.h that the state has
    std::vector<bool> bodies;        ///< by number; empty: all. Nodes are always those of all bodies

    bool wants(std::string_view array) const {
        return arrays.empty() || std::find(arrays.begin(), arrays.end(), array) != arrays.end();
    }
    bool has(std::int32_t body) const { return bodies.empty() || bodies[static_cast<std::size_t>(body)]; }
};

/// By number, whether a body is among OutputSpec::bodies: by its own name, or by that of an image's legend entry which
/// became several bodies, NAME-1, NAME-2 and so on. Empty: all are.
template <int D>
std::vector<bool> chosen_bodies(const State<D>& state);

/// The particles in the model's order (contract §3), that of their `id`.
template <int D>
PointFrame particle_frame(const State<D>& state, const FrameChoice& choice = {});

/// Nodes of the scene's box.
template <int D>
GridFrame grid_frame(const State<D>& state, const FrameChoice& choice = {});

/// The same nodes without any array: the grid of a scene that has not been run.
template <int D>
GridFrame empty_grid_frame(const State<D>& state);

/// A point for each pair of bodies at a contact node, normals and separations of the present particles, forces of
/// the last step. `area` is the node's share of the interface, ½ (g_a − g_b)·n with g the volume gradients (contact
/// paper Eq. 11): by the divergence theorem g_i is the integral of N_i n dS over a body's surface, so the areas add up
/// to the interface's. Pairs of which neither body is chosen are left out.
template <int D>
PointFrame contact_frame(State<D>& state, const FrameChoice& choice = {});

} // namespace abut

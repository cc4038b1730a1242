#pragma once
#include "step/state.h"

namespace abut {

// How the grid moves a particle: gather() adds up what a rule wants of the nodes, update() applies it (FMPM paper
// §2.3).

/// FLIP: V += S a Δt, X += S m^-1 p Δt + ½ S a Δt².
template <int D>
struct FlipMove {
    Pack change{};
    Pack end{};
    void gather(const NodeArrays<D>& nodes, std::int32_t slot, double S) {
        const Pack v = nodes.end_velocity[slot];
        change += S * (v - nodes.velocity[slot]);
        end += S * v;
    }
    void update(Vec<D>& V, Vec<D>& X, double dt) const {
        V += vector_of<D>(change);
        X += vector_of<D>(end - 0.5 * change) * dt;
    }
};

/// PIC: V = S v+. Position: see TransferSpec::position.
template <int D, bool FromEnd>
struct PicMove {
    Pack start{};
    Pack end{};
    void gather(const NodeArrays<D>& nodes, std::int32_t slot, double S) {
        if constexpr (!FromEnd) start += S * nodes.velocity[slot];
        end += S * nodes.end_velocity[slot];
    }
    void update(Vec<D>& V, Vec<D>& X, double dt) const {
        const Vec<D> next = vector_of<D>(end);
        if constexpr (FromEnd)
            X += next * dt;
        else
            X += (vector_of<D>(start) + 0.5 * (next - V)) * dt;
        V = next;
    }
};

/// XPIC(k): V = S (m_k^-1 p + m^-1 f Δt) (FMPM paper §2.3; with contact Eq. 5). Position: see TransferSpec::position.
template <int D, bool FromEnd>
struct XpicMove {
    Pack moving{};
    Pack updated{};
    void gather(const NodeArrays<D>& nodes, std::int32_t slot, double S) {
        const Pack start = nodes.velocity[slot];
        const Pack end = nodes.end_velocity[slot];
        moving += S * (FromEnd ? end : start);
        updated += S * (nodes.filtered[slot] + (end - start));
    }
    void update(Vec<D>& V, Vec<D>& X, double dt) const {
        const Vec<D> next = vector_of<D>(updated);
        if constexpr (FromEnd)
            X += vector_of<D>(moving) * dt;
        else
            X += (vector_of<D>(moving) + 0.5 * (next - V)) * dt;
        V = next;
    }
};

/// Leaves the particle where it is: the stress update of USF.
template <int D>
struct NoMove {
    void gather(const NodeArrays<D>&, std::int32_t, double) {}
    void update(Vec<D>&, Vec<D>&, double) const {}
};

} // namespace abut

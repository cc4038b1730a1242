#pragma once
#include "scene/scene.h"
#include "step/state.h"

namespace abut {

/// How the grid moves a particle. From the nodes the particle gets
///   E = S v+ (velocities at the end of the step, through the full mass matrix for FMPM), B = S v (at its beginning),
///   F = S m_k^-1 p (filtered, XPIC only),
/// and every rule (FMPM paper §2.3, Eq. 2) is a linear combination of them and its own velocity:
///   V' = v_V V + v_E E + v_B B + v_F F,   X' = X + Δt (x_V V + x_N V' + x_E E + x_B B).
struct MoveRule {
    double v_V = 0, v_E = 0, v_B = 0, v_F = 0;
    double x_V = 0, x_N = 0, x_E = 0, x_B = 0;

    bool needs_start() const { return v_B != 0 || x_B != 0; }
    bool needs_filtered() const { return v_F != 0; }
};

/// The rule of a scheme; PIC and FMPM differ in what E is.
/// \param transfers false: a FLIP step between those of the scheme
inline MoveRule move_rule(const TransferSpec& transfer, bool transfers) {
    if (!transfers || transfer.scheme == TransferScheme::flip) {
        // V' = V + S a Δt; X' = X + S m^-1 p Δt + ½ S a Δt², that is Δt ½ (B + E); or E Δt if that is asked for, as
        // "many codes use" it (FMPM paper §2.3).
        if (transfer.position == PositionUpdate::end_velocity) return {.v_V = 1, .v_E = 1, .v_B = -1, .x_E = 1};
        return {.v_V = 1, .v_E = 1, .v_B = -1, .x_E = 0.5, .x_B = 0.5};
    }
    MoveRule rule;
    rule.v_E = 1; // V' = E
    if (transfer.scheme == TransferScheme::xpic && transfer.order > 1) {
        rule.v_F = 1; // V' = S (m_k^-1 p + m^-1 f Δt) = F + E − B
        rule.v_B = -1;
    }
    switch (position_update(transfer)) {
    case PositionUpdate::end_velocity: // X' = X + E Δt
        rule.x_E = 1;
        break;
    case PositionUpdate::start_velocity: // X' = X + (B + ½ (V' − V)) Δt
        rule.x_B = 1;
        rule.x_N = 0.5;
        rule.x_V = -0.5;
        break;
    case PositionUpdate::mean_velocity: // X' = X + ½ (V + V') Δt
        rule.x_N = 0.5;
        rule.x_V = 0.5;
        break;
    }
    return rule;
}

} // namespace abut

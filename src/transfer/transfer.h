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

/// V' = V + S a Δt; X' = X + S m^-1 p Δt + ½ S a Δt², that is Δt ½ (B + E).
constexpr MoveRule flip_rule{.v_V = 1, .v_E = 1, .v_B = -1, .x_E = 0.5, .x_B = 0.5};

/// The rule of FLIP steps, also of those between steps of another scheme: first order in X if that is asked for ("many
/// codes use" it, FMPM paper §2.3).
inline MoveRule flip_rule_of(const TransferSpec& transfer) {
    MoveRule rule = flip_rule;
    if (transfer.position == PositionUpdate::end_velocity) {
        rule.x_E = 1;
        rule.x_B = 0;
    }
    return rule;
}

/// The rule of a scheme; PIC and FMPM differ in what E is.
inline MoveRule move_rule(const TransferSpec& transfer) {
    if (transfer.scheme == TransferScheme::flip) return flip_rule_of(transfer);
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

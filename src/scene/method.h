#pragma once
#include <optional>

namespace abut {

enum class ShapeKind { linear, ugimp, gimp, cpdi, b2spline, b2gimp, b2cpdi };
enum class TransferScheme { flip, pic, xpic, fmpm };

/// When stresses and strains are updated in a step (FMPM paper §2.3, task 5; notes 2.8).
enum class StressUpdate {
    usf,        ///< first: with the velocities at the start of the step
    usavg,      ///< half a step first and half a step last
    usl,        ///< last: with the velocities at the end of the step
    usl_plus,   ///< last, with the updated particle velocities extrapolated anew
    usavg_plus, ///< usavg with the last half as in usl_plus
};

/// How pic, xpic and fmpm move particles; the three rules are the three PIC methods of the FMPM paper's Eq. (2). flip
/// has its own second-order rule, or end_velocity.
enum class PositionUpdate {
    /// X += S v+ Δt: with the same grid velocities that deform the particle when stress is updated last. Positions and
    /// deformation gradients then stay together however far a body is deformed. "MPM PIC" of Eq. (2).
    end_velocity,
    /// X += [S m^-1 p + (V' − V)/2] Δt, as published for XPIC (FMPM paper §2.3). At walls, contacts and free edges the
    /// velocities at the start of a step are those of the last end smoothed once more by the extrapolation, so
    /// particles move by less than they deform: after large compression their domains leave cracks and overlaps.
    start_velocity,
    /// X += ½ (V + V') Δt, as published for FMPM (Table 1, task 4): the particle's own velocities. Only where the grid
    /// has filtered them (fmpm, pic).
    mean_velocity
};

struct TransferSpec {
    TransferScheme scheme = TransferScheme::flip;
    int order = 2;                          ///< k of xpic and fmpm; flip and pic have none
    std::optional<PositionUpdate> position; ///< not given: position_update()
    /// Time between two steps with pic, xpic or fmpm, in the unit of TimeSpec::cfl; those between are flip steps. Not
    /// given: every step.
    std::optional<double> every_cfl;
};

/// The rule by which particles move: as given, else mean_velocity for fmpm and end_velocity for pic and xpic.
inline PositionUpdate position_update(const TransferSpec& transfer) {
    return transfer.position.value_or(transfer.scheme == TransferScheme::fmpm ? PositionUpdate::mean_velocity
                                                                              : PositionUpdate::end_velocity);
}

/// What a step's velocity gradient makes of a particle: F ← dF F.
enum class DeformationIncrement {
    exponential, ///< dF = exp(∇v Δt), as published (FMPM paper Table 1, task 5): never turns a particle inside out
    /// dF = 1 + ∇v Δt, what a body undergoes whose points go straight by v Δt. With PositionUpdate::end_velocity and
    /// stress updated last, F is the gradient of the particles' own motion, to the last bit in a uniform gradient, so
    /// that a spinning body neither grows nor shrinks. In a spin by θ a step, exp(∇v Δt) has no stretch though
    /// particles come to lie √(1 + θ²) times as far out.
    linear
};

/// Where velocity conditions on nodes enter the full mass matrix calculation of fmpm (FMPM paper §2.4).
enum class VelocityConditions {
    combined, ///< before it, so that neighbours feel them, and after it, so that they hold
    velocity, ///< after it only
    lumped    ///< before it only
};

struct MethodSpec {
    ShapeKind shape = ShapeKind::cpdi;
    TransferSpec transfer;
    StressUpdate stress_update = StressUpdate::usl;
    DeformationIncrement deformation_increment = DeformationIncrement::exponential;
    VelocityConditions velocity_conditions = VelocityConditions::combined; ///< of fmpm
};

} // namespace abut

#pragma once
#include "step/state.h"

#include <string>
#include <vector>

namespace abut {

/// Totals of a set of particles; a row of bodies.csv, or of history.csv for all of them.
struct Totals {
    double mass = 0;                       ///< [kg]
    double volume = 0;                     ///< deformed [m^3]
    Vector first_moment{};                 ///< Σ m x [kg m]
    double second_moment = 0;              ///< Σ m (x² + y²) [kg m^2]
    Vector momentum{};                     ///< [kg m/s]
    double angular_momentum_z = 0;         ///< about the origin [kg m^2/s]
    double kinetic_energy = 0;             ///< [J]
    double strain_energy = 0;              ///< [J]
    std::array<double, 4> stress_volume{}; ///< Σ V σ: xx yy zz xy [J]

    Totals& operator+=(const Totals& other);
    Vector center() const;
    Vector mean_velocity() const;
    /// Volume-weighted mean Cauchy stress: xx yy zz xy [Pa].
    std::array<double, 4> mean_stress() const;
    /// Of the rigid rotation with the same angular momentum about the centre of mass [rad/s].
    double angular_velocity_z() const;
};

/// Strain energy of particle p [J]; 0 in rigid bodies.
template <int D>
double strain_energy(const State<D>& state, std::int32_t p);

/// Totals by body; sums are made in the order of particles, whatever the number of threads.
template <int D>
std::vector<Totals> body_totals(State<D>& state);

/// Names of history.csv's columns.
template <int D>
std::vector<std::string> history_columns(const State<D>& state);

/// A row of history.csv. The force of a boundary on the bodies is the mean since the previous row, so that forces times
/// intervals add up to the change of momentum; this call starts the next interval.
/// \param interval time since the previous row [s]
template <int D>
std::vector<double> history_row(State<D>& state, const Totals& all, double interval);

/// Totals of all bodies that deform: rigid ones have neither mass nor energy.
template <int D>
Totals deformable_totals(const State<D>& state, const std::vector<Totals>& by_body);

/// Names of bodies.csv's columns and one row of them, without the body's name.
std::vector<std::string> body_columns();
std::vector<double> body_row(const Totals& totals, bool rigid = false);

/// A row of pairs.csv without the names of the bodies.
struct PairRow {
    std::int32_t body_a, body_b; ///< a < b
    std::vector<double> values;
};

/// Names of pairs.csv's columns, without those of step, time and bodies: mean force on a since the previous row [N],
/// contact area at present [m^2], work of the contact on both bodies and its part along the interface since then [J],
/// energy that their interface holds [J].
std::vector<std::string> pair_columns();

/// The rows of pairs.csv: all pairs that have been in contact since the last call; it starts the next interval. Areas
/// are known if State::wants_areas was set for the last step, or the scene's laws need them.
template <int D>
std::vector<PairRow> pair_rows(State<D>& state, double interval);

} // namespace abut

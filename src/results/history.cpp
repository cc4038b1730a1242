#include "results/history.h"

#include "boundary/rigid_body.h"
#include "grid/parallel.h"
#include "material/prestress.h"

namespace abut {

Totals& Totals::operator+=(const Totals& other) {
    mass += other.mass;
    volume += other.volume;
    second_moment += other.second_moment;
    angular_momentum_z += other.angular_momentum_z;
    kinetic_energy += other.kinetic_energy;
    strain_energy += other.strain_energy;
    for (int a = 0; a < 3; ++a) {
        first_moment[a] += other.first_moment[a];
        momentum[a] += other.momentum[a];
    }
    for (int c = 0; c < 4; ++c) stress_volume[c] += other.stress_volume[c];
    return *this;
}

Vector Totals::center() const {
    return {first_moment[0] / mass, first_moment[1] / mass, first_moment[2] / mass};
}

Vector Totals::mean_velocity() const {
    return {momentum[0] / mass, momentum[1] / mass, momentum[2] / mass};
}

std::array<double, 4> Totals::mean_stress() const {
    std::array<double, 4> mean{};
    for (int c = 0; c < 4; ++c) mean[c] = stress_volume[c] / volume;
    return mean;
}

double Totals::angular_velocity_z() const {
    const Vector x = center();
    const double spin = angular_momentum_z - (x[0] * momentum[1] - x[1] * momentum[0]);
    const double inertia = second_moment - mass * (x[0] * x[0] + x[1] * x[1]);
    return inertia > 0 ? spin / inertia : 0;
}

namespace {

/// Strain energy of a particle [J].
template <int D>
double energy_of(const Particles<D>& particles, std::int32_t p, const Law& law, const Strain<D>& strain) {
    double density = std::visit([&](const auto& l) { return l.template energy<D>(strain); }, law);
    if (!particles.prestress.empty())
        density +=
            prestress_energy<D>(particles.prestress[p], particles.deformation_gradient[p], particles.across_of(p));
    return particles.volume[p] * density;
}

template <int D>
Totals particle_totals(const State<D>& state, std::int32_t p, const Law* law) {
    const Particles<D>& particles = state.particles;
    const Vector x = to_array<D>(particles.position[p]);
    const Vector v = to_array<D>(particles.velocity[p]);
    const Strain<D> strain = strain_of<D>(particles.deformation_gradient[p], particles.across_of(p));
    Totals t;
    t.mass = particles.mass[p];
    t.volume = strain.J * particles.volume[p];
    t.second_moment = t.mass * (x[0] * x[0] + x[1] * x[1]);
    t.angular_momentum_z = t.mass * (x[0] * v[1] - x[1] * v[0]);
    for (int a = 0; a < 3; ++a) {
        t.first_moment[a] = t.mass * x[a];
        t.momentum[a] = t.mass * v[a];
        t.kinetic_energy += 0.5 * t.mass * v[a] * v[a];
    }
    if (!law) return t; // rigid
    t.strain_energy = energy_of(particles, p, *law, strain);
    // V σ = V0 τ
    for (int c = 0; c < 4; ++c) t.stress_volume[c] = particles.volume[p] * particles.stress[p][c];
    return t;
}

} // namespace

template <int D>
double strain_energy(const State<D>& state, std::int32_t p) {
    const Particles<D>& particles = state.particles;
    if (is_rigid(state, particles.body[p])) return 0;
    return energy_of(particles, p, state.material_of(particles.body[p]).law,
                     strain_of<D>(particles.deformation_gradient[p], particles.across_of(p)));
}

template <int D>
std::vector<Totals> body_totals(State<D>& state) {
    std::vector<Totals> by_tile(state.tiling.tiles.size());
    for_each_tile(state.tiling, [&](const Tile<D>& tile) {
        Totals& sum = by_tile[&tile - state.tiling.tiles.data()];
        const bool rigid = is_rigid(state, tile.body);
        for (std::int32_t p = tile.first; p < tile.last; ++p)
            sum += particle_totals(state, p, rigid ? nullptr : &state.material_of(tile.body).law);
    });
    std::vector<Totals> by_body(state.bodies.size());
    for (std::size_t t = 0; t < by_tile.size(); ++t) by_body[state.tiling.tiles[t].body] += by_tile[t];
    return by_body;
}

template <int D>
std::vector<std::string> history_columns(const State<D>& state) {
    std::vector<std::string> columns = {"step",           "time",           "dt",
                                        "kinetic_energy", "strain_energy",  "total_energy",
                                        "external_work",  "contact_work",   "momentum_x",
                                        "momentum_y",     "momentum_z",     "mean_stress_xx",
                                        "mean_stress_yy", "mean_stress_zz", "mean_stress_xy"};
    const auto add_vector = [&](const std::string& name) {
        for (const char* axis : {"_x", "_y", "_z"}) columns.push_back(name + axis);
    };
    for (const Boundary& boundary : state.boundaries) add_vector("force_" + boundary.name);
    for (const ModelBody& body : state.bodies) {
        if (!body.rigid) continue;
        add_vector("force_" + body.name);
        add_vector("torque_" + body.name);
    }
    if (state.effects.contact) columns.emplace_back("friction_work");
    if (state.effects.interfaces) columns.emplace_back("interface_energy");
    return columns;
}

template <int D>
std::vector<double> history_row(State<D>& state, const Totals& all, double interval) {
    std::vector<double> row = {static_cast<double>(state.step),
                               state.time,
                               state.dt,
                               all.kinetic_energy,
                               all.strain_energy,
                               all.kinetic_energy + all.strain_energy,
                               state.ledger.external_work,
                               state.ledger.contact_work,
                               all.momentum[0],
                               all.momentum[1],
                               all.momentum[2]};
    for (const double stress : all.mean_stress()) row.push_back(stress);
    const auto add_force = [&](Vector& impulse) {
        for (const double component : impulse) row.push_back(interval > 0 ? component / interval : 0);
        impulse = {};
    };
    for (Boundary& boundary : state.boundaries) add_force(boundary.impulse);
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        if (!state.bodies[b].rigid) continue;
        RigidTotals& totals = state.rigid_totals[static_cast<std::int32_t>(b)];
        add_force(totals.impulse);
        add_force(totals.angular_impulse);
    }
    if (state.effects.contact) row.push_back(state.ledger.friction_work);
    if (state.effects.interfaces) row.push_back(state.ledger.interface_energy);
    return row;
}

template <int D>
Totals deformable_totals(const State<D>& state, const std::vector<Totals>& by_body) {
    Totals all;
    for (std::size_t b = 0; b < by_body.size(); ++b)
        if (!state.bodies[b].rigid) all += by_body[b];
    return all;
}

std::vector<std::string> pair_columns() {
    return {"force_x", "force_y", "force_z", "area", "work", "friction_work", "interface_energy"};
}

template <int D>
std::vector<PairRow> pair_rows(State<D>& state, double interval) {
    std::vector<PairRow> rows;
    for (auto& [bodies, totals] : state.pair_totals) {
        PairRow row{bodies.first, bodies.second, {}};
        for (const double impulse : totals.impulse) row.values.push_back(interval > 0 ? impulse / interval : 0);
        row.values.insert(row.values.end(), {totals.area, totals.work, totals.friction_work, totals.interface_energy});
        rows.push_back(std::move(row));
    }
    state.pair_totals.clear();
    return rows;
}

std::vector<std::string> body_columns() {
    return {"mass",
            "x",
            "y",
            "z",
            "vx",
            "vy",
            "vz",
            "kinetic_energy",
            "strain_energy",
            "stress_xx",
            "stress_yy",
            "stress_zz",
            "stress_xy",
            "angular_velocity_z"};
}

std::vector<double> body_row(const Totals& totals, bool rigid) {
    const Vector x = totals.center();
    const Vector v = totals.mean_velocity();
    const std::array<double, 4> stress = totals.mean_stress();
    return {rigid ? 0 : totals.mass,
            x[0],
            x[1],
            x[2],
            v[0],
            v[1],
            v[2],
            rigid ? 0 : totals.kinetic_energy,
            totals.strain_energy,
            stress[0],
            stress[1],
            stress[2],
            stress[3],
            totals.angular_velocity_z()};
}

template Totals deformable_totals<2>(const State<2>&, const std::vector<Totals>&);
template Totals deformable_totals<3>(const State<3>&, const std::vector<Totals>&);
template std::vector<PairRow> pair_rows<2>(State<2>&, double);
template std::vector<PairRow> pair_rows<3>(State<3>&, double);
template double strain_energy<2>(const State<2>&, std::int32_t);
template double strain_energy<3>(const State<3>&, std::int32_t);
template std::vector<Totals> body_totals<2>(State<2>&);
template std::vector<Totals> body_totals<3>(State<3>&);
template std::vector<std::string> history_columns<2>(const State<2>&);
template std::vector<std::string> history_columns<3>(const State<3>&);
template std::vector<double> history_row<2>(State<2>&, const Totals&, double);
template std::vector<double> history_row<3>(State<3>&, const Totals&, double);

} // namespace abut

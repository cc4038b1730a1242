#include "step/watch.h"

#include "boundary/rigid_body.h"
#include "boundary/rigid_motion.h"
#include "material/prestress.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace abut {

namespace {

double largest_size(const TimeFunction& f) {
    return std::max(std::abs(f.smallest()), std::abs(f.largest()));
}

template <int D>
std::int32_t fastest_particle(const State<D>& state) {
    std::int32_t fastest = 0;
    double most = -1;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double square = state.particles.velocity[p].squaredNorm();
        if (is_rigid(state, state.particles.body[p]) || !(square > most)) continue;
        fastest = static_cast<std::int32_t>(p);
        most = square;
    }
    return fastest;
}

/// Which arrays at the nodes hold a value that is no number, in the order in which a step makes them: the first is
/// nearest to the cause.
template <int D>
std::string bad_node_arrays(const State<D>& state) {
    const NodeArrays<D>& nodes = state.nodes;
    const std::pair<const char*, const std::vector<Pack>&> arrays[] = {
        {"momenta", nodes.momentum},   {"velocities", nodes.velocity},         {"forces", nodes.force},
        {"tractions", nodes.traction}, {"new velocities", nodes.end_velocity}, {"filtered velocities", nodes.filtered}};
    std::string names;
    for (const auto& [name, values] : arrays) {
        const bool sound = std::all_of(values.begin(), values.end(), [](const Pack& value) {
            return std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]) &&
                   std::isfinite(value[3]);
        });
        if (!sound) names += (names.empty() ? "" : ", ") + std::string(name);
    }
    return names;
}

/// What is wrong with a particle.
struct Finding {
    Trouble trouble;
    std::string what;
};

template <int D>
Finding not_a_number(const State<D>& state, const char* what) {
    std::string text = std::string("the particle's ") + what + " is not a number";
    if (const std::string arrays = bad_node_arrays(state); !arrays.empty())
        text += "; at the nodes it shows in: " + arrays;
    return {Trouble::not_a_number, text};
}

/// Looks for causes before their consequences.
template <int D>
Finding find_trouble(const State<D>& state, std::int32_t p) {
    const Particles<D>& particles = state.particles;
    const double speed = particles.velocity[p].norm();
    const Mat<D>& F = particles.deformation_gradient[p];
    const double across = particles.across_of(static_cast<std::size_t>(p));
    if (!std::isfinite(speed)) return not_a_number(state, "velocity");
    if (!particles.position[p].allFinite()) return not_a_number(state, "position");
    std::ostringstream text;
    if (speed > state.speed_limit) {
        text << "the particle moves at " << speed << " m/s, above ";
        if (state.scene.time.limits.speed)
            text << "/time/limits/speed of " << state.speed_limit << " m/s";
        else
            text << state.speed_limit << " m/s, ten times what the scene has at its start (/time/limits/speed)";
        return {Trouble::too_fast, text.str()};
    }
    if (!state.grid.contains(particles.position[p])) {
        text << "the particle left the grid, at " << speed << " m/s";
        return {Trouble::left_grid, text.str()};
    }
    if (state.effects.ring && !(particles.position[p][0] > 0))
        return {Trouble::crossed_axis, "the particle crossed the axis r = 0"};
    if (!F.allFinite() || !std::isfinite(across)) return not_a_number(state, "deformation gradient");
    const double J = F.determinant() * across;
    if (!(J > 0)) {
        text << "the particle is turned inside out, det F = " << J;
        return {Trouble::inside_out, text.str()};
    }
    if (!particles.stress[p].allFinite()) return not_a_number(state, "stress");
    text << "the particle is absurdly stretched: trace of F F^T = " << strain_of<D>(F, across).trace()
         << ", det F = " << J;
    return {Trouble::stretched, text.str()};
}

} // namespace

template <int D>
double speed_limit(const State<D>& state) {
    const Scene& scene = state.scene;
    if (scene.time.limits.speed) return *scene.time.limits.speed;
    double speed = state.largest_wave_speed;
    for (const Vec<D>& v : state.particles.velocity) speed = std::max(speed, v.norm());
    for (const BoundarySpec& boundary : scene.boundaries) {
        if (const auto* wall = std::get_if<WallSpec>(&boundary.condition))
            speed = std::max(speed, largest_size(wall->velocity));
        if (const auto* box = std::get_if<VelocitySpec>(&boundary.condition))
            speed = std::max(speed, largest_size(box->velocity));
    }
    double reach = 0;
    for (int a = 0; a < D; ++a) reach += std::pow(scene.grid.upper[a] - scene.grid.lower[a], 2);
    reach = std::sqrt(reach);
    for (const ModelBody& body : state.bodies) {
        if (!body.rigid) continue;
        double centre = 0;
        for (const TimeFunction& v : body.rigid->velocity) centre += std::pow(largest_size(v), 2);
        speed = std::max(speed, std::sqrt(centre) + largest_size(body.rigid->angular_velocity) * reach);
    }
    const double gravity = to_vec<D>(scene.gravity).norm();
    return 10 * std::max(speed, std::min(gravity * scene.time.end, std::sqrt(2 * gravity * reach)));
}

template <int D>
void watch_energy(State<D>& state, double energy, double mass) {
    EnergyWatch& watch = state.energy_watch;
    const Ledger& ledger = state.ledger;
    if (watch.given == 0) {
        const double round_off = 1e-6 * state.largest_wave_speed;
        watch.initial = energy - ledger.external_work - ledger.contact_work;
        watch.given = std::abs(energy) + 0.5 * mass * round_off * round_off;
    }
    watch.given +=
        std::abs(ledger.external_work - watch.external_work) + std::abs(ledger.contact_work - watch.contact_work);
    watch.external_work = ledger.external_work;
    watch.contact_work = ledger.contact_work;
    const double balance = energy - watch.initial - ledger.external_work - ledger.contact_work;
    watch.lowest = std::min(watch.lowest, balance);
    const double growth = balance - watch.lowest;
    // FMPM(k) gives edge nodes up to k times the momentum of which the ledger counts the work; see cfl_limit().
    const double orders = state.effects.fmpm ? state.scene.method.transfer.order : 1;
    const double limit = orders * state.scene.time.limits.energy_growth;
    if (growth <= limit * watch.given) return;
    std::ostringstream text;
    text << "energy of " << growth << " J has appeared out of nothing, " << growth / watch.given
         << " of all that the scene was given, above /time/limits/energy_growth of " << limit / orders
         << (orders > 1 ? " times the order of fmpm" : "") << "; this particle is the fastest";
    throw run_error(Trouble::energy_growth, state, fastest_particle(state), text.str());
}

template <int D>
void throw_trouble_of(const State<D>& state, std::int32_t particle) {
    const Finding found = find_trouble(state, particle);
    throw run_error(found.trouble, state, particle, found.what);
}

template <int D>
std::int32_t stiffest_particle(const State<D>& state) {
    const Particles<D>& particles = state.particles;
    std::int32_t stiffest = 0;
    double fastest = 0; // square of the wave speed
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (is_rigid(state, particles.body[p])) continue;
        const Material& material = state.material_of(particles.body[p]);
        const Mat<D>& F = particles.deformation_gradient[p];
        const double across = particles.across_of(p);
        double stiffness = std::visit(
            [&](const auto& law) { return law.template stiffness<D>(strain_of<D>(F, across)); }, material.law);
        if (!particles.prestress.empty()) stiffness += pushed_forward<D>(particles.prestress[p], F, across).norm();
        if (!(stiffness / material.density > fastest)) continue;
        fastest = stiffness / material.density;
        stiffest = static_cast<std::int32_t>(p);
    }
    return stiffest;
}

template double speed_limit<2>(const State<2>&);
template double speed_limit<3>(const State<3>&);
template void watch_energy<2>(State<2>&, double, double);
template void watch_energy<3>(State<3>&, double, double);
template void throw_trouble_of<2>(const State<2>&, std::int32_t);
template void throw_trouble_of<3>(const State<3>&, std::int32_t);
template std::int32_t stiffest_particle<2>(const State<2>&);
template std::int32_t stiffest_particle<3>(const State<3>&);

} // namespace abut

#include "boundary/rigid_body.h"
#include "results/frame_parts.h"
#include "results/history.h"

namespace abut {

namespace {

/// Full tensor in VTK's order from a particle's Kirchhoff stress.
template <int D>
std::array<double, 6> cauchy(const Particles<D>& particles, std::size_t p) {
    const double J = particles.deformation_gradient[p].determinant() * particles.across_of(p);
    const Stress<D>& tau = particles.stress[p];
    std::array<double, 6> s{};
    for (int c = 0; c < static_cast<int>(tau.size()); ++c) s[c] = tau[c] / J;
    return s;
}

double von_mises(const std::array<double, 6>& s) {
    const double xy = s[0] - s[1];
    const double yz = s[1] - s[2];
    const double zx = s[2] - s[0];
    return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

/// Places of the chosen bodies' particles in the store, by their ids.
template <int D>
std::vector<std::size_t> by_id(const Particles<D>& particles, const FrameChoice& choice) {
    std::vector<std::size_t> place(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) place[static_cast<std::size_t>(particles.id[p])] = p;
    if (!choice.bodies.empty()) std::erase_if(place, [&](std::size_t p) { return !choice.has(particles.body[p]); });
    return place;
}

/// Values of a frame's particles: work(p, out) writes the `components` values of particle p.
template <class Value, class Work>
std::vector<Value> values_of(const std::vector<std::size_t>& places, int components, Work work) {
    std::vector<Value> values(places.size() * static_cast<std::size_t>(components));
    const auto n = static_cast<std::ptrdiff_t>(places.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t i = 0; i < n; ++i) work(places[static_cast<std::size_t>(i)], values.data() + i * components);
    return values;
}

template <int D>
void put(const Vec<D>& v, double* out) {
    const Vector full = to_array<D>(v);
    std::copy(full.begin(), full.end(), out);
}

} // namespace

template <int D>
std::vector<bool> chosen_bodies(const State<D>& state) {
    const std::vector<std::string>& names = state.scene.output.bodies;
    if (names.empty()) return {};
    std::vector<bool> chosen;
    for (const ModelBody& body : state.bodies)
        chosen.push_back(
            std::any_of(names.begin(), names.end(), [&](const std::string& name) { return body.is_called(name); }));
    return chosen;
}

template <int D>
PointFrame particle_frame(const State<D>& state, const FrameChoice& choice) {
    const Particles<D>& particles = state.particles;
    const std::vector<std::size_t> places = by_id(particles, choice);
    const auto id = [&](std::size_t p) { return static_cast<std::size_t>(particles.id[p]); };

    PointFrame frame;
    frame.time = state.time;
    frame.points = values_of<double>(places, 3, [&](std::size_t p, double* x) { put<D>(particles.position[p], x); });
    const auto reals = [&](const char* name, int components, auto work) {
        if (choice.wants(name)) frame.arrays.push_back({name, components, values_of<double>(places, components, work)});
    };
    const auto whole = [&](const char* name, auto work) {
        if (choice.wants(name)) frame.arrays.push_back({name, 1, values_of<std::int32_t>(places, 1, work)});
    };
    reals("velocity", 3, [&](std::size_t p, double* out) { put<D>(particles.velocity[p], out); });
    reals("displacement", 3,
          [&](std::size_t p, double* out) { put<D>(particles.position[p] - state.initial_position[id(p)], out); });
    reals("stress", 6, [&](std::size_t p, double* out) {
        const auto s = cauchy(particles, p);
        std::copy(s.begin(), s.end(), out);
    });
    reals("pressure", 1, [&](std::size_t p, double* out) {
        const auto s = cauchy(particles, p);
        *out = -(s[0] + s[1] + s[2]) / 3;
    });
    reals("von_mises_stress", 1, [&](std::size_t p, double* out) { *out = von_mises(cauchy(particles, p)); });
    reals("deformation_gradient", 9, [&](std::size_t p, double* out) {
        const Mat<D>& F = particles.deformation_gradient[p];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) *out++ = i < D && j < D ? F(i, j) : i == j ? particles.across_of(p) : 0;
    });
    reals("mass", 1,
          [&](std::size_t p, double* out) { *out = is_rigid(state, particles.body[p]) ? 0 : particles.mass[p]; });
    const auto volume = [&](std::size_t p) {
        return particles.deformation_gradient[p].determinant() * particles.across_of(p) * particles.volume[p];
    };
    reals("volume", 1, [&](std::size_t p, double* out) { *out = volume(p); });
    reals("strain_energy_density", 1,
          [&](std::size_t p, double* out) { *out = strain_energy(state, static_cast<std::int32_t>(p)) / volume(p); });
    whole("body", [&](std::size_t p, std::int32_t* out) { *out = particles.body[p]; });
    whole("id", [&](std::size_t p, std::int32_t* out) { *out = particles.id[p]; });
    reals("half_size", 3, [&](std::size_t p, double* out) { put<D>(particles.half_size[p], out); });
    const auto of_ids = [&](const char* name, const std::vector<double>& values) {
        if (!values.empty()) reals(name, 1, [&](std::size_t p, double* out) { *out = values[id(p)]; });
    };
    of_ids("temperature", state.temperature);
    of_ids("orientation", state.orientation);
    keep_wanted(frame.arrays, choice);
    frame.globals.push_back(step_number(state.step));
    frame.words.push_back(body_names(state));
    return frame;
}

template std::vector<bool> chosen_bodies<2>(const State<2>&);
template std::vector<bool> chosen_bodies<3>(const State<3>&);
template PointFrame particle_frame<2>(const State<2>&, const FrameChoice&);
template PointFrame particle_frame<3>(const State<3>&, const FrameChoice&);

} // namespace abut

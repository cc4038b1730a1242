#include "stability/random_scene.h"

#include <sstream>

namespace test {

namespace {

/// Numbers that do not depend on the library's distributions.
struct Dice {
    std::mt19937_64 engine;
    double in(double low, double high) { return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53); }
    int below(int n) { return static_cast<int>(engine() % static_cast<std::uint64_t>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    template <class T, std::size_t N>
    T of(const T (&all)[N]) {
        return all[below(static_cast<int>(N))];
    }
};

TransferSpec random_transfer(Dice& dice, bool advised) {
    const TransferScheme scheme =
        dice.of({TransferScheme::flip, TransferScheme::pic, TransferScheme::xpic, TransferScheme::fmpm});
    TransferSpec t{scheme, 1 + dice.below(advised && scheme == TransferScheme::fmpm ? 4 : 8), {}, {}};
    if (scheme != TransferScheme::flip && dice.one_in(6)) t.every_cfl = dice.in(1, 4);
    return t;
}

constexpr double box_size = 12; // [cells]

} // namespace

RandomScene random_scene(std::uint64_t seed, Choice choice) {
    const bool advised = choice == Choice::advised;
    Dice dice{std::mt19937_64(seed)};
    RandomScene r;
    r.dimension = dice.one_in(10) ? 3 : 2;
    do r.shape = dice.of(all_shapes);
    while (advised && r.shape == ShapeKind::linear);
    r.transfer = random_transfer(dice, advised);
    if (!advised)
        r.stress = dice.of({StressUpdate::usl, StressUpdate::usf, StressUpdate::usavg, StressUpdate::usl_plus,
                            StressUpdate::usavg_plus});
    r.thinnest = advised ? 2 : 1;
    r.normal = dice.of({NormalMethod::logistic_regression, NormalMethod::logistic_regression,
                        NormalMethod::linear_regression, NormalMethod::irls_regression, NormalMethod::average_gradient,
                        NormalMethod::maximum_gradient, NormalMethod::maximum_volume});
    r.separation = dice.of({SeparationMethod::particle_edges, SeparationMethod::particle_edges,
                            SeparationMethod::critical_position, SeparationMethod::fitted_position,
                            SeparationMethod::displacement, SeparationMethod::none});
    r.law = dice.of({LawType::frictionless, LawType::friction, LawType::friction, LawType::stick, LawType::perfect});
    r.friction = dice.of({0.0, 0.1, 0.5, 2.0});
    r.contact = !dice.one_in(8);
    r.walls = dice.one_in(3);
    r.gravity = dice.one_in(4);
    r.plane_stress = r.dimension == 2 && dice.one_in(8);
    r.cfl = advised ? dice.of({0.1, 0.3, 0.4}) : dice.of({0.1, 0.4, 0.6, 0.9});
    r.cell = dice.of({1.0, 0x1p-20, 0x1p8});
    r.model =
        dice.of({MaterialModel::neo_hookean, MaterialModel::neo_hookean_isochoric, MaterialModel::linear_elastic});
    r.contrast = dice.of({1.0, 1.0, 10.0, 1000.0});
    // Bodies in a row of slots, so that none begins inside another.
    const int count = 1 + dice.below(r.dimension == 3 ? 3 : 5);
    double x = 1.5;
    for (int b = 0; b < count && x < box_size - 2.5; ++b) {
        RandomBody body;
        for (int a = 0; a < r.dimension; ++a) body.n[a] = r.thinnest + dice.below(r.dimension == 3 ? 3 : 5);
        body.lower = {x, dice.in(2, 7), r.dimension == 3 ? dice.in(2, 7) : 0};
        for (int a = 0; a < r.dimension; ++a) body.velocity[a] = dice.in(-1, 1);
        body.material = dice.below(2);
        x += 0.5 * body.n[0] + (dice.one_in(2) ? 0 : dice.in(0, 0.5));
        if (x > box_size - 1.5) break;
        r.bodies.push_back(body);
    }
    r.steps = 20 + dice.below(40);
    return r;
}

Scene scene_of(const RandomScene& r) {
    const double h = r.cell;
    const auto solid = [&](double stiffness) {
        MaterialSpec m = material(1 / stiffness, 100 * stiffness * h * h, 50 * stiffness * h * h, r.model);
        return m;
    };
    Scene scene = r.dimension == 2 ? plane_scene(h, 0, 0, box_size * h, box_size * h, solid(1))
                                   : space_scene(h, 0, box_size * h, solid(1));
    scene.materials.push_back(solid(r.contrast));
    if (r.plane_stress) scene.analysis = Analysis::plane_stress;
    scene.method.shape = r.shape;
    scene.method.transfer = r.transfer;
    scene.method.stress_update = r.stress;
    scene.time.cfl = r.cfl;
    if (r.contact) {
        scene.contact = contact(r.law, r.friction);
        scene.contact->normal = r.normal;
        scene.contact->separation = r.separation;
    }
    if (r.gravity) scene.gravity = {0.5 * h, -h, 0};
    if (r.walls)
        for (int a = 0; a < r.dimension; ++a) {
            add_wall(scene, std::string("lower ") + "xyz"[a], a, Side::lower, h, 0, false);
            add_wall(scene, std::string("upper ") + "xyz"[a], a, Side::upper, (box_size - 1) * h, 0, false);
        }
    return scene;
}

Model model_of(const RandomScene& r) {
    Model model;
    const double h = r.cell;
    for (const RandomBody& b : r.bodies) {
        const int body = add_body(model, "body " + std::to_string(model.bodies.size()),
                                  {b.velocity[0] * h, b.velocity[1] * h, b.velocity[2] * h});
        model.bodies[static_cast<std::size_t>(body)].material = b.material;
        for (int k = 0; k < std::max(1, b.n[2]); ++k)
            for (int j = 0; j < b.n[1]; ++j)
                for (int i = 0; i < b.n[0]; ++i) {
                    const double z = r.dimension == 3 ? (b.lower[2] + 0.5 * k + 0.25) * h : 0;
                    const double half = 0.25 * h;
                    add_particle(model, body,
                                 Vector{(b.lower[0] + 0.5 * i + 0.25) * h, (b.lower[1] + 0.5 * j + 0.25) * h, z},
                                 Vector{half, half, r.dimension == 3 ? half : 0});
                }
    }
    return model;
}

namespace {

/// Bodies that stick may gain up to this share of the energy; a present limit whose cause has not been found (see
/// README.md), met by 3 of 3000 scenes, at most 1 % in them.
constexpr double gain_of_sticking = 0.02;

/// What scenes with FMPM of order 2 and more may gain. The energy of particles that get S m_k^-1 p is not the one that
/// its steps keep, and no bound is known; one that diverges has gained all but a few percent of its energy.
constexpr double gain_of_fmpm = 0.5;

/// What a scene may gain: by the time integration, twice what it is for small strains (see deformation.cpp), and what
/// contact gave by the ledger's own figure.
template <int D>
std::string fails_in(const RandomScene& r, Figures* figures) {
    State<D> state = make_state<D>(scene_of(r), model_of(r));
    Watch<D> watch(state);
    double contact_work = 0;
    auto tasks = step_tasks<D>(state.scene);
    try {
        for (int s = 0; s < r.steps; ++s) {
            state.dt = next_step(state, 1e30);
            advance(state, tasks);
            watch();
            contact_work = std::max(contact_work, state.ledger.contact_work);
            if (!is_sound(state)) return "not finite, or turned inside out";
        }
    } catch (const std::exception& error) {
        return error.what();
    }
    if (!(watch.largest > 0)) return {};
    const double lost = watch.momentum_error / std::sqrt(2 * watch.start.mass * watch.largest);
    const double loss_limit = watch.momentum_limit() / std::sqrt(2 * watch.start.mass * watch.largest);
    if (!r.walls && !r.gravity) {
        if (figures) figures->at_most("momentum lost / sqrt(2 M E)", "", lost, loss_limit);
        if (lost > loss_limit) return "momentum lost " + std::to_string(lost / loss_limit) + " times the limit";
    }
    const bool sticks = r.contact && (r.law == LawType::stick || r.law == LawType::perfect);
    const double gained = std::max(0.0, watch.excess - contact_work) / watch.largest;
    const bool full_mass = r.transfer.scheme == TransferScheme::fmpm && r.transfer.order > 1;
    const double gain_limit =
        full_mass ? gain_of_fmpm : 2 * watch.energy_limit() / watch.largest + (sticks ? gain_of_sticking : 1e-12);
    if (figures && r.thinnest > 1)
        figures->at_most(std::string("energy gained") + (full_mass ? ", fmpm"
                                                         : sticks  ? ", sticking"
                                                                   : ""),
                         "", gained, gain_limit);
    if (gained > gain_limit)
        return "energy gained " + std::to_string(gained) + ", at most " + std::to_string(gain_limit);
    return {};
}

template <int D>
Particles<D> particles_after(const RandomScene& r, int threads) {
    omp_set_num_threads(threads);
    State<D> state = make_state<D>(scene_of(r), model_of(r));
    auto tasks = step_tasks<D>(state.scene);
    for (int s = 0; s < r.steps; ++s) {
        state.dt = next_step(state, 1e30);
        advance(state, tasks);
    }
    omp_set_num_threads(1);
    return state.particles;
}

template <int D>
bool same_with_two_threads(const RandomScene& r) {
    const Particles<D> one = particles_after<D>(r, 1), two = particles_after<D>(r, 2);
    return one.id == two.id && one.position == two.position && one.velocity == two.velocity &&
           one.deformation_gradient == two.deformation_gradient && one.stress == two.stress;
}

} // namespace

std::string what_fails(const RandomScene& r, bool threads_too, Figures* figures) {
    const std::string failure = r.dimension == 2 ? fails_in<2>(r, figures) : fails_in<3>(r, figures);
    if (!failure.empty() || !threads_too) return failure;
    const bool same = r.dimension == 2 ? same_with_two_threads<2>(r) : same_with_two_threads<3>(r);
    return same ? "" : "two threads give other bits than one";
}

namespace {

/// Scenes that are smaller by one thing each.
std::vector<RandomScene> smaller_than(const RandomScene& r) {
    std::vector<RandomScene> all;
    const auto add = [&](bool smaller, auto change) {
        if (smaller) change(all.emplace_back(r));
    };
    for (std::size_t b = 0; b < r.bodies.size(); ++b) {
        add(r.bodies.size() > 1,
            [&](RandomScene& s) { s.bodies.erase(s.bodies.begin() + static_cast<std::ptrdiff_t>(b)); });
        for (std::size_t a = 0; a < 3; ++a) {
            add(r.bodies[b].n[a] > r.thinnest, [&](RandomScene& s) { --s.bodies[b].n[a]; });
            add(r.bodies[b].velocity[a] != 0, [&](RandomScene& s) { s.bodies[b].velocity[a] = 0; });
        }
    }
    add(r.steps > 1, [](RandomScene& s) { s.steps /= 2; });
    add(r.steps > 1, [](RandomScene& s) { --s.steps; });
    add(r.gravity, [](RandomScene& s) { s.gravity = false; });
    add(r.walls, [](RandomScene& s) { s.walls = false; });
    add(r.contact, [](RandomScene& s) { s.contact = false; });
    add(r.plane_stress, [](RandomScene& s) { s.plane_stress = false; });
    add(r.contrast != 1, [](RandomScene& s) { s.contrast = 1; });
    add(r.cell != 1, [](RandomScene& s) { s.cell = 1; });
    add(r.cfl != 0.4, [](RandomScene& s) { s.cfl = 0.4; });
    add(r.model != MaterialModel::neo_hookean, [](RandomScene& s) { s.model = MaterialModel::neo_hookean; });
    add(r.stress != StressUpdate::usl, [](RandomScene& s) { s.stress = StressUpdate::usl; });
    add(r.transfer.every_cfl.has_value(), [](RandomScene& s) { s.transfer.every_cfl.reset(); });
    add(r.transfer.order > 1, [](RandomScene& s) { --s.transfer.order; });
    add(r.transfer.scheme != TransferScheme::flip, [](RandomScene& s) { s.transfer.scheme = TransferScheme::flip; });
    add(r.law != LawType::frictionless, [](RandomScene& s) { s.law = LawType::frictionless; });
    add(r.shape != ShapeKind::ugimp, [](RandomScene& s) { s.shape = ShapeKind::ugimp; });
    return all;
}

} // namespace

RandomScene shrunk(RandomScene r, const std::function<std::string(const RandomScene&)>& fails) {
    for (int tries = 0; tries < 1000;) {
        bool found = false;
        for (const RandomScene& s : smaller_than(r)) {
            ++tries;
            if (fails(s).empty()) continue;
            r = s;
            found = true;
            break;
        }
        if (!found) break;
    }
    return r;
}

std::string text_of(const RandomScene& r) {
    std::ostringstream text;
    text.precision(17);
    const auto number = [](auto value) { return static_cast<int>(value); };
    text << "RandomScene{" << r.dimension << ", ShapeKind(" << number(r.shape) << "), {TransferScheme("
         << number(r.transfer.scheme) << "), " << r.transfer.order << ", {}, ";
    if (r.transfer.every_cfl)
        text << *r.transfer.every_cfl;
    else
        text << "{}";
    text << "}, StressUpdate(" << number(r.stress) << "), NormalMethod(" << number(r.normal) << "), SeparationMethod("
         << number(r.separation) << "), LawType(" << number(r.law) << "), " << r.friction << ", " << r.contact << ", "
         << r.walls << ", " << r.gravity << ", " << r.plane_stress << ", " << r.cfl << ", " << r.cell
         << ", MaterialModel(" << number(r.model) << "), " << r.contrast << ", {";
    for (const RandomBody& b : r.bodies)
        text << "{{" << b.n[0] << ", " << b.n[1] << ", " << b.n[2] << "}, {" << b.lower[0] << ", " << b.lower[1] << ", "
             << b.lower[2] << "}, {" << b.velocity[0] << ", " << b.velocity[1] << ", " << b.velocity[2] << "}, "
             << b.material << "}, ";
    text << "}, " << r.steps << "}";
    return text.str();
}

} // namespace test

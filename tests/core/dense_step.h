#pragma once
/// What one step of a small cloud should give, by dense algebra from the papers' matrix equations (FMPM paper §2.2-2.6,
/// contact paper §3.2, 3.3).

#include "dense.h"

#include "material/deformation.h"

namespace test {

using Eigen::MatrixXd;

/// A small cloud of two bodies in each other, moving and strained at random. Node masses differ widely.
template <int D>
State<D> random_state(const std::function<void(Scene&)>& change, int seed) {
    Scene scene =
        D == 2 ? plane_scene(1, 0, 0, 6, 5, material(2, 100, 40)) : space_scene(1, 0, 5, material(2, 100, 40));
    change(scene);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> in(0, 1);
    Model model;
    add_body(model, "a");
    add_body(model, "b");
    const auto half = [&] { return 0.15 + 0.3 * in(random); };
    for (int p = 0; p < 40; ++p) {
        const double x = 1.2 + 2.5 * in(random) + 0.6 * (p % 2);
        add_particle(model, p % 2, Vector{x, 1.2 + 2.4 * in(random), D == 3 ? 1.2 + 2.4 * in(random) : 0},
                     Vector{half(), half(), D == 3 ? half() : 0});
    }
    State<D> state = make_state<D>(scene, model);
    auto& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        for (int a = 0; a < D; ++a) particles.velocity[p][a] = in(random)-0.5;
        particles.deformation_gradient[p] = random_deformation<D>(random, 0.2);
        if (!particles.across.empty()) particles.across[p] = 0.9 + 0.2 * in(random);
        const auto strain = strain_of<D>(particles.deformation_gradient[p], particles.across_of(p));
        particles.stress[p] =
            std::visit([&](const auto& law) { return law.template kirchhoff<D>(strain); }, state.materials[0].law);
    }
    state.dt = 0.01;
    return state;
}

/// The velocities of nodes that a scene's conditions set, in a test's own words.
using Conditions = std::function<void(const std::vector<Vector>& node, MatrixXd& velocity)>;

template <int D>
struct StepOracle {
    Dense<D> d;
    MatrixXd V, X;              ///< before the step
    MatrixXd next_V, next_X;    ///< after it
    MatrixXd v, v_end, delta;   ///< v^α, v^α+ (lumped), Δv^α
    MatrixXd end;               ///< what moves the particles: v_end, or m_k^-1 p+ of FMPM
    std::vector<Mat<D>> F;      ///< after the step
    std::vector<Stress<D>> tau; ///< after the step
    std::vector<double> across;
    double dt;

    /// \param transfers false: a FLIP step between those of the scheme
    explicit StepOracle(const State<D>& state, const Conditions& conditions = {}, bool transfers = true)
        : d(state), V(rows_of<D>(state.particles.velocity)), X(rows_of<D>(state.particles.position)),
          F(state.particles.deformation_gradient), tau(state.particles.stress), across(state.particles.across),
          dt(state.dt), state_(state), conditions_(conditions), scheme_(state.scene.method.transfer.scheme),
          order_(scheme_ == TransferScheme::xpic || scheme_ == TransferScheme::fmpm ? state.scene.method.transfer.order
                                                                                    : 1) {
        const MethodSpec& method = state.scene.method;
        const StressUpdate update = method.stress_update;
        const bool first = update != StressUpdate::usl && update != StressUpdate::usl_plus;
        const bool again = update == StressUpdate::usl_plus || update == StressUpdate::usavg_plus;
        const bool last = update != StressUpdate::usf;
        const double strain_step = first && last ? 0.5 * dt : dt;
        if (!transfers) scheme_ = TransferScheme::flip;
        for (const auto& node : slot_nodes(state.fields))
            places_.push_back(to_array<D>(state.grid.node_position(node)));

        v = after_contact(d.over_mass(d.S.transpose() * d.M.asDiagonal() * V), delta);
        if (first) deform(deforming(v, delta), strain_step);
        v_end = v + dt * d.over_mass(force());
        for (int a = 0; a < D; ++a) v_end.col(a).array() += dt * state.scene.gravity[a];
        const bool after_only = fmpm() && method.velocity_conditions == VelocityConditions::velocity;
        if (!after_only) impose(v_end);
        MatrixXd unused;
        v_end = after_contact(v_end, unused);
        end = v_end;
        if (fmpm()) {
            end = full_mass(v_end, delta);
            if (method.velocity_conditions != VelocityConditions::lumped) impose(end);
        }
        if (last && !again) deform(end, strain_step);
        move(position_update(method.transfer));
        if (!again) return;
        MatrixXd new_delta;
        const MatrixXd u = after_contact(d.over_mass(d.S.transpose() * d.M.asDiagonal() * next_V), new_delta);
        deform(deforming(u, new_delta), strain_step);
    }

    /// m_k^-1 p − m_(k−1)^-1 Δp of the scene's order, from v = m^-1 p.
    MatrixXd full_mass(const MatrixXd& velocity, const MatrixXd& change) const {
        return d.inverse(order_, velocity) - d.inverse(order_ - 1, change);
    }

    /// All particles of a state after the step.
    void expect(const State<D>& after, double tolerance = 1e-11) const {
        const double size = 1 + next_V.cwiseAbs().maxCoeff();
        for (std::size_t p = 0; p < after.particles.size(); ++p) {
            const auto row = static_cast<Eigen::Index>(p);
            EXPECT_LT((after.particles.velocity[p].transpose() - next_V.row(row)).norm(), tolerance * size);
            EXPECT_LT((after.particles.position[p].transpose() - next_X.row(row)).norm(), tolerance * size);
            EXPECT_LT((after.particles.deformation_gradient[p] - F[p]).norm(), tolerance * size);
            EXPECT_LT((after.particles.stress[p] - tau[p]).norm(), 1e3 * tolerance * size);
            if (!across.empty()) {
                EXPECT_NEAR(after.particles.across[p], across[p], tolerance * size);
            }
        }
    }

private:
    bool fmpm() const { return scheme_ == TransferScheme::fmpm; }
    void impose(MatrixXd& velocity) const {
        if (conditions_) conditions_(places_, velocity);
    }

    /// What the perfect interface of all bodies makes of velocities: that of their common centre of mass.
    MatrixXd after_contact(const MatrixXd& u, MatrixXd& change) const {
        MatrixXd result = u;
        if (state_.effects.contact)
            for (std::size_t i = 0; i < places_.size(); ++i) {
                double mass = 0;
                Eigen::RowVectorXd momentum = Eigen::RowVectorXd::Zero(D);
                for (std::size_t j = 0; j < places_.size(); ++j) {
                    if (places_[i] != places_[j]) continue;
                    mass += d.m[j];
                    momentum += d.m[j] * u.row(j);
                }
                if (d.m[i] > 0) result.row(i) = momentum / mass;
            }
        change = result - u;
        return result;
    }

    MatrixXd force() const {
        MatrixXd f = MatrixXd::Zero(d.m.size(), D);
        for (Eigen::Index p = 0; p < d.M.size(); ++p) {
            const Stress<D>& s = tau[p];
            Mat<D> t;
            if constexpr (D == 2)
                t << s[0], s[3], s[3], s[1];
            else
                t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
            const double V0 = state_.particles.volume[p];
            for (int i = 0; i < D; ++i)
                for (int a = 0; a < D; ++a) f.col(i) -= V0 * t(i, a) * d.G[a].row(p).transpose();
            f.col(0) -= V0 * s[2] * d.T.row(p).transpose(); // rings; T is 0 else
        }
        return f;
    }

    /// Velocities that deform the particles apart from the momentum update.
    MatrixXd deforming(MatrixXd u, const MatrixXd& change) const {
        impose(u);
        if (!fmpm()) return u;
        u = full_mass(u, change);
        impose(u);
        return u;
    }

    void deform(const MatrixXd& u, double time) {
        for (Eigen::Index p = 0; p < d.M.size(); ++p) {
            Mat<D> L;
            for (int i = 0; i < D; ++i)
                for (int a = 0; a < D; ++a) L(i, a) = time * u.col(i).dot(d.G[a].row(p));
            const bool linear = state_.scene.method.deformation_increment == DeformationIncrement::linear;
            F[p] = (linear ? Mat<D>(Mat<D>::Identity() + L) : exponential(L)) * F[p];
            std::visit(
                [&](const auto& law) {
                    double stretch = 1;
                    if constexpr (D == 2)
                        if (!across.empty()) {
                            const double hoop = time * u.col(0).dot(d.T.row(p));
                            stretch = across[p] * (linear ? 1 + hoop : std::exp(hoop));
                            if (state_.scene.analysis == Analysis::plane_stress)
                                stretch = law.stretch_without_stress(strain_of<2>(F[p], stretch), stretch);
                            across[p] = stretch;
                        }
                    tau[p] = law.template kirchhoff<D>(strain_of<D>(F[p], stretch));
                },
                state_.materials[0].law);
        }
    }

    /// FMPM paper §2.3, task 4.
    void move(PositionUpdate rule) {
        const MatrixXd start = d.S * v;
        switch (scheme_) {
        case TransferScheme::flip:
            next_V = V + d.S * (v_end - v);
            next_X = X + dt * (start + 0.5 * d.S * (v_end - v));
            if (state_.scene.method.transfer.position == PositionUpdate::end_velocity) next_X = X + dt * d.S * v_end;
            return;
        case TransferScheme::xpic:
            next_V = d.S * (full_mass(v, delta) + v_end - v);
            break;
        case TransferScheme::pic:
        case TransferScheme::fmpm:
            next_V = d.S * end;
        }
        if (rule == PositionUpdate::end_velocity) next_X = X + dt * d.S * end;
        if (rule == PositionUpdate::start_velocity) next_X = X + dt * (start + 0.5 * (next_V - V));
        if (rule == PositionUpdate::mean_velocity) next_X = X + 0.5 * dt * (V + next_V);
    }

    State<D> state_;
    Conditions conditions_;
    TransferScheme scheme_;
    int order_;
    std::vector<Vector> places_;
};

/// One step by the tasks, and the oracle of the sorted state before it.
template <int D>
struct Step {
    State<D> state;
    StepOracle<D> oracle;

    Step(const std::function<void(Scene&)>& change, int seed, const Conditions& conditions = {})
        : state(sorted(change, seed)), oracle(state, conditions) {
        auto tasks = step_tasks<D>(state.scene);
        advance(state, tasks);
    }
    void expect(double tolerance = 1e-11) const { oracle.expect(state, tolerance); }

private:
    static State<D> sorted(const std::function<void(Scene&)>& change, int seed) {
        State<D> state = random_state<D>(change, seed);
        find_velocity_fields(state);
        return state;
    }
};

constexpr PositionUpdate all_positions[] = {PositionUpdate::end_velocity, PositionUpdate::start_velocity,
                                            PositionUpdate::mean_velocity};

inline std::function<void(Scene&)> scene_with(ShapeKind shape, TransferSpec t, bool perfect = false,
                                              StressUpdate update = StressUpdate::usl) {
    return [=](Scene& s) {
        s.method.shape = shape;
        s.method.transfer = t;
        s.method.stress_update = update;
        s.gravity = {0.3, -2, s.analysis == Analysis::three_d ? 0.7 : 0};
        if (perfect) s.contact = contact(LawType::perfect);
    };
}

} // namespace test

/// Whole time steps of small clouds against the papers' matrix equations.

#include "dense.h"

#include "material/deformation.h"

namespace {

using namespace test;
using Eigen::MatrixXd;

/// A small cloud of two bodies in each other, moving and strained at random. Node masses differ widely.
State<2> random_state(const std::function<void(Scene&)>& change, int seed) {
    Scene scene = plane_scene(1, 0, 0, 6, 5, material(2, 100, 40));
    change(scene);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> in(0, 1);
    Model model;
    add_body(model, "a");
    add_body(model, "b");
    for (int p = 0; p < 40; ++p)
        add_particle(model, p % 2, 1.2 + 2.5 * in(random) + 0.6 * (p % 2), 1.2 + 2.4 * in(random),
                     0.15 + 0.3 * in(random), 0.15 + 0.3 * in(random));
    State<2> state = make_state<2>(scene, model);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.velocity[p] = Vec<2>(in(random)-0.5, in(random)-0.5);
        state.particles.deformation_gradient[p] = random_deformation<2>(random, 0.2);
        const auto strain = strain_of<2>(state.particles.deformation_gradient[p]);
        state.particles.stress[p] =
            std::visit([&](const auto& law) { return law.kirchhoff(strain); }, state.materials[0].law);
    }
    state.dt = 0.01;
    return state;
}

/// What one step should give, by dense algebra (FMPM paper §2.3, contact paper §3.2, 3.3).
struct Oracle {
    Dense d;
    MatrixXd V, X;         ///< before the step
    MatrixXd v, v_end;     ///< v^α, v^α+
    MatrixXd delta;        ///< Δv^α
    std::vector<Mat<2>> F; ///< after the step
    double dt;

    /// \param together all bodies move as one: perfect interfaces
    Oracle(const State<2>& state, bool together)
        : d(state), V(rows_of(state.particles.velocity)), X(rows_of(state.particles.position)), dt(state.dt) {
        const MatrixXd p = d.S.transpose() * d.M.asDiagonal() * V;
        MatrixXd f = MatrixXd::Zero(p.rows(), 2);
        for (Eigen::Index q = 0; q < d.M.size(); ++q) {
            const Stress<2>& tau = state.particles.stress[q];
            const double V0 = state.particles.volume[q];
            f.col(0) -= V0 * (d.Gx.row(q).transpose() * tau[0] + d.Gy.row(q).transpose() * tau[3]);
            f.col(1) -= V0 * (d.Gx.row(q).transpose() * tau[3] + d.Gy.row(q).transpose() * tau[1]);
        }
        for (int a = 0; a < 2; ++a) f.col(a) += state.scene.gravity[a] * d.m;
        v = d.over_mass(p);
        const MatrixXd v0 = v;
        if (together) v = common(state, v);
        delta = v - v0;
        v_end = v + dt * d.over_mass(f);
        if (together) v_end = common(state, v_end);
        for (Eigen::Index q = 0; q < d.M.size(); ++q) {
            Mat<2> gradient;
            gradient << v_end.col(0).dot(d.Gx.row(q)), v_end.col(0).dot(d.Gy.row(q)), v_end.col(1).dot(d.Gx.row(q)),
                v_end.col(1).dot(d.Gy.row(q));
            F.push_back(exponential(gradient * dt) * state.particles.deformation_gradient[q]);
        }
    }

    /// Velocity of the centre of mass of all fields at each node.
    MatrixXd common(const State<2>& state, const MatrixXd& u) const {
        const auto nodes = slot_nodes(state.fields);
        MatrixXd result = u;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            double mass = 0;
            Eigen::RowVector2d momentum(0, 0);
            for (std::size_t j = 0; j < nodes.size(); ++j) {
                if (nodes[i] != nodes[j]) continue;
                mass += d.m[j];
                momentum += d.m[j] * u.row(j);
            }
            if (d.m[i] > 0) result.row(i) = momentum / mass;
        }
        return result;
    }

    /// P V of order k: contact paper Eq. (37).
    MatrixXd filtered(int k) const {
        const MatrixXd I = MatrixXd::Identity(V.rows(), V.rows());
        const MatrixXd R = I - d.S * d.S_plus;
        MatrixXd power = I;
        for (int i = 0; i < k - 1; ++i) power = power * R;
        return V - power * R * V + power * d.S * delta;
    }
};

void expect_rows(const std::vector<Vec<2>>& found, const MatrixXd& expected, double tolerance, const char* what) {
    for (std::size_t p = 0; p < found.size(); ++p)
        EXPECT_LT((found[p].transpose() - expected.row(static_cast<Eigen::Index>(p))).norm(), tolerance)
            << what << " of particle " << p;
}

/// One step by the tasks; the oracle is made of the sorted state before it.
struct Step {
    State<2> state;
    Oracle oracle;

    Step(const std::function<void(Scene&)>& change, int seed, bool together)
        : state(sorted(change, seed)), oracle(state, together) {
        auto tasks = step_tasks<2>(state.scene);
        advance(state, tasks);
    }
    void expect(const MatrixXd& V, const MatrixXd& X) const {
        expect_rows(state.particles.velocity, V, 1e-11, "velocity");
        expect_rows(state.particles.position, X, 1e-12, "position");
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            EXPECT_LT((state.particles.deformation_gradient[p] - oracle.F[p]).norm(), 1e-11);
    }

private:
    static State<2> sorted(const std::function<void(Scene&)>& change, int seed) {
        State<2> state = random_state(change, seed);
        find_velocity_fields(state);
        return state;
    }
};

constexpr ShapeKind all_shapes[] = {ShapeKind::linear, ShapeKind::ugimp, ShapeKind::cpdi};

std::function<void(Scene&)> scene_with(ShapeKind shape, TransferSpec t, bool perfect = false) {
    return [=](Scene& s) {
        s.method.shape = shape;
        s.method.transfer = t;
        s.gravity = {0.3, -2, 0};
        if (perfect) s.contact = contact(LawType::perfect);
    };
}

TEST(DenseStep, Flip) {
    for (const ShapeKind shape : all_shapes)
        for (const bool perfect : {false, true}) {
            const Step r(scene_with(shape, transfer(TransferScheme::flip), perfect), 1, perfect);
            const Oracle& o = r.oracle;
            const MatrixXd change = o.d.S * (o.v_end - o.v);
            r.expect(o.V + change, o.X + o.dt * (o.d.S * o.v + 0.5 * change));
        }
}

TEST(DenseStep, Pic) {
    for (const ShapeKind shape : all_shapes)
        for (const bool perfect : {false, true}) {
            const Step end(scene_with(shape, transfer(TransferScheme::pic), perfect), 2, perfect);
            const MatrixXd V = end.oracle.d.S * end.oracle.v_end;
            end.expect(V, end.oracle.X + end.oracle.dt * V);
            const Step start(
                scene_with(shape, transfer(TransferScheme::pic, 2, PositionUpdate::start_velocity), perfect), 2,
                perfect);
            const Oracle& o = start.oracle;
            start.expect(V, o.X + o.dt * (o.d.S * o.v + 0.5 * (V - o.V)));
        }
}

TEST(DenseStep, XpicOfEveryOrder) {
    for (const ShapeKind shape : all_shapes)
        for (const bool perfect : {false, true})
            for (int k = 2; k <= 8; ++k) {
                const Step end(scene_with(shape, transfer(TransferScheme::xpic, k), perfect), 10 + k, perfect);
                const Oracle& o = end.oracle;
                const MatrixXd V = o.filtered(k) + o.d.S * (o.v_end - o.v);
                end.expect(V, o.X + o.dt * o.d.S * o.v_end);
                const Step start(
                    scene_with(shape, transfer(TransferScheme::xpic, k, PositionUpdate::start_velocity), perfect),
                    10 + k, perfect);
                start.expect(V, o.X + o.dt * (o.d.S * o.v + 0.5 * (V - o.V)));
            }
}

TEST(DenseStep, XpicOfOrderOneIsPic) {
    const Step xpic(scene_with(ShapeKind::cpdi, transfer(TransferScheme::xpic, 1), true), 3, true);
    const Step pic(scene_with(ShapeKind::cpdi, transfer(TransferScheme::pic), true), 3, true);
    for (std::size_t p = 0; p < pic.state.particles.size(); ++p)
        EXPECT_EQ(xpic.state.particles.velocity[p], pic.state.particles.velocity[p]);
}

/// Eq. (1) of the FMPM paper, binomial coefficients and all, on the grid: another way to the same filter.
TEST(DenseStep, FilterEqualsTheExpandedMassMatrixInverse) {
    for (int k = 2; k <= 8; ++k) {
        const Step r(scene_with(ShapeKind::ugimp, transfer(TransferScheme::xpic, k)), 30 + k, false);
        const Dense& d = r.oracle.d;
        MatrixXd term = d.S_plus * r.oracle.V; // (S+ S)^(l-1) m^-1 p
        MatrixXd sum = MatrixXd::Zero(term.rows(), 2);
        double binomial = 1;
        for (int l = 1; l <= k; ++l) {
            binomial *= (k + 1.0 - l) / l;
            sum += (l % 2 ? 1 : -1) * binomial * term;
            term = d.S_plus * (d.S * term);
        }
        for (Eigen::Index slot = 0; slot < sum.rows(); ++slot) {
            if (!(d.m[slot] > 0)) continue;
            EXPECT_LT((vector_of<2>(r.state.nodes.filtered[slot]) - sum.row(slot).transpose()).norm(), 1e-10);
        }
    }
}

/// With a law that is not perfect Δv comes from the contact pass; what becomes of it is Eq. (37).
TEST(DenseStep, XpicUsesTheVelocityChangeOfTheFirstContactPass) {
    int changed = 0;
    for (int k = 2; k <= 6; ++k) {
        Step r(
            [&](Scene& s) {
                scene_with(ShapeKind::cpdi, transfer(TransferScheme::xpic, k))(s);
                s.contact = contact(LawType::friction, 0.3);
            },
            50 + k, false);
        Oracle o = r.oracle;
        const auto& nodes = r.state.nodes;
        for (Eigen::Index slot = 0; slot < o.v.rows(); ++slot) {
            const Vec<2> delta = vector_of<2>(nodes.delta_velocity[slot]);
            EXPECT_LT((vector_of<2>(nodes.velocity[slot]) - o.v.row(slot).transpose() - delta).norm(), 1e-12);
            o.delta.row(slot) = delta.transpose();
            o.v.row(slot) += delta.transpose();
            o.v_end.row(slot) = vector_of<2>(nodes.end_velocity[slot]).transpose();
            changed += !delta.isZero(1e-9);
        }
        const MatrixXd V = o.filtered(k) + o.d.S * (o.v_end - o.v);
        expect_rows(r.state.particles.velocity, V, 1e-10, "velocity");
    }
    EXPECT_GT(changed, 20);
}

} // namespace

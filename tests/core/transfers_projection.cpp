/// The approximate inverse of the full mass matrix: what it converges to, what it keeps (FMPM paper §2.2).

#include "dense_step.h"

namespace {

using namespace test;

/// A block of 16 particles a cell in its middle, velocities at random: more particles than nodes, no empty corners.
State<2> filled_block(ShapeKind shape, TransferSpec t, bool stressed = false) {
    Scene scene = plane_scene(1, 0, 0, 6, 6, material(2, 100, 40));
    scene.method.shape = shape;
    scene.method.transfer = t;
    Model model;
    add_box(model, add_body(model, "a"), 1, 1, 5, 5, 16, 16);
    State<2> state = make_state<2>(scene, model);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> in(-0.5, 0.5);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.velocity[p] = Vec<2>(in(random), in(random));
        if (stressed)
            for (int c = 0; c < 4; ++c) state.particles.stress[p][c] = 50 * in(random);
    }
    state.dt = 0.01;
    find_velocity_fields(state);
    return state;
}

State<2> stepped(State<2> state) {
    auto tasks = step_tasks<2>(state.scene);
    advance(state, tasks);
    return state;
}

/// Root of m-weighted squares, the norm in which S+ S is symmetric.
double mass_norm(const Eigen::VectorXd& m, const MatrixXd& v) {
    return std::sqrt((v.rowwise().squaredNorm().array() * m.array()).sum());
}

TEST(FullMassMatrix, TheSeriesConvergesToItsInverse) {
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::cpdi, ShapeKind::b2cpdi}) {
        const State<2> before = filled_block(shape, transfer(TransferScheme::fmpm, 1));
        const Dense<2> d(before);
        const MatrixXd V = rows_of<2>(before.particles.velocity);
        const MatrixXd p = d.S.transpose() * d.M.asDiagonal() * V;
        // The nodes that have mass: the full mass matrix has no inverse at the others.
        std::vector<Eigen::Index> active;
        for (Eigen::Index i = 0; i < d.m.size(); ++i)
            if (d.m[i] > 0) active.push_back(i);
        const MatrixXd full = (d.S.transpose() * d.M.asDiagonal() * d.S)(active, active);
        const MatrixXd exact = full.ldlt().solve(MatrixXd(p(active, Eigen::all)));
        ASSERT_LT((full * exact - p(active, Eigen::all)).norm(), 1e-9 * p.norm());
        const Eigen::VectorXd m = d.m(active);
        const Eigen::VectorXd rate =
            Eigen::SelfAdjointEigenSolver<MatrixXd>(m.cwiseSqrt().cwiseInverse().asDiagonal() * full *
                                                    m.cwiseSqrt().cwiseInverse().asDiagonal())
                .eigenvalues();
        EXPECT_GT(rate.minCoeff(), 0);
        EXPECT_LT(rate.maxCoeff(), 1 + 1e-12) << "the series converges";
        const MatrixXd S = d.S(Eigen::all, active);
        double previous = INFINITY;
        double on_particles = INFINITY;
        std::printf("[ figures  ] error of m_k^-1 p on nodes, of its S on particles, %s:", name_of(shape));
        for (const int k : {1, 2, 4, 8, 16, 32, 64}) {
            const State<2> after = stepped(filled_block(shape, transfer(TransferScheme::fmpm, k)));
            const std::vector<Pack>& end = k > 1 ? after.nodes.filtered : after.nodes.end_velocity;
            const MatrixXd found = rows_of<2>(end)(active, Eigen::all);
            const double error = mass_norm(m, found - exact) / mass_norm(m, exact);
            // The error is A^k times the solution: no slower than the slowest mode, no faster than the fastest.
            EXPECT_LT(error, previous);
            EXPECT_LE(error, std::pow(1 - rate.minCoeff(), k) * (1 + 1e-9));
            previous = error;
            const double smaller = mass_norm(d.M, S * (found - exact)) / mass_norm(d.M, S * exact);
            EXPECT_LT(smaller, on_particles);
            on_particles = smaller;
            std::printf(" k=%d %.1e, %.1e;", k, error, smaller);
        }
        std::printf(" (smallest eigenvalue of S+S %.1e)\n", rate.minCoeff());
        // Splines see nodes outside the block with next to no mass: of random velocities
        // these get values that no series of a few terms reaches.
        EXPECT_LT(on_particles, shape == ShapeKind::b2cpdi ? 0.6 : 1e-4);
        if (shape != ShapeKind::b2cpdi) {
            EXPECT_LT(previous, 1e-3);
        }
    }
}

/// Eq. (1), binomial coefficients and all: another way to the same series.
TEST(FullMassMatrix, TheSweepsAreTheExpandedSeries) {
    for (const TransferScheme scheme : {TransferScheme::xpic, TransferScheme::fmpm})
        for (int k = 2; k <= 8; ++k) {
            const Step<2> r(scene_with(ShapeKind::b2gimp, transfer(scheme, k)), 30 + k);
            const Dense<2>& d = r.oracle.d;
            MatrixXd term = scheme == TransferScheme::fmpm ? r.oracle.v_end : r.oracle.v; // (S+ S)^(l-1) m^-1 p
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

/// P_X V = S m_k^-1 p: without forces XPIC's particles get what FMPM's get, and both I − (I − S S+)^k.
TEST(FullMassMatrix, WithoutForcesXpicAndFmpmProjectAlike) {
    for (const ShapeKind shape : all_shapes)
        for (int k = 2; k <= 5; ++k) {
            const State<2> before = filled_block(shape, transfer(TransferScheme::xpic, k));
            const Dense<2> d(before);
            const MatrixXd V = rows_of<2>(before.particles.velocity);
            MatrixXd rest = V;
            for (int i = 0; i < k; ++i) rest -= (d.S * (d.S_plus * rest)).eval();
            const MatrixXd xpic = rows_of<2>(stepped(before).particles.velocity);
            const MatrixXd fmpm =
                rows_of<2>(stepped(filled_block(shape, transfer(TransferScheme::fmpm, k))).particles.velocity);
            EXPECT_LT((xpic - (V - rest)).norm(), 1e-12 * V.norm());
            EXPECT_LT((fmpm - (V - rest)).norm(), 1e-12 * V.norm());
        }
}

TEST(FullMassMatrix, MomentumIsKeptToRoundOff) {
    for (const ShapeKind shape : all_shapes)
        for (const TransferScheme scheme : {TransferScheme::xpic, TransferScheme::fmpm})
            for (const int k : {1, 2, 5}) {
                const State<2> before = filled_block(shape, transfer(scheme, k), true);
                const State<2> after = stepped(before);
                Vec<2> change(0, 0);
                double moved = 0;
                double mass = 0;
                for (std::size_t p = 0; p < before.particles.size(); ++p) {
                    const Vec<2> dv = after.particles.velocity[p] - before.particles.velocity[p];
                    change += before.particles.mass[p] * dv;
                    moved += before.particles.mass[p] * dv.norm();
                    mass += before.particles.mass[p];
                }
                EXPECT_LT(change.norm(), 1e-13 * mass) << name_of(shape) << k;
                EXPECT_GT(moved, 0.01 * mass);
            }
}

/// Affine velocities are in no null space: a filter of any order leaves them where the body is filled.
TEST(FullMassMatrix, AUniformVelocityPassesEveryOrder) {
    for (const TransferScheme scheme : {TransferScheme::xpic, TransferScheme::fmpm})
        for (const int k : {1, 2, 8}) {
            State<2> state = filled_block(ShapeKind::b2cpdi, transfer(scheme, k));
            for (auto& v : state.particles.velocity) v = Vec<2>(0.3, -0.7);
            for (const auto& v : stepped(state).particles.velocity) EXPECT_LT((v - Vec<2>(0.3, -0.7)).norm(), 1e-13);
        }
}

} // namespace

#include "support.h"

#include "contact/law/contact_law.h"
#include "contact/separation/critical_position.h"
#include "contact/separation/fitted_position.h"
#include "contact/separation/particle_edges.h"

#include <Eigen/Dense>

namespace {

using namespace test;

/// Two bodies at a node before and after a law's momentum change.
struct Node {
    double ma, mb;
    Vec<2> va, vb, n;
    Vec<2> impulse;

    Node(std::mt19937& random, const LawSpec& law, bool touching) {
        std::uniform_real_distribution<double> in(-1, 1);
        ma = std::exp(4 * in(random));
        mb = std::exp(4 * in(random));
        va = {in(random), in(random)};
        vb = {in(random), in(random)};
        n = Vec<2>(in(random), in(random)).normalized();
        // Δp(0) = m_a (v_cm − v_a)
        Meeting<2> at;
        at.stick = ma * ((ma * va + mb * vb) / (ma + mb) - va);
        at.normal = n;
        at.mass = ma * mb / (ma + mb);
        at.dt = 0.1;
        at.area = 0.7;
        at.cell = 1;
        at.separation = touching ? -1 : 1;
        impulse = apply_law<2>(make_contact_law(law), at).impulse;
    }
    Vec<2> before() const { return vb - va; }
    Vec<2> after() const { return vb - impulse / mb - va - impulse / ma; }
    bool approaching() const { return before().dot(n) < 0; }
    double scale() const { return before().norm() * (1 + ma / mb + mb / ma); }
};

TEST(Laws, NothingHappensApartOrWithoutCompression) {
    std::mt19937 random(1);
    for (const LawType type : {LawType::frictionless, LawType::friction, LawType::stick})
        for (int trial = 0; trial < 300; ++trial) {
            EXPECT_TRUE(Node(random, {type, 0.3}, false).impulse.isZero(0));
            const Node node(random, {type, 0.3}, true);
            if (node.approaching()) {
                EXPECT_LT(node.impulse.dot(node.n), 0) << "pushes a back";
            } else {
                EXPECT_TRUE(node.impulse.isZero(0)) << "no tension";
            }
        }
}

TEST(Laws, PerfectBodiesMoveTogetherAlwaysAndStickingOnesInContact) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 300; ++trial) {
        const Node perfect(random, {LawType::perfect, 0}, trial % 2 == 0);
        EXPECT_LT(perfect.after().norm(), 1e-13 * perfect.scale());
        const Node stick(random, {LawType::stick, 0}, true);
        if (stick.approaching()) {
            EXPECT_LT(stick.after().norm(), 1e-13 * stick.scale());
        }
    }
}

TEST(Laws, FrictionlessBodiesKeepTheirSlidingVelocity) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const Node node(random, {LawType::frictionless, 0}, true);
        if (!node.approaching()) continue;
        EXPECT_NEAR(node.after().dot(node.n), 0, 1e-13 * node.scale());
        const Vec<2> t(-node.n[1], node.n[0]);
        EXPECT_NEAR(node.after().dot(t), node.before().dot(t), 1e-13 * node.scale());
    }
}

TEST(Laws, CoulombFrictionSticksOrSlidesAtItsLimit) {
    std::mt19937 random(4);
    int stuck = 0;
    int slid = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const double mu = 0.001 * (trial % 1000);
        const Node node(random, {LawType::friction, mu}, true);
        if (!node.approaching()) continue;
        const Vec<2> t(-node.n[1], node.n[0]);
        const double normal = -node.impulse.dot(node.n);
        const double tangential = node.impulse.dot(t);
        EXPECT_NEAR(node.after().dot(node.n), 0, 1e-13 * node.scale());
        EXPECT_LE(std::abs(tangential), mu * normal * (1 + 1e-12) + 1e-300);
        const double reduced = node.ma * node.mb / (node.ma + node.mb);
        if (std::abs(node.before().dot(t)) * reduced <= mu * normal) {
            ++stuck;
            EXPECT_LT(node.after().norm(), 1e-13 * node.scale());
        } else {
            ++slid;
            // At the limit, against the sliding; not so far that the sliding turns round.
            EXPECT_NEAR(std::abs(tangential), mu * normal, 1e-12 * normal);
            EXPECT_GT(node.after().dot(t) * node.before().dot(t), 0);
            EXPECT_LE(std::abs(node.after().dot(t)), std::abs(node.before().dot(t)));
        }
    }
    EXPECT_GT(stuck, 100);
    EXPECT_GT(slid, 100);
}

TEST(Laws, TheTableKnowsPairsInEitherOrder) {
    LawTable table;
    table.standard = Friction{0.1, 0.1};
    table.pairs = {{0, 2, Stick{}}, {0, 5, ViscousFriction{0.3, 2}}, {1, 3, Perfect{}}};
    EXPECT_TRUE(std::holds_alternative<Stick>(table.between(0, 2)));
    EXPECT_TRUE(std::holds_alternative<Stick>(table.between(2, 0)));
    EXPECT_TRUE(std::holds_alternative<ViscousFriction>(table.between(5, 0)));
    EXPECT_TRUE(is_perfect(table.between(3, 1)));
    EXPECT_TRUE(std::holds_alternative<Friction>(table.between(0, 1)));
    EXPECT_EQ(std::get<Friction>(table.between(2, 3)).kinetic, 0.1);
}

/// The largest extent along n of the ellipsoid inscribed in a particle, by sampling its outline.
double extent_by_sampling(const Mat<2>& F, const Vec<2>& half, const Vec<2>& n) {
    double largest = 0;
    for (int i = 0; i < 200000; ++i) {
        const double a = 2 * M_PI * i / 200000;
        largest = std::max(largest, (F * Vec<2>(half[0] * std::cos(a), half[1] * std::sin(a))).dot(n));
    }
    return largest;
}

TEST(Separations, EdgeDistanceIsTheExtentOfTheDeformedEllipsoid) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int trial = 0; trial < 10; ++trial) {
        const Mat<2> F = random_deformation<2>(random, 0.9);
        const Vec<2> half(0.5 + 0.4 * in(random), 0.5 + 0.4 * in(random));
        const Vec<2> n = Vec<2>(in(random), in(random)).normalized();
        const double R = edge_distance<2>(F, half, n);
        EXPECT_NEAR(R, extent_by_sampling(F, half, n), 1e-9);
        EXPECT_LE(edge_distance_along_ray<2>(F, half, n), R * (1 + 1e-14));
    }
}

TEST(Separations, RowsOfDeformedParticlesEndAtTheEdge) {
    // A row along an edge of undeformed normal N, N an axis: after any F the edge lies R0/|F^-T N| from the centres.
    std::mt19937 random(6);
    for (int trial = 0; trial < 200; ++trial) {
        const Mat<2> F = random_deformation<2>(random, 0.9);
        const Vec<2> half(0.3, 0.7);
        for (int axis = 0; axis < 2; ++axis) {
            const Vec<2> carried = F.inverse().transpose().col(axis);
            EXPECT_NEAR(edge_distance<2>(F, half, carried.normalized()), half[axis] / carried.norm(), 1e-13);
        }
    }
    Mat<2> shear;
    shear << 1, 0.8, 0, 1;
    EXPECT_NEAR(edge_distance<2>(shear, {0.5, 0.5}, {0, 1}), 0.5, 1e-15);
    EXPECT_NEAR(edge_distance_along_ray<2>(shear, {0.5, 0.5}, {0, 1}), 0.5 / std::sqrt(1 + 0.8 * 0.8), 1e-15);
}

TEST(Separations, FromExtrapolatedPositions) {
    EXPECT_NEAR(critical_position(-0.4, 0.45, 0.8), 0.05, 1e-15);
    EXPECT_NEAR(critical_position(-0.4, 0.3, 0.8), -0.1, 1e-15);
    // notes 3.51: d = 2 (x/1.25)^0.58 − 1 on either side; two edges at the node: x = ±1.25 (1/2)^(1/0.58).
    const double at_node = 1.25 * std::pow(0.5, 1 / 0.58);
    EXPECT_NEAR(fitted_position(-at_node, at_node, 0.58), 0, 1e-14);
    EXPECT_NEAR(fitted_position(-1.25, at_node, 0.58), 1, 1e-14);
    EXPECT_NEAR(fitted_position(-1.25, 1.25, 0.58), 2, 1e-14);
    EXPECT_NEAR(fitted_position(-0.3, 0.7, 0.5), 2 * std::sqrt(0.7 / 1.25) + 2 * std::sqrt(0.3 / 1.25) - 2, 1e-14);
    EXPECT_NEAR(fitted_position(0.2, -0.1, 0.58), -2, 1e-14) << "on the wrong side of the node";
}

} // namespace

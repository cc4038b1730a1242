/// Looking into contact nodes leaves a run as it is; nodes where methods disagree, and the nearest one.

#include "contact_inspect.h"

#include <map>
#include <set>
#include <tuple>

namespace {

using namespace test;

constexpr auto particle_edges = 0;

/// A run that is looked into goes on as one that isn't, bit for bit.
TEST(InspectContact, LeavesTheRunAsItIs) {
    for (const NormalMethod normal : {NormalMethod::logistic_regression, NormalMethod::own_gradient}) {
        const auto end = [&](bool inspect) {
            State<2> state = random_bodies<2>(normal, SeparationMethod::particle_edges, ThreeOrMore::up_to_two);
            state.contact.cloud_capacity = 4; // grows in every search
            int steps = 0;
            run(state, 1, [&] {
                if (++steps % 3) return;
                look(state);
                if (!inspect) return;
                const PointFrame before = contact_frame(state);
                const Contact<2> contact = state.contact;
                inspect_contact<2>(state, all_nodes(state));
                nodes_in_disagreement(state, 0.01);
                EXPECT_EQ(state.contact.points.size(), contact.points.size());
                const PointFrame after = contact_frame(state);
                for (std::size_t i = 0; i < before.arrays.size(); ++i)
                    EXPECT_EQ(before.arrays[i].values, after.arrays[i].values) << before.arrays[i].name;
            });
            EXPECT_GT(steps, 6);
            return state;
        };
        const State<2> a = end(false);
        const State<2> b = end(true);
        EXPECT_EQ(a.step, b.step);
        EXPECT_EQ(a.particles.position, b.particles.position);
        EXPECT_EQ(a.particles.velocity, b.particles.velocity);
        EXPECT_EQ(a.particles.stress, b.particles.stress);
        EXPECT_EQ(a.ledger.contact_work, b.ledger.contact_work);
        EXPECT_EQ(b.scene.contact->normal, normal);
        EXPECT_EQ(b.scene.contact->separation, SeparationMethod::particle_edges);
    }
}

TEST(Disagreements, AreThoseOfTheRowsSideBySide) {
    for (const NormalMethod own : {NormalMethod::logistic_regression, NormalMethod::own_gradient}) {
        State<2> state = random_bodies<2>(own, SeparationMethod::particle_edges, ThreeOrMore::explicit_);
        const double limit = 0.4;
        std::map<Index<2>, double> expected;
        for (const NodeSeen<2>& node : inspect_contact<2>(state, all_nodes(state)))
            for (const PointSeen<2>& point : node.points) {
                if (!(point.chosen().separation[particle_edges] < disagreement_reach)) continue;
                for (const PlaneSeen<2>& p : point.planes)
                    for (const PlaneSeen<2>& q : point.planes) {
                        if (p.fitted.isZero(0) || q.fitted.isZero(0)) continue;
                        if (own != NormalMethod::own_gradient &&
                            (p.method == NormalMethod::own_gradient || q.method == NormalMethod::own_gradient))
                            continue;
                        const double angle = std::acos(std::clamp(p.fitted.dot(q.fitted), -1.0, 1.0));
                        if (angle > limit) expected[node.node] = std::max(expected[node.node], angle);
                    }
            }
        const auto found = nodes_in_disagreement(state, limit);
        EXPECT_GT(found.size(), 3U);
        EXPECT_LT(found.size(), state.contact.groups.size());
        EXPECT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_NEAR(found[i].angle, expected[found[i].node], 1e-6);
            if (i > 0) {
                EXPECT_LE(found[i].angle, found[i - 1].angle);
            }
        }
    }
}

/// With up-to-two a node has points of pairs and of bodies lumped; forces act at one kind only, that of contact.pvd.
TEST(Disagreements, AreOfPointsWhoseForcesAct) {
    State<2> state =
        random_bodies<2>(NormalMethod::logistic_regression, SeparationMethod::particle_edges, ThreeOrMore::up_to_two);
    const Vec<2> together[] = {{0.3, 0.1}, {-0.3, 0.1}, {0, -0.4}};
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.velocity[p] = together[state.particles.body[p]];
    std::size_t lumped = 0, pairs = 0, compared = 0;
    int steps = 0;
    run(state, 1, [&] {
        if (++steps % 3) return;
        look(state);
        std::map<Index<2>, std::set<std::tuple<int, int, double>>> in_use;
        for (const ContactGroup<2>& group : state.contact.groups) {
            const bool both = group.first_lumped < group.last_lumped;
            lumped += both && group.uses_lumped;
            pairs += both && !group.uses_lumped;
            for (std::int32_t i = group.uses_lumped ? group.first_lumped : group.first_point;
                 i < (group.uses_lumped ? group.last_lumped : group.last_point); ++i) {
                const ContactPoint<2>& point = state.contact.points[i];
                in_use[in_scene<2>(group.node)].insert({point.body_a, point.body_b, point.separation});
            }
        }
        for (const Disagreement<2>& one : nodes_in_disagreement(state, 0)) {
            EXPECT_TRUE(in_use[one.node].count({one.body_a, one.body_b, one.separation}))
                << one.node[0] << " " << one.node[1] << " " << one.body_a << " " << one.body_b;
            ++compared;
        }
    });
    EXPECT_GT(lumped, 0U);
    EXPECT_GT(pairs, 0U);
    EXPECT_GT(compared, 10U);
}

TEST(Disagreements, AreNoneWhereAllAgreeOrBodiesAreFarApart) {
    State<2> near = two_blocks(0.1);
    for (const Disagreement<2>& one : nodes_in_disagreement(near, 1e-6))
        EXPECT_TRUE(one.node[0] <= 1 || one.node[0] >= 7) << "at the blocks' corners only";
    State<2> far = two_blocks(0.9);
    EXPECT_FALSE(far.contact.groups.empty());
    EXPECT_TRUE(nodes_in_disagreement(far, 0).empty());
}

TEST(NearestContactNode, IsThatOfBruteForce) {
    const State<2> state = two_blocks(0.1);
    EXPECT_EQ(nearest_contact_node<2>(state, {4.4, 0}), (Index<2>{4, 4}));
    EXPECT_EQ(nearest_contact_node<2>(state, {-50, 4.2})->at(1), 4);
    const State<2> apart = two_blocks(3.9);
    EXPECT_FALSE(nearest_contact_node<2>(apart, {4, 4}));
}

TEST(AngleBetween, IsAccurateForSmallAndLargeAngles) {
    EXPECT_NEAR(angle_between<2>({2, 0}, {3, 3e-9}), 1e-9, 1e-22);
    EXPECT_NEAR(angle_between<2>({2, 0}, {-1, 0}), M_PI, 1e-15);
    EXPECT_NEAR(angle_between<3>({0, 0, 5}, {0, 1, 0}), M_PI / 2, 1e-15);
    EXPECT_TRUE(std::isnan(angle_between<2>({0, 0}, {1, 0})));
}

} // namespace

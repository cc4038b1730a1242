/// Contact nodes taken apart: against closed forms, brute force over the particles, and the run's own contacts.

#include "support.h"

#include "contact/inspect.h"
#include "contact/separation/particle_edges.h"
#include "results/frames.h"

#include <cstring>
#include <set>

namespace {

using namespace test;

constexpr auto particle_edges = 0, critical_position = 1, displacement = 3;

/// Two blocks of 2 x 2 particles a cell with their faces at y = 4 − gap/2 and 4 + gap/2, a cell being 1.
State<2> two_blocks(double gap, NormalMethod normal = NormalMethod::logistic_regression,
                    SeparationMethod separation = SeparationMethod::particle_edges) {
    Scene scene = plane_scene(1, 0, 0, 8, 8, material(1, 10, 3));
    scene.method.shape = ShapeKind::ugimp;
    scene.contact = contact(LawType::frictionless);
    scene.contact->normal = normal;
    scene.contact->separation = separation;
    Model model;
    add_box(model, add_body(model, "lower"), 1, 2 - gap / 2, 7, 4 - gap / 2, 12, 4);
    add_box(model, add_body(model, "upper"), 1, 4 + gap / 2, 7, 6 + gap / 2, 12, 4);
    State<2> state = make_state<2>(scene, model);
    look(state);
    return state;
}

const PlaneSeen<2>& plane_of(const PointSeen<2>& point, NormalMethod method) {
    return *std::find_if(point.planes.begin(), point.planes.end(),
                         [&](const PlaneSeen<2>& plane) { return plane.method == method; });
}

TEST(InspectContact, BlocksWithAGapHaveItsNormalAndWidthByAllMethods) {
    for (const double gap : {0.3, 0.1, 0.0, -0.1}) {
        State<2> state = two_blocks(gap);
        const std::vector<NodeSeen<2>> seen = inspect_contact<2>(state, {{4, 4}});
        ASSERT_EQ(seen.size(), 1U);
        EXPECT_EQ(seen[0].node, (Index<2>{4, 4}));
        EXPECT_NEAR((seen[0].position - Vec<2>(4, 4)).norm(), 0, 1e-14);
        ASSERT_EQ(seen[0].points.size(), 1U);
        const PointSeen<2>& point = seen[0].points[0];
        EXPECT_EQ(point.body_a, 0);
        EXPECT_EQ(point.body_b, 1);
        EXPECT_FALSE(point.lumped);
        std::vector<NormalMethod> methods;
        for (const PlaneSeen<2>& plane : point.planes) {
            methods.push_back(plane.method);
            EXPECT_NEAR((plane.normal - Vec<2>(0, 1)).norm(), 0, 1e-9) << static_cast<int>(plane.method);
            EXPECT_NEAR((plane.fitted - Vec<2>(0, 1)).norm(), 0, 1e-9);
            EXPECT_NEAR(plane.angle, 0, 1e-9);
            EXPECT_NEAR(plane.end_a, -gap / 2, 1e-12);
            EXPECT_NEAR(plane.end_b, gap / 2, 1e-12);
            EXPECT_NEAR(plane.place(), 0, 1e-12);
            EXPECT_NEAR(plane.separation[particle_edges], gap, 1e-9);
            EXPECT_NEAR(plane.separation[displacement], 0, 1e-12) << "nothing has moved yet";
            EXPECT_EQ(plane.chosen, plane.method == NormalMethod::logistic_regression);
            EXPECT_EQ(plane.iterations > 0, plane.method <= NormalMethod::irls_regression);
        }
        EXPECT_EQ(methods, (std::vector{NormalMethod::logistic_regression, NormalMethod::linear_regression,
                                        NormalMethod::irls_regression, NormalMethod::average_gradient,
                                        NormalMethod::maximum_gradient, NormalMethod::maximum_volume,
                                        NormalMethod::own_gradient}))
            << "specified is not the scene's own";
    }
}

/// uGIMP's mean positions of a half space filled by layers at half the particle size from the face, by hand: layers at
/// 0.25 and 0.75 (and 1.25, which reaches the node with half of its domain) above a face through the node.
TEST(InspectContact, CriticalPositionIsThatOfItsDefinition) {
    State<2> state = two_blocks(0);
    const NodeSeen<2> seen = inspect_contact<2>(state, {{4, 4}})[0];
    const auto mean = [](double low, double high) { // of the hat over a domain
        const auto integral = [](double x) { return x < 1 ? x - x * x / 2 : 0.5; };
        return (integral(high) - integral(low)) / (high - low);
    };
    const double s1 = mean(0, 0.5), s2 = mean(0.5, 1);
    const double x = (s1 * 0.25 + s2 * 0.75) / (s1 + s2);
    EXPECT_NEAR(plane_of(seen.points[0], NormalMethod::average_gradient).separation[critical_position], 2 * x - 0.8,
                1e-9);
}

/// Blocks turned together by any angle, off the grid: normal and gap are known, whatever the grid sees.
TEST(InspectContact, TurnedBlocksKeepTheirNormalAndGap) {
    const double angle = 0.4;
    const double gap = 0.12;
    const Vec<2> n(-std::sin(angle), std::cos(angle));
    const Vec<2> t(std::cos(angle), std::sin(angle));
    Scene scene = plane_scene(1, 0, 0, 16, 16, material(1, 10, 3));
    scene.method.shape = ShapeKind::cpdi;
    scene.contact = contact(LawType::frictionless);
    Model model;
    add_body(model, "lower");
    add_body(model, "upper");
    for (int side = 0; side < 2; ++side)
        for (int i = -6; i < 6; ++i)
            for (int j = 0; j < 6; ++j) {
                const double along = 0.5 * (i + 0.5);
                const double up = (side == 0 ? -1 : 1) * (gap / 2 + 0.5 * (j + 0.5));
                const Vec<2> x = Vec<2>(8.13, 8.29) + along * t + up * n;
                add_particle(model, side, x[0], x[1], 0.25, 0.25);
                model.angle.push_back(angle);
            }
    State<2> state = make_state<2>(scene, model);
    look(state);
    const auto node = nearest_contact_node<2>(state, {8.13, 8.29});
    ASSERT_TRUE(node);
    EXPECT_EQ(*node, (Index<2>{8, 8}));
    const NodeSeen<2> seen = inspect_contact<2>(state, {*node})[0];
    const PlaneSeen<2>& chosen = seen.points.at(0).chosen();
    EXPECT_LT(angle_between<2>(chosen.normal, n), 1e-2);
    EXPECT_NEAR(chosen.separation[particle_edges], gap, 2e-3); // the search for the widest gap ends at 1e-3 cells
    // Along the true normal, the sides end where the blocks do.
    const double to_face = (Vec<2>(8.13, 8.29) - Vec<2>(8, 8)).dot(n);
    EXPECT_NEAR(chosen.place(), to_face, 5e-3);
    for (const ParticleSeen<2>& particle : seen.points[0].cloud)
        EXPECT_NEAR(particle.distance, (particle.position - Vec<2>(8.13, 8.29)).dot(n), 0.05);
}

/// Three bodies at random deformation, so that nothing is symmetric.
template <int D>
State<D> random_bodies(NormalMethod normal, SeparationMethod separation, ThreeOrMore three, bool rigid = false) {
    Scene scene = D == 2 ? plane_scene(1, 0, 0, 10, 10, material(1, 10, 3)) : space_scene(1, 0, 8, material(1, 10, 3));
    scene.method.shape = ShapeKind::ugimp;
    scene.contact = contact(LawType::friction, 0.3);
    scene.contact->normal = normal;
    scene.contact->separation = separation;
    scene.contact->three_or_more = three;
    scene.contact->direction = {0.6, -1.2, 0};
    Model model;
    for (const char* name : {"left", "right", "upper"})
        add_body(model, name, {0.01 * double(model.bodies.size()), 0, 0});
    if constexpr (D == 2) {
        add_box(model, 0, 2.2, 2.4, 5.2, 5.4, 6, 6);
        add_box(model, 1, 5.25, 2.3, 8.25, 5.3, 6, 6);
        add_box(model, 2, 3.3, 5.45, 7.3, 8.45, 8, 6);
    } else {
        add_cube(model, 0, {1.9, 2.1, 2.2}, 2, 4);
        add_cube(model, 1, {3.95, 2.2, 2.3}, 2, 4);
        add_cube(model, 2, {2.9, 4.2, 2.1}, 2, 4);
    }
    if (rigid) {
        RigidSpec motion;
        motion.velocity[0] = 0.1;
        model.bodies[1].rigid = motion;
        model.bodies[1].material = -1;
        scene.bodies.resize(1);
        scene.bodies[0].rigid = motion; // so that the scene's effects know of it
    }
    State<D> state = make_state<D>(scene, model);
    std::mt19937 random(1);
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (!rigid || state.particles.body[p] != 1)
            state.particles.deformation_gradient[p] = random_deformation<D>(random, 0.1);
    look(state);
    return state;
}

template <int D>
Index<D> in_scene(Index<D> node) {
    for (int& i : node) i -= grid_margin;
    return node;
}

template <int D>
std::vector<Index<D>> all_nodes(const State<D>& state) {
    std::vector<Index<D>> nodes;
    for (const ContactGroup<D>& group : state.contact.groups) nodes.push_back(in_scene<D>(group.node));
    return nodes;
}

/// For each method chosen by the scene, its own row is what `look` found, bit for bit, and in every other scene the row
/// of that method says the same.
template <int D>
void check_rows(ThreeOrMore three, bool rigid) {
    const NormalMethod methods[] = {NormalMethod::logistic_regression, NormalMethod::linear_regression,
                                    NormalMethod::irls_regression,     NormalMethod::average_gradient,
                                    NormalMethod::maximum_gradient,    NormalMethod::maximum_volume};
    State<D> other = random_bodies<D>(NormalMethod::average_gradient, SeparationMethod::particle_edges, three, rigid);
    const std::vector<NodeSeen<D>> elsewhere = inspect_contact<D>(other, all_nodes(other));
    std::size_t three_at_once = 0;
    for (const NormalMethod method : methods)
        for (std::size_t s = 0; s < inspected_separations.size(); ++s) {
            State<D> state = random_bodies<D>(method, inspected_separations[s], three, rigid);
            const std::vector<NodeSeen<D>> seen = inspect_contact<D>(state, all_nodes(state));
            ASSERT_EQ(seen.size(), state.contact.groups.size());
            ASSERT_EQ(seen.size(), elsewhere.size());
            for (std::size_t g = 0; g < seen.size(); ++g) {
                const ContactGroup<D>& group = state.contact.groups[g];
                three_at_once += group.last - group.first > 2;
                ASSERT_EQ(seen[g].points.size(), static_cast<std::size_t>(group.last_lumped - group.first_point));
                for (std::size_t i = 0; i < seen[g].points.size(); ++i) {
                    const ContactPoint<D>& expected = state.contact.points[group.first_point + i];
                    const PointSeen<D>& point = seen[g].points[i];
                    const PlaneSeen<D>& chosen = point.chosen();
                    EXPECT_EQ(chosen.method, method);
                    EXPECT_EQ(point.body_a, expected.body_a);
                    EXPECT_EQ(point.body_b, expected.body_b);
                    EXPECT_EQ(point.lumped, expected.slot_b < 0);
                    EXPECT_EQ(chosen.normal, expected.normal);
                    EXPECT_EQ(chosen.separation[s], expected.separation);
                    EXPECT_EQ(chosen.iterations, expected.iterations);
                    const auto same =
                        std::find_if(elsewhere[g].points[i].planes.begin(), elsewhere[g].points[i].planes.end(),
                                     [&](const PlaneSeen<D>& plane) { return plane.method == method; });
                    EXPECT_EQ(same->fitted, chosen.fitted);
                    EXPECT_EQ(same->separation, chosen.separation);
                }
            }
        }
    EXPECT_GT(three_at_once, 0U);
}

TEST(InspectContact, RowsAreWhatTheMethodsFindWhenChosen) {
    for (const ThreeOrMore three : {ThreeOrMore::explicit_, ThreeOrMore::lumped, ThreeOrMore::up_to_two})
        check_rows<2>(three, false);
}
TEST(InspectContact, RowsAreWhatTheMethodsFindWhenChosenInSpace) {
    check_rows<3>(ThreeOrMore::explicit_, false);
}
TEST(InspectContact, RowsAreWhatTheMethodsFindWhenChosenAtARigidBody) {
    check_rows<2>(ThreeOrMore::explicit_, true);
}

/// Where a scene's own points are pairs, the row of own-gradient is that of body a alone; where they are bodies alone,
/// those of pairs are found for each, and turned round where a and b change places.
TEST(InspectContact, OwnGradientsArePutBesidePairs) {
    using N = NormalMethod;
    State<2> pairs = random_bodies<2>(N::logistic_regression, SeparationMethod::particle_edges, ThreeOrMore::explicit_);
    State<2> own = random_bodies<2>(N::own_gradient, SeparationMethod::particle_edges, ThreeOrMore::explicit_);
    const auto of_pairs = inspect_contact<2>(pairs, all_nodes(pairs));
    const auto of_own = inspect_contact<2>(own, all_nodes(own));
    ASSERT_EQ(of_pairs.size(), of_own.size());
    int turned = 0;
    for (std::size_t g = 0; g < of_own.size(); ++g) {
        for (const PointSeen<2>& pair : of_pairs[g].points)
            for (const PointSeen<2>& single : of_own[g].points)
                if (single.body_a == pair.body_a) {
                    EXPECT_EQ(plane_of(pair, N::own_gradient).normal, single.chosen().normal);
                    EXPECT_EQ(plane_of(pair, N::own_gradient).separation, single.chosen().separation);
                }
        if (of_pairs[g].points.size() != 1) continue; // two bodies
        ASSERT_EQ(of_own[g].points.size(), 2U);
        const PlaneSeen<2>& pair = plane_of(of_pairs[g].points[0], N::average_gradient);
        for (const PointSeen<2>& single : of_own[g].points) {
            EXPECT_TRUE(single.lumped);
            const bool same = single.body_a == of_pairs[g].points[0].body_a;
            const PlaneSeen<2>& plane = plane_of(single, N::average_gradient);
            EXPECT_EQ(plane.normal, same ? pair.normal : Vec<2>(-pair.normal));
            EXPECT_EQ(plane.separation[critical_position], pair.separation[critical_position]);
            EXPECT_NEAR(plane.end_a, same ? pair.end_a : -pair.end_b, 1e-12);
            turned += !same;
        }
    }
    EXPECT_GT(turned, 10);
}

TEST(InspectContact, SpecifiedIsThereIfItIsTheScenesOwn) {
    State<2> state =
        random_bodies<2>(NormalMethod::specified, SeparationMethod::fitted_position, ThreeOrMore::explicit_);
    for (const NodeSeen<2>& node : inspect_contact<2>(state, all_nodes(state)))
        for (const PointSeen<2>& point : node.points) {
            ASSERT_EQ(point.planes.size(), 8U);
            EXPECT_EQ(point.chosen().method, NormalMethod::specified);
            EXPECT_NEAR((point.chosen().normal - Vec<2>(0.6, -1.2).normalized()).norm(), 0, 1e-15);
        }
}

/// All particles whose uGIMP function at the node is positive: their undeformed boxes reach into the cells around it.
template <int D>
void check_clouds(ThreeOrMore three) {
    State<D> state = random_bodies<D>(NormalMethod::average_gradient, SeparationMethod::particle_edges, three);
    const Particles<D>& particles = state.particles;
    int supports = 0;
    for (const NodeSeen<D>& node : inspect_contact<D>(state, all_nodes(state)))
        for (const PointSeen<D>& point : node.points) {
            const Vec<D> n = point.chosen().normal;
            std::set<std::int32_t> expected;
            double end_a = -1e300, end_b = 1e300;
            std::int32_t last_a = -1, first_b = -1;
            for (std::size_t p = 0; p < particles.size(); ++p) {
                const Vec<D> x = particles.position[p] - node.position;
                const bool takes_part =
                    point.lumped || particles.body[p] == point.body_a || particles.body[p] == point.body_b;
                if (!takes_part || ((x.cwiseAbs() - particles.half_size[p]).array() >= 1).any()) continue;
                expected.insert(particles.id[p]);
                // The farthest point of the carried ellipsoid along n, over many directions of the undeformed one.
                const double R =
                    (particles.half_size[p].asDiagonal() * particles.deformation_gradient[p].transpose() * n).norm();
                if (particles.body[p] == point.body_a && x.dot(n) + R > end_a) {
                    end_a = x.dot(n) + R;
                    last_a = particles.id[p];
                }
                if (particles.body[p] != point.body_a && x.dot(n) - R < end_b) {
                    end_b = x.dot(n) - R;
                    first_b = particles.id[p];
                }
            }
            EXPECT_NEAR(point.chosen().end_a, end_a, 1e-12);
            EXPECT_NEAR(point.chosen().end_b, end_b, 1e-12);
            std::set<std::int32_t> found;
            for (const ParticleSeen<D>& particle : point.cloud) {
                EXPECT_TRUE(found.insert(particle.id).second) << "once each";
                const std::size_t p = static_cast<std::size_t>(
                    std::find(particles.id.begin(), particles.id.end(), particle.id) - particles.id.begin());
                EXPECT_EQ(particle.position, particles.position[p]);
                EXPECT_EQ(particle.half_size, particles.half_size[p]);
                EXPECT_EQ(particle.deformation_gradient, particles.deformation_gradient[p]);
                EXPECT_EQ(particle.body, particles.body[p]);
                EXPECT_NEAR(particle.distance, (particle.position - node.position).dot(n) - (end_a + end_b) / 2, 1e-12);
                EXPECT_EQ(particle.support, particle.id == last_a || particle.id == first_b);
                supports += particle.support;
            }
            EXPECT_EQ(found, expected);
        }
    EXPECT_GT(supports, 20);
}

TEST(InspectContact, CloudsAndSupportsAreThoseOfBruteForce) {
    check_clouds<2>(ThreeOrMore::explicit_);
    check_clouds<2>(ThreeOrMore::up_to_two);
    check_clouds<3>(ThreeOrMore::lumped);
}

TEST(InspectContact, ANodeThatIsNoContactNodeHasNoPoints) {
    State<2> state = two_blocks(0.1);
    const auto seen = inspect_contact<2>(state, {{0, 0}, {4, 4}, {-100, 3}, {4, 4}});
    ASSERT_EQ(seen.size(), 4U);
    EXPECT_TRUE(seen[0].points.empty());
    EXPECT_EQ(seen[1].points.size(), 1U);
    EXPECT_TRUE(seen[2].points.empty());
    EXPECT_EQ(seen[3].points.size(), 1U) << "asked for twice";
    EXPECT_TRUE(inspect_contact<2>(state, {}).empty());
}

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

/// Contact nodes taken apart: against closed forms, brute force over the particles, and the run's own contacts.

#include "contact_inspect.h"

#include <set>

namespace {

using namespace test;

constexpr auto particle_edges = 0, critical_position = 1, displacement = 3;

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

} // namespace

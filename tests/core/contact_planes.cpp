/// Normals and separations of a scene's contact points against their definitions, summed up by brute force over the
/// particles.

#include "support.h"

#include "contact/find_contacts.h"
#include "contact/normal/average_gradient.h"
#include "contact/normal/maximum_gradient.h"
#include "contact/normal/maximum_volume.h"
#include "contact/normal/own_gradient.h"
#include "results/frames.h"

namespace {

using namespace test;

/// Two bodies side by side and a third over both, with the edges off the grid lines: pairs, and nodes that see three.
State<2> meeting(NormalMethod normal, SeparationMethod separation, ThreeOrMore three_or_more = ThreeOrMore::explicit_) {
    Scene scene = plane_scene(1, 0, 0, 10, 10, material(1, 10, 3));
    scene.method.shape = ShapeKind::ugimp;
    scene.contact = contact(LawType::frictionless);
    scene.contact->normal = normal;
    scene.contact->separation = separation;
    scene.contact->three_or_more = three_or_more;
    scene.contact->direction = {0.6, -1.2, 0};
    Model model;
    add_box(model, add_body(model, "left"), 2.2, 2.4, 5.2, 5.4, 6, 6);
    add_box(model, add_body(model, "right"), 5.25, 2.3, 8.25, 5.3, 6, 6);
    add_box(model, add_body(model, "upper"), 3.3, 5.45, 7.3, 8.45, 8, 6);
    State<2> state = make_state<2>(scene, model);
    std::mt19937 random(1);
    for (Mat<2>& F : state.particles.deformation_gradient) F = random_deformation<2>(random, 0.2);
    look(state);
    return state;
}

double hat(double a, double b) {
    const auto integral = [](double x) {
        x = std::clamp(x, -1.0, 1.0);
        return x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2;
    };
    return (integral(b) - integral(a)) / (b - a);
}
double slope(double a, double b) {
    const auto linear = [](double x) { return std::max(0.0, 1 - std::abs(x)); };
    return (linear(b) - linear(a)) / (b - a);
}

/// Volume | gradient of some bodies at a node by the definition of uGIMP.
struct Extrapolated {
    double volume = 0;
    Vec<2> gradient = Vec<2>::Zero();
    double mass = 0;
    Vec<2> moment = Vec<2>::Zero();
};
Extrapolated extrapolate(const State<2>& state, const Vec<2>& node, const std::function<bool(int)>& wanted) {
    Extrapolated e;
    const Particles<2>& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!wanted(particles.body[p])) continue;
        const Vec<2> low = particles.position[p] - particles.half_size[p] - node;
        const Vec<2> high = particles.position[p] + particles.half_size[p] - node;
        const double sx = hat(low[0], high[0]);
        const double sy = hat(low[1], high[1]);
        const double volume = particles.deformation_gradient[p].determinant() * particles.volume[p];
        e.volume += sx * sy * volume;
        e.gradient += volume * Vec<2>(slope(low[0], high[0]) * sy, sx * slope(low[1], high[1]));
        e.mass += sx * sy * particles.mass[p];
        e.moment += sx * sy * particles.mass[p] * particles.position[p];
    }
    return e;
}

/// Calls check(point, group, node, a, b) with the extrapolated fields of both sides.
template <class Check>
int for_points(const State<2>& state, Check&& check) {
    int count = 0;
    for (const ContactGroup<2>& group : state.contact.groups)
        for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
            const ContactPoint<2>& point = state.contact.points[i];
            const Vec<2> node = state.grid.node_position(group.node);
            const Extrapolated a = extrapolate(state, node, [&](int body) { return body == point.body_a; });
            const Extrapolated b = extrapolate(
                state, node, [&](int body) { return point.slot_b >= 0 ? body == point.body_b : body != point.body_a; });
            check(point, group, node, a, b);
            ++count;
        }
    return count;
}

void expect_normal(const ContactPoint<2>& point, const Vec<2>& direction) {
    EXPECT_LT((point.normal - direction.normalized()).norm(), 1e-9);
}

TEST(GradientNormals, AreThoseOfTheirDefinitions) {
    for (const ThreeOrMore three : {ThreeOrMore::explicit_, ThreeOrMore::lumped}) {
        using N = NormalMethod;
        const auto fields = [&](N normal, auto check) {
            const State<2> state = meeting(normal, SeparationMethod::none, three);
            EXPECT_GT(for_points(state, check), 20);
        };
        fields(N::average_gradient, [](const auto& point, auto&, auto&, const auto& a, const auto& b) {
            expect_normal(point, a.gradient - b.gradient);
        });
        fields(N::maximum_gradient, [](const auto& point, auto&, auto&, const auto& a, const auto& b) {
            expect_normal(point, a.gradient.norm() > b.gradient.norm() ? a.gradient : Vec<2>(-b.gradient));
        });
        fields(N::maximum_volume, [](const auto& point, auto&, auto&, const auto& a, const auto& b) {
            expect_normal(point, a.volume > b.volume ? a.gradient : Vec<2>(-b.gradient));
        });
        fields(N::own_gradient, [](const auto& point, const auto& group, auto&, const auto& a, auto&) {
            EXPECT_LT(point.slot_b, 0) << "each body by itself";
            EXPECT_EQ(group.last_point - group.first_point, group.last - group.first);
            expect_normal(point, a.gradient);
        });
        fields(N::specified, [](const auto& point, auto&, auto&, auto&, auto&) {
            expect_normal(point, point.body_a < point.body_b ? Vec<2>(0.6, -1.2) : Vec<2>(-0.6, 1.2));
        });
    }
}

TEST(GradientNormals, OfBodiesWithoutGradientAreNone) {
    const Pack none{1, 0, 0, 0};
    const Pack some{0.5, 0.3, -0.4, 0};
    for (const Vec<2>& n : {average_gradient<2>(none, none), maximum_gradient<2>(none, none),
                            maximum_volume<2>(none, some), own_gradient<2>(none), average_gradient<2>(some, some)})
        EXPECT_TRUE(n.isZero(0));
}

template <int D>
void check_pairs_of_gradients() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> exponent(-30, 30);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        const auto any = [&] {
            const double scale = std::pow(10.0, exponent(random));
            return pack<D>(scale * (1 + in(random)), scale * random_rotation<D>(random).col(0));
        };
        const Pack a = any();
        const Pack b = any();
        for (const auto method : {average_gradient<D>, maximum_gradient<D>, maximum_volume<D>}) {
            EXPECT_NEAR(method(a, b).norm(), 1, 1e-12);
            EXPECT_TRUE((method(a, b) + method(b, a)).isZero(0)) << "opposite for the other body";
        }
        EXPECT_NEAR(own_gradient<D>(a).norm(), 1, 1e-12);
    }
}
TEST(GradientNormals, AreUnitAndOppositeForAnyGradients) {
    check_pairs_of_gradients<2>();
    check_pairs_of_gradients<3>();
}

TEST(Separations, OfExtrapolatedPositionsAreThoseOfTheirDefinitions) {
    for (const auto& [separation, fit] : {std::pair{SeparationMethod::critical_position, PositionFit::power_law},
                                          std::pair{SeparationMethod::fitted_position, PositionFit::power_law},
                                          std::pair{SeparationMethod::fitted_position, PositionFit::two_per_cell},
                                          std::pair{SeparationMethod::fitted_position, PositionFit::one_per_cell}})
        for (const ThreeOrMore three : {ThreeOrMore::explicit_, ThreeOrMore::lumped}) {
            State<2> state = meeting(NormalMethod::average_gradient, separation, three);
            state.scene.contact->fit = fit;
            find_separations(state);
            const auto method = separation;
            const auto curve = fit;
            for_points(state, [&](const auto& point, auto&, const Vec<2>& node, const auto& a, const auto& b) {
                const double xa = (a.moment / a.mass - node).dot(point.normal);
                const double xb = (b.moment / b.mass - node).dot(point.normal);
                const auto edge = [&](double x) { // notes 3.51, 3.52, 3.55
                    x = std::max(x, 0.0);
                    if (curve == PositionFit::power_law) return 2 * std::pow(x / 1.25, 0.58) - 1;
                    if (curve == PositionFit::two_per_cell)
                        return x > 0.75 ? x - 0.25 : 1.5 * std::pow(4 * x / 3, 0.5546) - 1;
                    return x > 0.5 ? x - 0.5 : std::pow(2 * x, 0.5387) - 1;
                };
                const double expected =
                    method == SeparationMethod::critical_position ? xb - xa - 0.8 : edge(xb) + edge(-xa);
                EXPECT_NEAR(point.separation, expected, 1e-9);
            });
        }
}

TEST(Separations, ByDisplacementsAreWhatBodiesHaveMovedApart) {
    State<2> state = meeting(NormalMethod::specified, SeparationMethod::displacement);
    const Vec<2> moved(0.02, 0.05);
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (state.particles.body[p] == 2) state.particles.position[p] += moved;
    look(state);
    const Vec<2> n = Vec<2>(0.6, -1.2).normalized();
    for_points(state, [&](const auto& point, auto&, auto&, auto&, auto&) {
        EXPECT_NEAR(point.separation, point.body_b == 2 ? moved.dot(n) : 0, 1e-12);
    });
}

TEST(Separations, WithoutANormalAreInfinite) {
    State<2> state = meeting(NormalMethod::average_gradient, SeparationMethod::particle_edges);
    for (ContactPoint<2>& point : state.contact.points) point.normal.setZero();
    for (const SeparationMethod method :
         {SeparationMethod::particle_edges, SeparationMethod::critical_position, SeparationMethod::fitted_position,
          SeparationMethod::displacement, SeparationMethod::none}) {
        state.scene.contact->separation = method;
        find_separations(state);
        for (const ContactPoint<2>& point : state.contact.points)
            EXPECT_EQ(point.separation, std::numeric_limits<double>::infinity());
    }
}

/// At nodes of three bodies: the pairs of "explicit" and the lumped points of "lumped", both with their planes.
TEST(UpToTwo, KeepsPairsAndLumpedPoints) {
    for (const NormalMethod normal : {NormalMethod::logistic_regression, NormalMethod::average_gradient}) {
        const auto separation = SeparationMethod::particle_edges;
        const State<2> both = meeting(normal, separation, ThreeOrMore::up_to_two);
        const State<2> pairs = meeting(normal, separation, ThreeOrMore::explicit_);
        const State<2> lumped = meeting(normal, separation, ThreeOrMore::lumped);
        const auto same = [](const Contact<2>& a, std::int32_t i, const Contact<2>& b, std::int32_t j) {
            EXPECT_EQ(a.points[i].slot_a, b.points[j].slot_a);
            EXPECT_EQ(a.points[i].slot_b, b.points[j].slot_b);
            EXPECT_EQ(a.points[i].normal, b.points[j].normal);
            EXPECT_EQ(a.points[i].separation, b.points[j].separation);
        };
        int threes = 0;
        ASSERT_EQ(both.contact.groups.size(), pairs.contact.groups.size());
        for (std::size_t g = 0; g < both.contact.groups.size(); ++g) {
            const ContactGroup<2>& group = both.contact.groups[g];
            const ContactGroup<2>& p = pairs.contact.groups[g];
            const ContactGroup<2>& l = lumped.contact.groups[g];
            ASSERT_EQ(group.last_point - group.first_point, p.last_point - p.first_point);
            EXPECT_EQ(p.last_lumped - p.first_lumped, 0);
            EXPECT_EQ(l.last_lumped - l.first_lumped, 0);
            for (std::int32_t i = 0; i < p.last_point - p.first_point; ++i)
                same(both.contact, group.first_point + i, pairs.contact, p.first_point + i);
            const bool three = group.last - group.first > 2;
            threes += three;
            ASSERT_EQ(group.last_lumped - group.first_lumped, three ? l.last_point - l.first_point : 0);
            for (std::int32_t i = 0; i < group.last_lumped - group.first_lumped; ++i)
                same(both.contact, group.first_lumped + i, lumped.contact, l.first_point + i);
        }
        EXPECT_GT(threes, 0);
    }
}

} // namespace

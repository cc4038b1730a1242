/// Tractions on faces of particles (FMPM paper §2.4): which faces, how they deform, where their force goes.

#include "dense.h"

#include <Eigen/Dense>

#include <gmock/gmock.h>
#include <numbers>
#include <set>

namespace {

using namespace test;

/// Nanson: area times normal is det F F^-T times the undeformed ones.
template <int D>
void check_deformed_faces() {
    std::mt19937 random(1);
    Model model;
    add_particle(model, add_body(model, "a"), Vector{2, 3, 4}, Vector{0.25, 0.1, 0.3});
    const Scene scene =
        D == 2 ? plane_scene(1, 0, 0, 6, 6, material(1, 10, 3)) : space_scene(1, 0, 6, material(1, 10, 3));
    Particles<D> particles = make_particles<D>(model, scene);
    const double thickness = D == 2 ? 0.7 : 1;
    for (int trial = 0; trial < 200; ++trial)
        for (int axis = 0; axis < D; ++axis)
            for (const double outward : {-1.0, 1.0}) {
                Mat<D>& F = particles.deformation_gradient[0];
                F = stretched_and_turned<D>(random, 0.4, 3);
                const DeformedFace<D> face = deformed_face(particles, 0, axis, outward, false, thickness);
                const Vec<D> half = particles.half_size[0];
                Vec<D> normal = Vec<D>::Zero();
                normal[axis] = outward * thickness * (2 * half).prod() / (2 * half[axis]);
                const Vec<D> nanson = F.determinant() * F.inverse().transpose() * normal;
                EXPECT_LT((face.area * face.outward - nanson).norm(), 1e-13 * nanson.norm());
                EXPECT_NEAR(face.outward.norm(), 1, 1e-14);
                // Corners: those of the domain with this sign along the axis, each with the same share.
                Vec<D> mean = Vec<D>::Zero();
                double share = 0;
                FacePoint<D> corner[9];
                ASSERT_EQ(face_points(face, FaceRule::corners, false, corner), power(2, D - 1));
                for (int c = 0; c < power(2, D - 1); ++c) {
                    mean += corner[c].share * corner[c].position;
                    share += corner[c].share;
                    const Vec<D> xi = (F.inverse() * (corner[c].position - particles.position[0])).cwiseQuotient(half);
                    EXPECT_NEAR(xi[axis], outward, 1e-12);
                    for (int a = 0; a < D; ++a) EXPECT_NEAR(std::abs(xi[a]), 1, 1e-12);
                    for (int b = 0; b < c; ++b) EXPECT_GT((corner[b].position - corner[c].position).norm(), 0.01);
                }
                EXPECT_NEAR(share, 1, 1e-15);
                EXPECT_LT((mean - particles.position[0] - outward * half[axis] * F.col(axis)).norm(), 1e-14);
            }
}

TEST(DeformedFaces, TurnAndStretchWithTheirParticles) {
    check_deformed_faces<2>();
    check_deformed_faces<3>();
}

TEST(DeformedFaces, OfRingsGoAllTheWayAround) {
    std::mt19937 random(2);
    Model model;
    add_particle(model, add_body(model, "a"), 2, 3, 0.25, 0.1);
    Scene scene = plane_scene(1, 0, 0, 6, 6, material(1, 10, 3));
    scene.analysis = Analysis::axisymmetric;
    Particles<2> particles = make_particles<2>(model, scene);
    for (int trial = 0; trial < 100; ++trial)
        for (const int axis : {0, 1}) {
            if (trial > 0) particles.deformation_gradient[0] = stretched_and_turned<2>(random, 0.4, 3);
            const DeformedFace<2> face = deformed_face(particles, 0, axis, 1, true, 77);
            FacePoint<2> corner[9];
            ASSERT_EQ(face_points(face, FaceRule::corners, true, corner), 2);
            const Vec<2> side = corner[1].position - corner[0].position;
            // ∫ 2π r dl over the face, and ∫ M_c r dl of the linear functions M_c of its ends.
            double area = 0;
            double first = 0;
            for (const auto& [t, weight] : quadrature(0, 1)) {
                const double r = (corner[0].position + t * side)[0];
                area += weight * 2 * std::numbers::pi * r * side.norm();
                first += weight * 2 * std::numbers::pi * r * side.norm() * (1 - t);
            }
            EXPECT_NEAR(face.area, area, 1e-13);
            EXPECT_NEAR(corner[0].share, first / area, 1e-14);
            EXPECT_NEAR(corner[1].share, 1 - first / area, 1e-14);
            if (trial == 0) {
                EXPECT_NEAR(face.area, 2 * std::numbers::pi * (axis == 0 ? 2.25 * 0.2 : 2 * 0.5), 1e-14);
            }
        }
}

TEST(DeformedFaces, AllRulesIntegrateLinearFieldsExactly) {
    std::mt19937 random(3);
    Model model;
    add_particle(model, add_body(model, "a"), Vector{2, 3, 4}, Vector{0.25, 0.1, 0.3});
    Particles<3> particles = make_particles<3>(model, space_scene(1, 0, 6, material(1, 10, 3)));
    particles.deformation_gradient[0] = stretched_and_turned<3>(random, 0.4, 3);
    for (int axis = 0; axis < 3; ++axis)
        for (const FaceRule rule : {FaceRule::center, FaceRule::corners, FaceRule::simpson}) {
            const DeformedFace<3> face = deformed_face(particles, 0, axis, 1, false, 1);
            FacePoint<3> points[9];
            const int count = face_points(face, rule, false, points);
            Vec<3> mean = Vec<3>::Zero();
            double share = 0;
            for (int q = 0; q < count; ++q) {
                mean += points[q].share * points[q].position;
                share += points[q].share;
            }
            EXPECT_NEAR(share, 1, 1e-14);
            EXPECT_LT((mean - face.center).norm(), 1e-13);
        }
}

TEST(DeformedFaces, OfBoxesLieOnTheSideTheyLookTo) {
    // A square that has turned by a right angle: its right side looks up.
    Model model;
    add_particle(model, add_body(model, "a"), 2, 3, 0.25, 0.1);
    Particles<2> particles = make_particles<2>(model, plane_scene(1, 0, 0, 6, 6, material(1, 10, 3)));
    particles.deformation_gradient[0] << 0, -1, 1, 0;
    DeformedFace<2> face = deformed_face(particles, 0, 0, 1, false, 1);
    fit_to_box<2>(face, particles.position[0], Vec<2>(0.1, 0.25));
    EXPECT_LT((face.center - Vec<2>(2, 3.25)).norm(), 1e-14);
    EXPECT_LT((face.edge[0] - Vec<2>(0.1, 0)).norm(), 1e-14);
    EXPECT_LT((face.outward - Vec<2>(0, 1)).norm(), 1e-14);
}

} // namespace

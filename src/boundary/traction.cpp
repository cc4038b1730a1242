#include "boundary/traction.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <map>
#include <numbers>

namespace abut {

namespace {

/// Looks up particles by place: sorted into bins that are larger than any domain.
template <int D>
class Places {
public:
    Places(const Particles<D>& particles, const std::vector<std::int32_t>& members) : particles_(particles) {
        for (const std::int32_t p : members) width_ = std::max(width_, 2 * particles.half_size[p].maxCoeff());
        for (const std::int32_t p : members) bins_[bin_of(particles.position[p])].push_back(p);
    }
    /// Whether the domain of one of the particles contains a point. They are not deformed yet, but may be turned.
    bool covers(const Vec<D>& x) const {
        const std::array<long, 3> center = bin_of(x);
        std::array<long, 3> bin{};
        for (int n = 0; n < 27; ++n) {
            bin = {center[0] + n % 3 - 1, center[1] + n / 3 % 3 - 1, center[2] + n / 9 - 1};
            const auto found = bins_.find(bin);
            if (found == bins_.end()) continue;
            for (const std::int32_t p : found->second)
                if (within(p, x)) return true;
        }
        return false;
    }

private:
    bool within(std::int32_t p, const Vec<D>& x) const {
        const Vec<D> offset = particles_.deformation_gradient[p].transpose() * (x - particles_.position[p]);
        return (offset.cwiseAbs().array() <= particles_.half_size[p].array()).all();
    }
    std::array<long, 3> bin_of(const Vec<D>& x) const {
        std::array<long, 3> bin{};
        for (int a = 0; a < D; ++a) bin[a] = static_cast<long>(std::floor(x[a] / width_));
        return bin;
    }
    const Particles<D>& particles_;
    double width_ = 0;
    std::map<std::array<long, 3>, std::vector<std::int32_t>> bins_;
};

} // namespace

template <int D>
std::vector<TractionFace> find_faces(const TractionSpec& condition, std::int32_t boundary, std::int32_t body,
                                     const Particles<D>& particles) {
    std::vector<std::int32_t> members;
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (particles.body[p] == body) members.push_back(static_cast<std::int32_t>(p));
    const Places<D> places(particles, members);
    const double outward = condition.side == Side::lower ? -1.0 : 1.0;
    const auto is_wanted = [&](const Vec<D>& x) {
        for (int a = 0; condition.within && a < D; ++a)
            if (x[a] < condition.within->lower[a] || x[a] > condition.within->upper[a]) return false;
        return true;
    };
    std::vector<TractionFace> faces;
    for (const std::int32_t p : members) {
        if (!is_wanted(particles.position[p])) continue;
        const double way = 1.5 * outward * particles.half_size[p][condition.axis];
        const Vec<D> neighbour = particles.position[p] + way * particles.deformation_gradient[p].col(condition.axis);
        if (places.covers(neighbour)) continue;
        faces.push_back({boundary, particles.id[p], -1, -1, condition.axis, outward});
    }
    return faces;
}

template <int D>
DeformedFace<D> deformed_face(const Particles<D>& particles, std::int32_t particle, int axis, double outward, bool ring,
                              double thickness) {
    Mat<D> A = particles.deformation_gradient[particle];
    for (int b = 0; b < D; ++b) A.col(b) *= particles.half_size[particle][b];
    DeformedFace<D> face;
    face.center = particles.position[particle] + outward * A.col(axis);
    if constexpr (D == 2) {
        const Vec<2> along = A.col(1 - axis);
        face.edge[0] = along;
        face.area = 2 * along.norm() *
                    (ring ? 2 * std::numbers::pi * face.center[0] : thickness * particles.across_of(particle));
        face.outward = Vec<2>(along[1], -along[0]).normalized();
    } else {
        face.edge[0] = A.col((axis + 1) % 3);
        face.edge[1] = A.col((axis + 2) % 3);
        const Vec<3> normal = face.edge[0].cross(face.edge[1]);
        face.area = 4 * normal.norm();
        face.outward = normal.normalized();
    }
    if (face.outward.dot(A.col(axis)) * outward < 0) face.outward = -face.outward;
    return face;
}

template <int D>
void fit_to_box(DeformedFace<D>& face, const Vec<D>& position, const Vec<D>& half_size) {
    int side = 0;
    (face.center - position).cwiseQuotient(half_size).cwiseAbs().maxCoeff(&side);
    const double outward = face.center[side] > position[side] ? 1.0 : -1.0;
    face.center = position + outward * half_size[side] * Vec<D>::Unit(side);
    for (int b = 0, a = 0; a < D; ++a)
        if (a != side) face.edge[b++] = half_size[a] * Vec<D>::Unit(a);
}

template <int D>
int face_points(const DeformedFace<D>& face, FaceRule rule, bool ring, FacePoint<D> (&points)[9]) {
    static constexpr double place[3][3] = {{0}, {-1, 1}, {-1, 0, 1}};
    static constexpr double weight[3][3] = {{1}, {0.5, 0.5}, {1.0 / 6, 4.0 / 6, 1.0 / 6}};
    const int r = static_cast<int>(rule);
    const int along = r + 1;
    const int count = D == 2 ? along : along * along;
    double total = 0;
    for (int i = 0; i < count; ++i) {
        Vec<D> x = face.center;
        double share = 1;
        for (int b = 0, rest = i; b < D - 1; ++b, rest /= along) {
            x += place[r][rest % along] * face.edge[b];
            share *= weight[r][rest % along];
        }
        if (ring) {
            // Corners: ∫ M_c r with M_c linear along the face, r + r_c/3 of its length; else the radius at the point.
            share *= rule == FaceRule::corners ? 2 * face.center[0] + x[0] : x[0];
        }
        points[i] = {x, share};
        total += share;
    }
    for (int i = 0; i < count; ++i) points[i].share /= total;
    return count;
}

template std::vector<TractionFace> find_faces<2>(const TractionSpec&, std::int32_t, std::int32_t, const Particles<2>&);
template std::vector<TractionFace> find_faces<3>(const TractionSpec&, std::int32_t, std::int32_t, const Particles<3>&);
template void fit_to_box<2>(DeformedFace<2>&, const Vec<2>&, const Vec<2>&);
template void fit_to_box<3>(DeformedFace<3>&, const Vec<3>&, const Vec<3>&);
template int face_points<2>(const DeformedFace<2>&, FaceRule, bool, FacePoint<2> (&)[9]);
template int face_points<3>(const DeformedFace<3>&, FaceRule, bool, FacePoint<3> (&)[9]);
template DeformedFace<2> deformed_face<2>(const Particles<2>&, std::int32_t, int, double, bool, double);
template DeformedFace<3> deformed_face<3>(const Particles<3>&, std::int32_t, int, double, bool, double);

} // namespace abut

#pragma once
#include "boundary/boundary.h"
#include "particles/particles.h"
#include "shape/stencil.h"

namespace abut {

/// A face of a particle's domain that carries a traction.
struct TractionFace {
    std::int32_t boundary;
    std::int32_t id;            ///< of the particle
    std::int32_t particle = -1; ///< its present index
    std::int32_t tile = -1;
    int axis = 0;        ///< the face across the deformed edge r_axis of the domain
    double outward = -1; ///< at its lower (-1) or upper (1) end
};

/// The outer faces of a body's undeformed particles that a condition names: those that no other particle of the body
/// adjoins. \param body index of the condition's body
template <int D>
std::vector<TractionFace> find_faces(const TractionSpec& condition, std::int32_t boundary, std::int32_t body,
                                     const Particles<D>& particles);

/// A deformed face of a particle's domain: the points x + Σ ξ_b `edge`_b with ξ in [-1, 1].
template <int D>
struct DeformedFace {
    Vec<D> center;
    std::array<Vec<D>, D - 1> edge; ///< half edges
    double area;                    ///< [m^2]
    Vec<D> outward;                 ///< unit
};

/// The face of the domain spanned by the columns of F diag(half size), as CPDI sees it (FMPM paper §2.4).
/// \param ring the face of a full ring around the axis; else plane faces are as deep as the undeformed
/// `thickness` times the stretch across the plane
template <int D>
DeformedFace<D> deformed_face(const Particles<D>& particles, std::int32_t particle, int axis, double outward, bool ring,
                              double thickness);

/// Moves a face onto the box along the axes that a shape takes for the particle's domain: to the side that the face
/// looks to most. Box and face must end at the same place, or else nodes that the one reaches and the other hardly does
/// get a force and next to no mass.
template <int D>
void fit_to_box(DeformedFace<D>& face, const Vec<D>& position, const Vec<D>& half_size);

/// A point of a face and its share of the face's force.
template <int D>
struct FacePoint {
    Vec<D> position;
    double share;
};

/// The points of a quadrature over a face, at most 9. \return their number
template <int D>
int face_points(const DeformedFace<D>& face, FaceRule rule, bool ring, FacePoint<D> (&points)[9]);

/// A face as the scene's shape sees it at the beginning of a step, when nodes and stencils are found: forces go to
/// those nodes, though particles may deform before forces are found (USF, USAVG).
template <int D>
struct ShapedFace {
    DeformedFace<D> deformed; ///< area and normal are the deformed particle's
    FacePoint<D> points[9];
    int count;
};

} // namespace abut

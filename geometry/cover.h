#pragma once
/// \file cover.h
/// What shapes and images have of the places of a lattice.

#include "geometry/lattice.h"
#include "geometry/shapes/solid.h"

#include <array>
#include <vector>

namespace abut {

/// The covered part of one place, by its moments.
struct Covered {
    Place place{};
    double fraction = 1;   ///< of the place's area or volume; beyond 1 where a sliver was joined to it
    Vector centre{};       ///< centre of mass of the covered part [m]
    Vector variance{};     ///< mean squares of the distance from it along each axis [m^2]
    double covariance = 0; ///< of x and y [m^2]
};

/// All of a place.
Covered whole(const Lattice& lattice, const Place& place);

/// Sums of a density over pieces of a place, from which Covered is made. Coordinates in edges of the place from its
/// lower corner.
struct Moments {
    double content = 0; ///< in places
    Vector first{}, second{};
    double mixed = 0; ///< of x and y

    /// Adds a box.
    void add(const Vector& lower, const Vector& upper, std::size_t dimension) {
        double size = 1;
        for (std::size_t a = 0; a < dimension; ++a) size *= upper[a] - lower[a];
        content += size;
        Vector middle{};
        for (std::size_t a = 0; a < dimension; ++a) {
            middle[a] = (lower[a] + upper[a]) / 2;
            const double edge = upper[a] - lower[a];
            first[a] += size * middle[a];
            second[a] += size * (middle[a] * middle[a] + edge * edge / 12);
        }
        mixed += size * middle[0] * middle[1];
    }
    Covered covered(const Lattice& lattice, const Place& place) const;
};

/// Less of a place than this is nothing: it is round-off, and a particle so thin would be of no use.
inline constexpr double least_fraction = 1e-4;

/// Parts of less than a tenth of a place are too thin for particles of their own: each is joined to the part of the
/// same body in the place around it that is largest, which grows by it (its fraction too, beyond 1 if it was whole),
/// keeping content, centre and moments of both together. A part without others beside it stays as it is.
void join_slivers(std::vector<Covered>& places);

/// The places whose centre lies inside or on the outline, x fastest. Fractions are 1.
std::vector<Covered> places_by_centre(const Solid& solid, const Lattice& lattice);

/// All places that a solid covers in part, x fastest. Lines along the last axis are integrated exactly, across them by
/// Gauss' rule piece by piece between the solid's breaks: in the plane the fraction of a place is right to about 1e-4,
/// in space to 1e-3, the whole area or volume far better, and what is bounded by faces across the axes to round-off.
/// The same for any number of threads.
std::vector<Covered> places_by_fraction(const Solid& solid, const Lattice& lattice);

/// The area or volume of a solid, integrated with lines that are `spacing` apart at most [m^2, m^3].
double content_of(const Solid& solid, std::size_t dimension, double spacing);

/// A particle that stands for the covered part of a place.
struct PlacedParticle {
    Vector position{};  ///< [m]
    Vector half_size{}; ///< [m]
    double angle = 0;   ///< of its domain, counter-clockwise [rad]
};

/// The box of the same area (volume) and centre as the covered part, with edges in proportion to its extents
/// (√(12 variance), as a box has). With `turned` (plane scenes) along its principal axes: the edges of particles at an
/// outline then lie along it. Exact where the part is a box.
PlacedParticle particle_of(const Covered& covered, const Lattice& lattice, bool turned);

} // namespace abut

#pragma once
/// \file parts.h
/// The particles of a scene while the model is being built, and the checks that need all of them.

#include "geometry/cover.h"
#include "scene/problem.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace abut {

/// Particles that one place of the scene made for one body: a shape, or a body's pixels in an image.
struct Part {
    std::string pointer; ///< of that place, for messages
    std::string body_name;
    int body = 0;                 ///< index into Model::bodies
    Lattice lattice;              ///< whose places its particles take; in its own frame if it is turned
    double turn = 0;              ///< of that frame about `pivot`, counter-clockwise; of all its particles [rad]
    Vector pivot{};               ///< [m]
    std::vector<Place> place;     ///< of each particle
    std::vector<double> fraction; ///< of its place that it stands for; empty: all of it
    std::vector<PlacedParticle> particle; ///< in the scene
    std::vector<double> temperature{};    ///< from a second image [K]; empty: none
    std::vector<double> orientation{};    ///< likewise [rad]
    double exact = 0; ///< area or volume in the image or of the shape, if a report asks for it [m^2, m^3]

    std::size_t size() const { return particle.size(); }
    double fraction_of(std::size_t k) const { return fraction.empty() ? 1 : fraction[k]; }
};

/// Whether a method sees particles that are turned as such, and not as boxes along the axes.
inline bool sees_turns(const MethodSpec& method) {
    return method.shape == ShapeKind::cpdi || method.shape == ShapeKind::b2cpdi;
}

/// A part of particles for covered places.
/// \param turned whether particles of partly covered places may be turned
void add_particles(Part& part, const std::vector<Covered>& places, bool turned);

/// Area or volume of a part's particles [m^2, m^3].
double content_of(const Part& part);

/// Reports every part with particles whose centres lie outside the grid's box.
void check_inside(const std::vector<Part>& parts, const GridSpec& grid, std::vector<Problem>& problems);

/// Particles of a part that claim a place that an earlier part has.
struct Claim {
    std::size_t earlier = 0, later = 0; ///< indices of parts
    /// Particles of the later part, ascending, each with the one of the earlier part that is in its way; several times
    /// if several are.
    std::vector<std::array<std::size_t, 2>> particles;
};

/// All claims, ordered by parts. Two particles claim the same place if their parts share a lattice and together they
/// have a quarter more than one place; else if the centre of one lies within the domain of the other. Parts that only
/// touch make no claims. Also between parts of one body: its mass would count twice.
std::vector<Claim> find_claims(const std::vector<Part>& parts);

/// Reports every claim as a problem.
void check_overlap(const std::vector<Part>& parts, std::vector<Problem>& problems);

/// What a part gave up.
struct GivenUp {
    std::size_t from = 0, to = 0; ///< indices of parts
    std::size_t particles = 0;
    double content = 0; ///< [m^2, m^3]
};

/// Removes claimed particles from the parts that come later (Overlap::first) or earlier (Overlap::last).
std::vector<GivenUp> settle_overlap(std::vector<Part>& parts, Overlap overlap);

/// "14.3 um": a length in the unit that suits it, 4 digits.
std::string length_text(double metres);

/// "500 mm × 500 mm": the edges of a particle, three in three dimensions.
std::string edges_text(const Vector& half_size);

/// "1 particle", "14 particles".
std::string count_text(std::size_t count, const std::string& noun);

} // namespace abut

#pragma once
/// \file model_report.h
/// How well particles stand for the bodies they were made from.

#include "geometry/parts.h"
#include "particles/model.h"

#include <string>
#include <vector>

namespace abut {

struct BodyReport {
    std::string name;
    std::size_t particles = 0;
    double content = 0;  ///< area or volume of its particles [m^2, m^3]
    double exact = 0;    ///< of its shapes, and of its pixels in images; what it gave up to others is off [m^2, m^3]
    double thinnest = 0; ///< width of its thinnest part [cells]

    double difference() const { return content / exact - 1; }
};

/// What is worth knowing about a model that a run does not need.
struct ModelReport {
    std::vector<BodyReport> bodies;
    std::vector<std::string> notes; ///< repairs of surfaces, speckles, what was given up where bodies overlap
};

/// The width of the thinnest part of a body in cells along the grid's shortest axis: twice the smallest distance to the
/// outside at those places where it does not grow towards any side — the middle of the body, of a neck, of a bar (the
/// critical points of the distance function). Corners, which are thin too, don't count; where a body tapers slowly,
/// some of the taper does. Measured on the particles' places of all its parts that share one lattice, to about half a
/// place.
double thinnest_width(const std::vector<const Part*>& parts, double cell);

/// Table of all bodies for a terminal. \param dimension says whether sizes are areas or volumes
std::string table_of(const ModelReport& report, std::size_t dimension);

/// What to say of a model a hundred times smaller than its grid along every axis: likely a mistake in a unit. Empty for
/// others.
std::string size_advice(const Model& model, const GridSpec& grid);

/// One line for each body thinner than two cells; for several alike, one line together.
std::vector<std::string> warnings_of(const ModelReport& report);

} // namespace abut

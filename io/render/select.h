#pragma once
/// \file select.h
/// Parts of a scene: chosen bodies, and what a region holds.

#include "io/render/view.h"
#include "results/frame.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace abut {

/// What of a scene is drawn.
struct Selection {
    std::optional<std::set<int>> bodies; ///< numbers; none: all
    std::optional<Bounds> region;        ///< none: everywhere. Flat: particles of which a part is seen, else those
                                         ///< whose centre is within
};

/// Numbers of bodies by their names in the frame's `body_names`. Throws RenderRequestError for a name that isn't there,
/// with the nearest one, and if the frame has no names or no array `body`. \param where for messages
std::set<int> body_numbers(const PointFrame& frame, const std::vector<std::string>& names, const std::string& where);

/// The region that 4 numbers (in flat scenes) or 6 stand for. Throws RenderRequestError if they are too few or many.
Bounds region_of(const std::vector<double>& numbers, bool flat);

/// Leaves only the selected particles in the frame, with their arrays.
void select_particles(PointFrame& frame, const Selection& selection);

/// Leaves only contact pairs within the region of which at least one body is selected.
void select_contacts(PointFrame& frame, const Selection& selection);

} // namespace abut

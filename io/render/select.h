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

/// The bodies that names stand for, each once: a body's own, or, where no body has it, that of an entry of an image's
/// legend, which named its bodies NAME-1, NAME-2, … (of all of these). Throws RenderRequestError for another name, with
/// the nearest one. \param known names of all bodies \param where for messages
std::vector<std::string> bodies_named(const std::vector<std::string>& names, const std::vector<std::string>& known,
                                      const std::string& where);

/// Numbers of the bodies_named in the frame's `body_names`. Throws RenderRequestError for a name that isn't there,
/// with the nearest one, and if the frame has no names or no array `body`. \param where for messages
std::set<int> body_numbers(const PointFrame& frame, const std::vector<std::string>& names, const std::string& where);

/// The region that 4 numbers (in flat scenes) or 6 stand for. Throws RenderRequestError if they are too few or many.
Bounds region_of(const std::vector<double>& numbers, bool flat);

/// Throws RenderRequestError for a region in which nothing could be seen: one outside the box, or so large that the box
/// would be less than a pixel of it. \param all_there_is whether nothing can be outside the box
void check_region(const Bounds& region, const Bounds& box, bool all_there_is);

/// Leaves only the selected particles in the frame, with their arrays.
void select_particles(PointFrame& frame, const Selection& selection);

/// Leaves only contact pairs within the region of which at least one body is selected.
void select_contacts(PointFrame& frame, const Selection& selection);

} // namespace abut

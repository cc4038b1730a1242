#pragma once
/// \file contact_arrows.h
/// Contact pairs as arrows at their nodes.

#include "io/render/layout.h"
#include "io/render/values.h"

namespace abut {

/// Separations of the pairs in contact [m], for a range of colours: those apart reach as far as a cell and would leave
/// no colours for overlaps. All functions here throw std::runtime_error if contact.pvd's files lack an array.
std::vector<double> separations_in_contact(const PointFrame& contact);

/// A scale for separations: diverging, blue where bodies overlap, grey at zero, red where they are apart.
ColourScale separation_scale(Range range, bool exact);

/// An arrow along the normal, from body_a to body_b, at each pair in contact.
void add_normals(Picture& picture, const PointFrame& contact, const Layout& layout);

/// An arrow at each pair, coloured by separation: bold, with a dark edge, where the pair is in contact, thin with an
/// open head where it is apart. Not longer than nodes are apart, if that can be seen; shorter where it points towards
/// the eye or away.
void add_separations(Picture& picture, const PointFrame& contact, const Layout& layout, const ColourScale& scale);

/// What the two kinds of arrows mean, below the height `top` [pixels].
void add_arrow_key(Picture& picture, const Layout& layout, double top);
/// Width of that [pixels].
double arrow_key_width(double unit);

} // namespace abut

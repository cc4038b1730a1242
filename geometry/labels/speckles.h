#pragma once
/// \file speckles.h
/// Components too small to be meant.

#include "geometry/labels/label_volume.h"

#include <cstdint>

namespace abut {

struct RemovedSpeckles {
    std::int64_t pixels = 0;     ///< that have another label than before
    std::int32_t components = 0; ///< of the former labels that have
};

/// Gives each connected component of fewer than `smallest` pixels, holes (components of label 0) included, to the label
/// with which it shares the most faces of pixels; of equals, the smaller label. The image's border counts for nothing.
/// The smallest component goes first (of equals, the one that scanning meets first) and is then one with those
/// components of its new label that it touches, until none is left that is too small, but where nothing else is left.
///
/// Void connects with the complementary connectivity, so that it is a hole just where the bodies' pixels close a ring
/// or a shell by their own connectivity. Memory: 8 bytes per pixel beside the labels, and 24 per component.
///
/// \param connectivity of labels other than 0
RemovedSpeckles remove_speckles(LabelVolume& labels, int connectivity, std::int64_t smallest);

} // namespace abut

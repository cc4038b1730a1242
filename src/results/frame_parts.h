#pragma once
/// \file frame_parts.h
/// What the makers of frames share.

#include "results/arrays.h"
#include "results/frames.h"

namespace abut {

template <int D>
Words body_names(const State<D>& state) {
    Words words{"body_names", {}};
    for (const ModelBody& body : state.bodies) words.values.push_back(body.name);
    return words;
}

/// Field data `step`: steps since the start of the run.
inline Array step_number(long step) {
    return {"step", 1, std::vector<std::int32_t>{static_cast<std::int32_t>(step)}};
}

/// Drops the arrays that were not chosen, and gives the others their units.
inline void keep_wanted(std::vector<Array>& arrays, const FrameChoice& choice) {
    std::erase_if(arrays, [&](const Array& array) { return !choice.wants(array.name); });
    for (Array& array : arrays) array.unit = unit_of_array(array.name);
}

} // namespace abut

#pragma once
/// \file legend.h
/// What each pixel of a picture stands for.

#include "geometry/images/image.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace abut {

/// A colour of a picture that no legend entry covers, and how many pixels have it.
struct UnmatchedColour {
    std::array<int, 3> rgb{};
    std::int64_t pixels = 0;
};

/// A picture in terms of its legend. Labels: 0 is void, k > 0 is bodies[k - 1].
struct LabelledPicture {
    int width = 0, height = 0;
    std::vector<std::string> bodies;           ///< in order of first appearance in the legend, each once
    std::vector<int> label;                    ///< per pixel, rows as in Image; 0 where no entry matches
    std::vector<std::int64_t> pixels_of_entry; ///< per legend entry
    std::vector<UnmatchedColour> unmatched;    ///< most frequent first
};

/// Gives every pixel the legend entry that matches: no channel differs by more than the entry's tolerance. Of several,
/// the one with the smallest largest difference; of equals, the first.
LabelledPicture label_pixels(const Image& image, const std::vector<LegendEntry>& legend);

/// A colour as users write it in a legend: "grey 17" or "#d04020".
std::string colour_name(const std::array<int, 3>& rgb);

} // namespace abut

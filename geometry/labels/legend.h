#pragma once
/// \file legend.h
/// What each colour of a picture stands for.

#include "geometry/images/image.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace abut {

/// A colour that no legend entry covers, and how many pixels have it.
struct UnmatchedColour {
    std::array<int, 3> rgb{};
    std::int64_t pixels = 0;
};

inline constexpr int no_entry = -1;

/// The entry of a legend that a colour belongs to, or no_entry. An entry with a colour matches when no channel differs
/// by more than its tolerance: of several, the one with the smallest largest difference; of equals, the first. Only
/// where none does, an entry with a range matches a grey (three equal components) in it, both ends included: of
/// several, the narrowest; of equals, the first.
int matching_entry(const std::array<int, 3>& rgb, const std::vector<LegendEntry>& legend);

/// A colour as users write it in a legend: "grey 17" or "#d04020", with four digits per channel ("#d04012342000") where
/// a channel is beyond 255.
std::string colour_name(const std::array<int, 3>& rgb);

/// The distinct colours of pictures, numbered from 0 as they are met, so that each is looked up in a legend once
/// however many pixels have it.
class ColourTable {
public:
    struct Colour {
        std::array<int, 3> rgb{};
        std::int64_t pixels = 0;
    };

    /// Counts the pixels of a part of a picture.
    /// \param columns, rows first and last one, both included, inside the picture
    /// \return the number of the colour of each pixel, row by row
    std::vector<std::int32_t> count(const Image& image, const std::array<int, 2>& columns,
                                    const std::array<int, 2>& rows);

    const std::vector<Colour>& colours() const { return colours_; }

private:
    std::int32_t number(const std::array<int, 3>& rgb);

    std::vector<Colour> colours_;
    std::vector<std::int32_t> grey_ = std::vector<std::int32_t>(65536, -1); ///< number of a grey, -1: not met
    std::unordered_map<std::uint64_t, std::int32_t> other_;                 ///< numbers of all other colours
};

/// Colours in terms of a legend.
struct MatchedColours {
    std::vector<int> entry;                    ///< per colour, or no_entry
    std::vector<std::int64_t> pixels_of_entry; ///< per legend entry
    std::vector<UnmatchedColour> unmatched;    ///< most frequent first; of equals, the darkest in red, green, blue
};
MatchedColours match_colours(const std::vector<ColourTable::Colour>& colours, const std::vector<LegendEntry>& legend);

} // namespace abut

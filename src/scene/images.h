#pragma once
#include "scene/bodies.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// One colour of an image, or a range of greys, and what it stands for.
struct LegendEntry {
    std::array<int, 3> rgb{}; ///< 0..255, or 0..65535 in images of 16 bits; equal components when the scene gave "grey"
    bool grey = false;        ///< how the scene named the colour (for messages)
    std::optional<std::array<int, 2>> grey_range; ///< instead of a colour: lowest and highest grey, both included
    int tolerance = 0;                            ///< largest difference per channel that still matches
    bool is_void = false;                         ///< no material; the members below are then unused
    std::string body;     ///< name of the body, or what the names of its bodies begin with (see BodiesBy)
    std::string material; ///< empty if the body is rigid
    std::optional<RigidSpec> rigid;
    Vector velocity{};
    InitialState state{};
};

/// What is one body in an image.
enum class BodiesBy {
    legend,   ///< all that has the same `body` in the legend
    colour,   ///< each colour (of those that the entry matches): body-017, body-d04020
    component ///< each connected component of an entry: body-001, body-002, …
};

/// An image of the same size and place as the bodies' image, whose greys are values of a quantity.
struct ValueImage {
    std::filesystem::path file;
    double black = 0, white = 0; ///< values at the lowest and the highest grey; linear between [SI]
};

/// A picture, or a stack of pictures.
struct ImageSpec {
    std::filesystem::path file; ///< as written; relative paths are relative to the scene file. One "*" in the name
                                ///< stands for the number of a slice: a stack of numbered files
    std::array<double, 3>
        pixel{}; ///< size of a pixel along the axes of the scene [m]; or zero (`size`, or the file's own)
    std::array<double, 3> size{}; ///< size of the whole image along the axes of the scene [m]; or zero
    Vector lower{};               ///< where the image's lower corner lies [m]
    bool first_row_is_up = true;  ///< false: the image's first row is the bottom of the box
    std::optional<int> slice;     ///< plane scenes: which slice of a stack, from 0
    /// First and last column, row (from the first in the file) and slice that are used, from 0; both included. {0, -1}:
    /// all.
    std::optional<std::array<std::array<int, 2>, 3>> crop;
    std::array<bool, 3> flip{}; ///< mirrored along these axes of the file (columns, rows, slices), after the crop
    int quarter_turns = 0;      ///< counter-clockwise, after the flip; 0..3
    int turn_axis = 2;          ///< about which axis
    BodiesBy bodies = BodiesBy::legend;
    int connectivity = 0;        ///< of components: 4 or 8 in the plane, 6, 18 or 26 in 3D; 0: 4 or 6
    int speckle = 0;             ///< components of fewer pixels go to what surrounds them
    std::optional<double> split; ///< components that touch at necks are divided there; depth of a neck [pixels]
    Fill fill = Fill::majority;
    int particles_per_cell = 2; ///< per axis
    std::vector<LegendEntry> legend;
    std::optional<ValueImage> temperature;
    std::optional<ValueImage> orientation;
};

} // namespace abut

#pragma once
/// \file picture.h
/// A picture as plain values in pixel coordinates (x to the right, y upwards, from the lower left corner), and its
/// drawing.

#include "io/render/colours.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace abut {

using Pixel = std::array<double, 2>;

/// Filled quadrilaterals, drawn in their order: later ones cover earlier ones.
struct Quads {
    std::vector<Pixel> corners; ///< four each, around the outline
    std::vector<Rgb> colours;   ///< one each

    void add(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d, Rgb colour);
    void add_rectangle(const Pixel& lower, const Pixel& upper, Rgb colour);
};

/// Filled quadrilaterals in space; those with the larger depth are in front.
struct Faces {
    std::vector<Pixel> corners; ///< four each, around the outline
    std::vector<double> depths; ///< of the corners [pixels]
    std::vector<Rgb> colours;   ///< one each
};

/// Round dots; where they overlap, the one with the larger depth is in front.
struct Dots {
    std::vector<Pixel> centres;
    std::vector<double> depths;
    std::vector<Rgb> colours;
    double diameter = 1; ///< [pixels]
    bool shaded = false; ///< as spheres
};

enum class Align { left, centre, right };

/// A line of text; `at` is where its baseline starts, is centred or ends.
struct Label {
    std::string text;
    Pixel at{};
    double size = 16; ///< font size [pixels]
    Align align = Align::left;
    bool bold = false;
    Rgb colour{40, 40, 40};
};

struct Picture {
    int width = 0, height = 0; ///< [pixels]
    Dots dots;                 ///< behind the quads
    Faces faces;               ///< behind the quads
    Quads quads;
    std::vector<Label> labels; ///< in front
};

class OffscreenContext;

/// Width of a line of text as drawn [pixels].
double text_width(const std::string& text, double size, bool bold = false);

/// Draws on white and writes a PNG file, which appears complete or not at all. Throws std::runtime_error naming file
/// and cause.
void write_png(OffscreenContext& context, const Picture& picture, const std::filesystem::path& path);

} // namespace abut

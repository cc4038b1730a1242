#pragma once
/// \file frame.h
/// What the solver hands to the writers: named arrays, free of any file format.
/// Vectors have 3 components also in 2D, symmetric tensors 6 in VTK's order (xx yy zz xy yz xz).

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace abut {

/// One named array of tuples, `components` values each, stored tuple after tuple.
struct Array {
    std::string name;
    int components = 1;
    std::variant<std::vector<double>, std::vector<std::int32_t>> values;
    std::string unit{}; ///< SI; "" for pure numbers
};

/// A named list of words, e.g. the names of the bodies (VTK field data).
struct Words {
    std::string name;
    std::vector<std::string> values;
};

/// Points with arrays: particles (VTU) or contact pairs (VTP) at one time.
struct PointFrame {
    double time = 0;
    std::vector<double> points; ///< 3 coordinates a point [m]
    std::vector<Array> arrays;  ///< point data
    std::vector<Array> globals; ///< field data beside TimeValue, e.g. one number for the whole frame
    std::vector<Words> words;   ///< field data
};

/// Cells with arrays at one time: lines and flat polygons (VTP), domains of particles (VTU).
struct CellFrame {
    double time = 0;
    std::vector<double> points;                   ///< 3 coordinates a point [m]
    std::vector<std::vector<std::int32_t>> cells; ///< numbers of their corners' points, in VTK's order
    std::vector<Array> arrays;                    ///< cell data
    std::vector<Array> globals;                   ///< field data, as of PointFrame
    std::vector<Words> words;                     ///< field data
};

/// The grid's nodes with arrays (VTI) at one time; x runs fastest.
struct GridFrame {
    double time = 0;
    std::array<int, 3> nodes{1, 1, 1};
    std::array<double, 3> origin{};
    std::array<double, 3> spacing{1, 1, 1};
    std::vector<Array> arrays;
    std::vector<Array> globals; ///< field data, as of PointFrame
    std::vector<Words> words;
};

} // namespace abut

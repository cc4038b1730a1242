#pragma once
/// Stacks in memory, and what label_stack() makes of them.

#include "geometry/labels/label_image.h"
#include "support.h"

#include <functional>
#include <string>
#include <vector>

namespace test {

/// A stack in memory.
struct Stack {
    std::vector<abut::Image> slices;
    abut::StackInfo info() const {
        return {slices[0].width, slices[0].height, static_cast<int>(slices.size()), slices[0].bits, {}};
    }
    abut::ReadSlices read() const {
        return [this](int first, int last, const std::function<void(int, const abut::Image&)>& visit) {
            for (int slice = first; slice <= last; ++slice) visit(slice, slices[static_cast<std::size_t>(slice)]);
        };
    }
};

/// A picture from its rows, top first: '.' is grey 0, digits are their greys.
inline abut::Image slice(const std::vector<std::string>& rows) {
    std::vector<std::vector<int>> greys;
    for (const std::string& row : rows) {
        greys.emplace_back();
        for (const char each : row) greys.back().push_back(each == '.' ? 0 : each - '0');
    }
    return picture(greys);
}

inline abut::LabelledImage label(const abut::ImageSpec& spec, const Stack& stack, int dimension = 2) {
    return abut::label_stack(spec, dimension, stack.info(), stack.read());
}
inline abut::LabelledImage label(const abut::ImageSpec& spec, const std::vector<std::string>& rows) {
    return label(spec, Stack{{slice(rows)}});
}

inline abut::LegendEntry range(int lowest, int highest, const std::string& body) {
    abut::LegendEntry entry = grey(0, body);
    entry.grey_range = {{lowest, highest}};
    return entry;
}
inline abut::ImageSpec spec_of(const std::vector<abut::LegendEntry>& legend,
                               abut::BodiesBy bodies = abut::BodiesBy::legend) {
    abut::ImageSpec spec;
    spec.legend = legend;
    spec.bodies = bodies;
    return spec;
}

} // namespace test

#include "geometry/labels/pixel_order.h"

namespace abut {

PixelOrder pixel_order(const ImageSpec& spec, const std::array<int, 3>& size) {
    PixelOrder order;
    order.axis = {0, 1, 2};
    std::array<int, 3> sign{1, spec.first_row_is_up ? -1 : 1, 1};
    for (std::size_t a = 0; a < 3; ++a)
        if (spec.flip[a]) sign[a] = -sign[a];
    const int u = (spec.turn_axis + 1) % 3, v = (spec.turn_axis + 2) % 3;
    for (int turn = 0; turn < spec.quarter_turns; ++turn) {
        for (std::size_t a = 0; a < 3; ++a) {
            if (order.axis[a] == u) {
                order.axis[a] = v;
            } else if (order.axis[a] == v) {
                order.axis[a] = u;
                sign[a] = -sign[a];
            }
        }
    }
    for (std::size_t a = 0; a < 3; ++a) order.size[static_cast<std::size_t>(order.axis[a])] = size[a];
    const std::array<std::ptrdiff_t, 3> stride{1, order.size[0],
                                               static_cast<std::ptrdiff_t>(order.size[0]) * order.size[1]};
    for (std::size_t a = 0; a < 3; ++a) {
        const std::ptrdiff_t along = stride[static_cast<std::size_t>(order.axis[a])];
        order.step[a] = sign[a] * along;
        if (sign[a] < 0) order.first += (size[a] - 1) * along;
    }
    return order;
}

} // namespace abut

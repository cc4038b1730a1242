#include "geometry/labels/value_image.h"

#include "geometry/images/image.h"
#include "geometry/labels/pixel_order.h"
#include "geometry/labels/used_part.h"

#include <fmt/format.h>

#include <stdexcept>

namespace abut {

ValueVolume value_image(const ImageSpec& spec, int dimension, const std::filesystem::path& file) {
    const StackInfo info = read_stack_info(file);
    const UsedPart used = used_part(spec, dimension, info);
    std::array<int, 3> extent{};
    for (std::size_t a = 0; a < 3; ++a) extent[a] = used[a][1] - used[a][0] + 1;
    const PixelOrder order = pixel_order(spec, extent);
    ValueVolume values;
    values.highest = info.bits == 16 ? 65535 : 255;
    values.volume.size = order.size;
    values.volume.label.resize(static_cast<std::size_t>(extent[0]) * extent[1] * extent[2]);
    read_stack(file, used[2][0], used[2][1], [&](int slice, const Image& image) {
        for (int row = used[1][0]; row <= used[1][1]; ++row)
            for (int column = used[0][0]; column <= used[0][1]; ++column) {
                const std::array<int, 3> rgb = image.rgb(column, row);
                if (rgb[0] != rgb[1] || rgb[1] != rgb[2])
                    throw std::runtime_error(
                        fmt::format("has colours, at column {}, row {}; values need a grey image", column, row));
                const std::ptrdiff_t place = order.first + (column - used[0][0]) * order.step[0] +
                                             (row - used[1][0]) * order.step[1] + (slice - used[2][0]) * order.step[2];
                values.volume.label[static_cast<std::size_t>(place)] = rgb[0];
            }
    });
    return values;
}

} // namespace abut

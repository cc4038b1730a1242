// Pictures of every format; contents tell which.
#include "geometry/images/image.h"
#include "one_file.h"

#include <algorithm>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::OneFile file(".image");
    const auto& path = file.holds(data, size);
    try {
        const abut::StackInfo info = abut::read_stack_info(path);
        if (std::int64_t{info.width} * info.height > 1 << 22) return -1; // right, but slow
        abut::read_stack(path, 0, std::min(info.slices, 3) - 1, [&](int, const abut::Image& image) {
            const std::size_t values = std::size_t(image.width) * image.height * image.channels;
            const int most = (1 << image.bits) - 1;
            if (image.pixels.size() != values || image.width != info.width || image.height != info.height)
                __builtin_trap();
            for (const int value : image.pixels)
                if (value > most) __builtin_trap();
        });
    } catch (const std::runtime_error& error) {
        fuzz::require_helpful(error.what(), path);
    }
    return 0;
}

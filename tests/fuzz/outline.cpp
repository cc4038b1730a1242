// Outlines: CSV and SVG; contents tell which.
#include "geometry/shapes/path_file.h"
#include "one_file.h"

#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::OneFile file(".path");
    const auto& path = file.holds(data, size);
    try {
        abut::read_path_file(path);
    } catch (const std::runtime_error& error) {
        fuzz::require_helpful(error.what(), path);
    }
    return 0;
}

// Time series (.pvd).
#include "io/results/pvd.h"
#include "one_file.h"

#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::OneFile file(".pvd");
    const auto& path = file.holds(data, size);
    try {
        abut::read_pvd(path);
    } catch (const std::runtime_error& error) {
        fuzz::require_helpful(error.what(), path);
    }
    return 0;
}

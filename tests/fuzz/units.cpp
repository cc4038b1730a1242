// Quantities: a value or a UnitError.
#include "io/scene/units.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const abut::Quantity quantity = abut::parse_quantity(text);
        if (!std::isfinite(quantity.value)) __builtin_trap();
        abut::name_of(quantity.dimension);
        if (abut::parse_quantity(text, quantity.dimension) != quantity.value) __builtin_trap();
    } catch (const abut::UnitError&) {
    }
    return 0;
}

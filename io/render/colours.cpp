#include "io/render/colours.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace abut {
namespace {

constexpr Rgb hex(unsigned code) {
    return {static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 8 & 0xff),
            static_cast<std::uint8_t>(code & 0xff)};
}

constexpr std::array body_colours{hex(0x3b6fb6), hex(0xe8862d), hex(0x4b9e55), hex(0xc8463f), hex(0x8b68b1),
                                  hex(0xe3c13a), hex(0x2fa5a8), hex(0x8c5a43), hex(0xe089bd), hex(0x7f8790),
                                  hex(0xa4c639), hex(0x23406e), hex(0xf2a99a), hex(0x17694a), hex(0x9c2f63),
                                  hex(0x8fbfe8), hex(0xb5872b), hex(0x5b3f8c), hex(0xdcd39a), hex(0xe9489d),
                                  hex(0x5f6b2e), hex(0x9fd8b4), hex(0x6e1f28), hex(0xc3b3e6)};

/// Eleven equal steps of matplotlib's viridis.
constexpr std::array viridis{hex(0x440154), hex(0x482576), hex(0x414487), hex(0x35608d), hex(0x2a788e), hex(0x21908c),
                             hex(0x22a884), hex(0x43bf71), hex(0x7ad151), hex(0xbbdf27), hex(0xfde725)};

/// Nine equal steps of Moreland's "smooth cool warm", ParaView's default; its grey middle shows on a white page.
constexpr std::array cool_warm{hex(0x3b4cc0), hex(0x6282ea), hex(0x8db0fe), hex(0xb8d0f9), hex(0xdddddd),
                               hex(0xf5c4ad), hex(0xf49a7b), hex(0xde604d), hex(0xb40426)};

Rgb mix(Rgb a, Rgb b, double weight_of_b) {
    Rgb result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = static_cast<std::uint8_t>(std::lround((1 - weight_of_b) * a[i] + weight_of_b * b[i]));
    return result;
}

Rgb interpolate(std::span<const Rgb> steps, double fraction) {
    const double at = fraction * static_cast<double>(steps.size() - 1);
    const auto lower = std::min(static_cast<std::size_t>(at), steps.size() - 2);
    return mix(steps[lower], steps[lower + 1], at - static_cast<double>(lower));
}

} // namespace

Rgb body_colour(int body) {
    const auto index = static_cast<std::size_t>(std::max(0, body));
    const Rgb colour = body_colours[index % body_colours.size()];
    switch (index / body_colours.size() % 3) {
    case 1:
        return mix(colour, hex(0x000000), 0.3);
    case 2:
        return lighter(colour, 0.4);
    default:
        return colour;
    }
}

Rgb lighter(Rgb colour, double amount) {
    return mix(colour, hex(0xffffff), amount);
}

Rgb map_colour(ColourMap map, double fraction) {
    if (std::isnan(fraction)) return hex(0xff00ff);
    const double clamped = std::clamp(fraction, 0.0, 1.0);
    return map == ColourMap::sequential ? interpolate(viridis, clamped) : interpolate(cool_warm, clamped);
}

} // namespace abut

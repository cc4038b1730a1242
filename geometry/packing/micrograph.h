#pragma once
/// \file micrograph.h
/// Synthetic micrographs and tomograms: blurred, noisy pictures of grains.

#include "geometry/packing/draw_grains.h"

#include <cstdint>
#include <map>
#include <vector>

namespace abut {

/// What a microscope does to a picture.
struct MicrographStyle {
    double blur = 0;             ///< deviation of the Gaussian that blurs it [pixels]; 0 to 20
    double noise = 0;            ///< deviation of the noise of each pixel [greys]; 0 to 100
    int grain = 180, space = 70; ///< grey of all grains and of the void
    std::uint64_t seed = 1;
};

/// \throws std::invalid_argument when a value makes no sense
void check_style(const MicrographStyle& style);

/// Makes the slices of a synthetic micrograph (one) or tomogram, in ascending order.
class Micrograph {
public:
    Micrograph(const ShadedGrains& shaded, const MicrographStyle& style);

    Image slice(int number);

private:
    std::vector<float> blurred_in_plane(int number) const;

    const ShadedGrains& shaded_;
    MicrographStyle style_;
    std::vector<double> kernel_;                ///< of the blur, from the middle outwards
    std::map<int, std::vector<float>> blurred_; ///< slices near the last one
};

/// The legend of a micrograph: greys nearer to the grains' are theirs, `"bodies": "by-component"` tells them apart.
std::string legend_json(const MicrographStyle& style, const std::string& material);

} // namespace abut

#include "geometry/packing/micrograph.h"

#include "geometry/packing/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abut {

void check_style(const MicrographStyle& style) {
    if (!(style.blur >= 0 && style.blur <= 20)) throw std::invalid_argument("blur must be 0 to 20 pixels");
    if (!(style.noise >= 0 && style.noise <= 100)) throw std::invalid_argument("noise must be 0 to 100 greys");
}

Micrograph::Micrograph(const ShadedGrains& shaded, const MicrographStyle& style) : shaded_(shaded), style_(style) {
    check_style(style);
    const int reach = static_cast<int>(std::ceil(3 * style.blur));
    double sum = 0;
    for (int k = 0; k <= reach; ++k) {
        kernel_.push_back(k == 0 ? 1 : std::exp(-0.5 * k * k / (style.blur * style.blur)));
        sum += (k == 0 ? 1 : 2) * kernel_.back();
    }
    for (double& weight : kernel_) weight /= sum;
}

std::vector<float> Micrograph::blurred_in_plane(int number) const {
    const int width = shaded_.width, height = shaded_.height, reach = static_cast<int>(kernel_.size()) - 1;
    std::vector<float> plain, rows;
    for (const int label : shaded_.labels(number))
        plain.push_back(static_cast<float>(label == 0 ? style_.space : style_.grain));
    if (reach == 0) return plain;
    // Beyond its edge the picture goes on as at the edge.
    const auto blur = [&](const std::vector<float>& from, int dx, int dy) {
        std::vector<float> to(from.size());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                double sum = 0;
                for (int k = -reach; k <= reach; ++k) {
                    const int at_x = std::clamp(x + k * dx, 0, width - 1), at_y = std::clamp(y + k * dy, 0, height - 1);
                    sum += kernel_[std::abs(k)] * from[static_cast<std::size_t>(at_y) * width + at_x];
                }
                to[static_cast<std::size_t>(y) * width + x] = static_cast<float>(sum);
            }
        return to;
    };
    return blur(blur(plain, 1, 0), 0, 1);
}

Image Micrograph::slice(int number) {
    const int reach = shaded_.slices > 1 ? static_cast<int>(kernel_.size()) - 1 : 0;
    const auto near = [&](int offset) { return std::clamp(number + offset, 0, shaded_.slices - 1); };
    std::erase_if(blurred_, [&](const auto& each) { return each.first < near(-reach) || each.first > near(reach); });
    std::vector<double> greys(static_cast<std::size_t>(shaded_.width) * shaded_.height, 0);
    for (int offset = -reach; offset <= reach; ++offset) {
        auto found = blurred_.find(near(offset));
        if (found == blurred_.end()) found = blurred_.emplace(near(offset), blurred_in_plane(near(offset))).first;
        const double weight = shaded_.slices > 1 ? kernel_[std::abs(offset)] : 1;
        for (std::size_t k = 0; k < greys.size(); ++k) greys[k] += weight * found->second[k];
    }
    Image image{shaded_.width, shaded_.height, 1, {}};
    Random random(style_.seed * 1000003 + static_cast<std::uint64_t>(number) + 2); // another for each slice
    for (const double grey : greys) {
        const double noise = style_.noise > 0 ? style_.noise * random.normal() : 0;
        image.pixels.push_back(static_cast<std::uint16_t>(std::clamp(std::lround(grey + noise), 0L, 255L)));
    }
    return image;
}

std::string legend_json(const MicrographStyle& style, const std::string& material) {
    const int between = (style.grain + style.space) / 2;
    return fmt::format("\"bodies\": \"by-component\", \"speckle\": 9,\n\"legend\": [\n  {{ \"grey_range\": [{}, 255], "
                       "\"body\": \"grain\", "
                       "\"material\": \"{}\" }},\n  {{ \"grey_range\": [0, {}], \"void\": true }}\n]",
                       between + 1, material, between);
}

} // namespace abut

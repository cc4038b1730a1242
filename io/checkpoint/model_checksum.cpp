#include "io/checkpoint/checkpoint.h"

namespace abut {

std::uint64_t model_checksum(const Model& model) {
    std::uint64_t sum = 14695981039346656037U; // FNV-1a
    const auto add = [&](const void* data, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i)
            sum = (sum ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211U;
    };
    const auto add_all = [&](const auto& values) { add(values.data(), values.size() * sizeof(values[0])); };
    for (const ModelBody& body : model.bodies) add(body.name.c_str(), body.name.size() + 1);
    add_all(model.position);
    add_all(model.half_size);
    add_all(model.body);
    add_all(model.angle);
    add_all(model.temperature);
    add_all(model.orientation);
    return sum;
}

} // namespace abut

#include "io/checkpoint/checkpoint.h"
#include "io/results/checksum.h"

namespace abut {

std::uint64_t model_checksum(const Model& model) {
    Checksum sum;
    const auto add_all = [&](const auto& values) {
        sum.add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])});
    };
    for (const ModelBody& body : model.bodies) sum.add({body.name.c_str(), body.name.size() + 1});
    add_all(model.position);
    add_all(model.half_size);
    add_all(model.body);
    add_all(model.angle);
    add_all(model.temperature);
    add_all(model.orientation);
    return sum.value();
}

} // namespace abut

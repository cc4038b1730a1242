// Scene files: load_scene() gives a scene or a SceneError; a scene that is accepted is accepted again, resolved, and is
// the same.
#include "io/scene/read_scene.h"
#include "one_file.h"
#include "scene/validate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::OneFile file(".json");
    try {
        const std::string resolved = abut::load_scene(file.holds(data, size)).resolved;
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(resolved.data());
        if (abut::load_scene(file.holds(bytes, resolved.size())).resolved != resolved) __builtin_trap();
    } catch (const abut::SceneError&) {
    }
    return 0;
}

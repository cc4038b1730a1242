// Checkpoints: what is read can run on, at least for a step; all else is refused, and the state stays as it was.
// There are no seeds: the files to start from are written by the program under test, so they never grow old.
#include "io/checkpoint/checkpoint.h"
#include "one_file.h"
#include "step/step.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace abut;

/// Two blocks that move towards each other between walls.
State<2> small_state() {
    Scene scene;
    scene.grid = {{1, 1, 0}, {0, 0, 0}, {8, 6, 0}};
    MaterialSpec material;
    material.name = "rubber";
    material.density = 1000;
    material.bulk_modulus = 2e6;
    material.shear_modulus = 1e6;
    scene.materials = {material};
    scene.time.end = 1;
    scene.contact = ContactSpec{};
    scene.boundaries.push_back({"floor", WallSpec{.axis = 1, .position = 1}});
    Model model;
    for (int body = 0; body < 2; ++body) {
        model.bodies.push_back({body == 0 ? "left" : "right", 0, {{body == 0 ? 1.0 : -1.0, 0, 0}}});
        for (int i = 0; i < 16; ++i) {
            model.position.push_back({2.25 + 2 * body + 0.5 * (i % 4), 1.25 + 0.5 * (i / 4), 0});
            model.half_size.push_back({0.25, 0.25, 0});
            model.body.push_back(body);
        }
    }
    return make_state<2>(scene, model);
}

void step(State<2>& state) {
    auto tasks = step_tasks<2>(state.scene);
    state.dt = next_step(state, 1.0);
    advance(state, tasks);
}

const std::vector<std::uint8_t>& sound_file() {
    static const std::vector<std::uint8_t> bytes = [] {
        const fuzz::OneFile file("-sound.h5");
        const std::filesystem::path path = file.holds(nullptr, 0);
        State<2> state = small_state();
        for (int i = 0; i < 20; ++i) step(state);
        write_checkpoint(path, state, OutputProgress{}, "{}", 1);
        std::filesystem::remove(previous_checkpoint(path));
        std::ifstream stream(path, std::ios::binary);
        return std::vector<std::uint8_t>(std::istreambuf_iterator<char>(stream), {});
    }();
    return bytes;
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    const std::vector<std::uint8_t>& sound = sound_file();
    if ((size < 100 || seed % 16 == 0) && sound.size() <= most) {
        std::copy(sound.begin(), sound.end(), data);
        size = sound.size();
    }
    if (seed % 2 == 0 || size < 16) return LLVMFuzzerMutate(data, size, most);
    // Values of the kind that hurt, where arrays of numbers may be: aligned, in place.
    const double reals[] = {0, -1, 1e-300, 1e300, -1e300, 1e18, 0.5};
    const std::int64_t integers[] = {0, -1, 1, 255, 1 << 20, std::int64_t{1} << 31, std::int64_t{1} << 62};
    const std::size_t place = (seed / 32) % (size / 8) * 8;
    const std::size_t which = (seed / 2) % 14;
    std::memcpy(data + place, which < 7 ? static_cast<const void*>(reals + which) : integers + (which - 7), 8);
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::OneFile file(".h5");
    static const State<2> fresh = small_state();
    const auto& path = file.holds(data, size);
    try {
        read_checkpoint_head(path);
    } catch (const std::runtime_error& error) {
        fuzz::require_helpful(error.what(), path);
    }
    State<2> state = fresh;
    try {
        read_checkpoint(path, state);
    } catch (const std::runtime_error& error) {
        fuzz::require_helpful(error.what(), path);
        if (state.step != fresh.step || state.particles.position != fresh.particles.position) __builtin_trap();
        return 0;
    }
    try {
        step(state);
    } catch (const std::runtime_error&) { // a run that cannot go on says so
    }
    return 0;
}

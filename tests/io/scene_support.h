#pragma once
/// \file scene_support.h
/// A good scene that uses almost everything, and the problems of what is made from it.

#include "io/scene/json.h"
#include "io/scene/read_scene.h"
#include "scene/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace abut::scene_test {

/// The contract's example, with what this version has and with every body in the grid.
inline const std::string example = R"({
  "title": "Compaction of a packed bed",     // a comment
  "analysis": "plane-strain", /* another */
  "thickness": "1 m",
  "grid": { "cell": "14.3 um", "lower": ["0 mm", "0 mm"], "upper": ["1 mm", "2 mm"] },
  "time": { "end": "15 us", "cfl": 0.4 },
  "method": {
    "shape": "cpdi",
    "transfer": { "scheme": "xpic", "order": 5 },
    "stress_update": "usl"
  },
  "materials": {
    "aluminium": { "model": "neo-hookean-isochoric",
                   "density": "2.78 g/cm^3", "bulk_modulus": "78.09 GPa", "shear_modulus": "27.6 GPa" },
    "steel": { "model": "neo-hookean", "density": 7800, "youngs_modulus": "200 GPa", "poissons_ratio": 0.25 }
  },
  "bodies": [
    { "name": "block", "material": "aluminium", "box": { "lower": [0, 0], "upper": ["1 mm", "0.5 mm"] },
      "velocity": ["8 m/s", 0] },
    { "name": "ball", "material": "steel", "disk": { "center": ["0.5 mm", "1 mm"], "radius": "0.25 mm" } },
    { "name": "egg", "material": "steel", "particles_per_cell": 3,
      "ellipse": { "center": ["0.5 mm", "1.7 mm"], "semi_axes": ["0.2 mm", "0.1 mm"], "angle": "30 deg" } }
  ],
  "images": [
    { "file": "bed.png", "pixel": "7.14 um", "lower": [0, 0],
      "legend": [ { "grey": 40, "body": "grain-01", "material": "aluminium" },
                  { "rgb": "#d04020", "tolerance": 6, "body": "grain-02", "material": "aluminium",
                    "velocity": [0, "-1 m/s"] },
                  { "grey": 255, "void": true } ] },
    { "file": "/data/top.png", "size": ["1 mm", "0.5 mm"], "lower": [0, "1.5 mm"], "top_row": "bottom",
      "legend": [ { "grey": 0, "body": "grain-01", "material": "aluminium" } ] }
  ],
  "contact": {
    "normal": "logistic-regression",
    "separation": "critical-position", "offset": 0.7,
    "corrections": 2,
    "three_or_more": "lumped",
    "law": { "type": "friction", "coefficient": 0.2 },
    "laws": [ { "bodies": ["block", "ball"], "law": { "type": "perfect" } } ]
  },
  "boundaries": [
    { "name": "floor", "wall": { "axis": "y", "side": "lower", "position": 0, "velocity": 0 } },
    { "name": "piston", "wall": { "axis": "y", "side": "upper", "position": "2 mm", "velocity": "-100 m/s",
                                  "depth": 1.0, "gradient": "3 1/s", "grip": false } }
  ],
  "gravity": [0, "-9.81 m/s^2"],
  "output": { "every": "0.5 us", "history_every": "10 ns", "contact": true }
})";

/// A scene file in a folder of its own that goes away with it.
class SceneOnDisk {
public:
    explicit SceneOnDisk(const std::string& text) {
        static std::atomic<int> count = 0;
        folder_ = std::filesystem::temp_directory_path() /
                  ("abut_scene_" + std::to_string(getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directories(folder_);
        std::ofstream(file()) << text;
    }
    SceneOnDisk(const SceneOnDisk&) = delete;
    SceneOnDisk& operator=(const SceneOnDisk&) = delete;
    ~SceneOnDisk() { std::filesystem::remove_all(folder_); }

    std::filesystem::path file() const { return folder_ / "scene.json"; }
    const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

inline LoadedScene load(const std::string& text, const std::vector<std::string>& overrides = {}) {
    const SceneOnDisk disk(text);
    return load_scene(disk.file(), overrides);
}

inline std::vector<Problem> problems_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        load(text, overrides);
    } catch (const SceneError& error) {
        return error.problems();
    }
    return {};
}

inline Json parsed(const std::string& text) {
    return Json::parse(text, nullptr, true, true);
}

/// The example with the value at a pointer replaced or added; an empty value removes it.
inline std::string changed(const std::string& pointer, const std::string& value) {
    Json scene = parsed(example);
    const Json::json_pointer at(pointer);
    if (value.empty()) {
        Json& parent = scene.at(at.parent_pointer());
        if (parent.is_array()) {
            parent.erase(std::stoul(at.back()));
        } else {
            parent.erase(at.back());
        }
    } else {
        scene[at] = parsed(value);
    }
    return scene.dump();
}

inline std::string in_lines(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) text += problem.pointer + ": " + problem.message + "\n";
    return text;
}

/// A problem at that very pointer whose message has the fragment.
MATCHER_P2(IsProblem, pointer, fragment, "") {
    *result_listener << "{" << arg.pointer << ": " << arg.message << "}";
    return arg.pointer == pointer && arg.message.find(fragment) != std::string::npos;
}

/// One change of the example and the one problem it must bring.
struct Case {
    std::string pointer, value; ///< see changed()
    std::string at, fragment;   ///< the problem
};

inline void expect_problems(const std::vector<Case>& cases) {
    for (const Case& one : cases) {
        const std::vector<Problem> problems = problems_of(changed(one.pointer, one.value));
        EXPECT_THAT(problems, testing::ElementsAre(IsProblem(one.at, one.fragment)))
            << "after " << one.pointer << " = " << one.value << "\n"
            << in_lines(problems);
    }
}

} // namespace abut::scene_test

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
    { "file": "/data/top.png", "size": ["1 mm", "0.5 mm"], "lower": [0, "1.5 mm"], "up": "last-row",
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

/// A 3d scene with what the other example does not use.
inline const std::string example_3d = R"({
  "analysis": "3d",
  "grid": { "cell": "5 mm", "lower": [0, 0, "-5 cm"], "upper": ["10 cm", "10 cm", "5 cm"] },
  "time": { "end": "10 ms", "cfl": 0.3 },
  "method": {
    "shape": "b2gimp",
    "transfer": { "scheme": "fmpm", "order": 4, "position": "mean-velocity", "every_cfl": 0.6 },
    "stress_update": "usavg+",
    "deformation_increment": "exponential",
    "velocity_conditions": "lumped"
  },
  "materials": { "clay": { "model": "linear-elastic", "density": 1500, "youngs_modulus": "1 MPa",
                           "poissons_ratio": 0.3 } },
  "bodies": [
    { "name": "brick", "material": "clay", "box": { "lower": [0, 0, 0], "upper": ["5 cm", "6 cm", "4 cm"] },
      "velocity": [0, 0, "1 mm/s"], "velocity_gradient": [[0, "-2 1/s", 0], [2, 0, 0], [0, 0, "3 Hz"]],
      "velocity_center": ["2.5 cm", "3 cm", 0] },
    { "name": "ball", "material": "clay", "ball": { "center": ["7 cm", "7 cm", 0], "radius": "2 cm" } },
    { "name": "tool", "rigid": { "angular_velocity": { "times": [0, 1], "values": [0, "2 rad/s"] }, "axis": [0, 1, 1] },
      "ball": { "center": ["2 cm", "8 cm", 0], "radius": "1 cm" } }
  ],
  "boundaries": [
    { "name": "lid", "wall": { "axis": "z", "side": "upper", "position": "4 cm", "gradient": "estimated",
                               "velocity": { "times": [0, "2 ms", "5 ms"], "values": [0, "-1 mm/s", 0] } } },
    { "name": "pin", "velocity": { "lower": [0, 0, 0], "upper": ["1 cm", 0, 0], "direction": [1, 0, -2],
                                   "value": "2 mm/s" } },
    { "name": "load", "traction": { "body": "brick", "axis": "x", "side": "upper",
                                    "within": { "lower": [0, 0, 0], "upper": ["5 cm", "6 cm", "2 cm"] },
                                    "stress": [0, { "pulse": { "width": "4 ms", "peak": "10 kPa" } }, "-2 kPa"] } },
    { "name": "push", "traction": { "body": "ball", "axis": "y", "side": "lower",
                                    "pressure": { "times": [0, 1], "values": ["1 kPa", 0] } } }
  ],
  "contact": {},
  "gravity": [0, 0, "-9.81 m/s^2"]
})";

/// A plane scene that uses what makes models: shapes, images, initial states.
inline const std::string example_models = R"({
  "grid": { "cell": "1 mm", "lower": [0, 0], "upper": ["100 mm", "100 mm"] },
  "time": { "end": "1 ms" },
  "materials": { "clay": { "model": "neo-hookean", "density": 1500, "youngs_modulus": "1 MPa", "poissons_ratio": 0.3 } },
  "overlap": "last",
  "shapes": {
    "plate": { "polygon": { "points": [[0, 0], ["40 mm", 0], ["40 mm", "20 mm"], [0, "20 mm"]],
                            "holes": [[["5 mm", "5 mm"], ["9 mm", "5 mm"], ["7 mm", "9 mm"]]] } },
    "eye": { "ring": { "center": ["20 mm", "10 mm"], "inner_radius": "3 mm", "outer_radius": "5 mm" } },
    "logo": { "path": { "file": "logo.svg", "scale": "0.1 mm", "angle": "90 deg", "translation": ["50 mm", 0] } },
    "rest": { "difference": ["plate", "eye"] },
    "both": { "intersection": ["plate", "logo"] }
  },
  "bodies": [
    { "name": "frame", "material": "clay", "shape": "rest", "fill": "covered-fraction", "arrangement": "fitted",
      "velocity": ["1 m/s", 0], "angular_velocity": "30 rad/s", "temperature": "300 K", "orientation": "20 deg",
      "stress": { "xx": "1 MPa", "zz": "0.3 MPa", "xy": "-10 kPa" } },
    { "name": "all", "material": "clay", "union": ["eye", "logo"] }
  ],
  "images": [
    { "file": "ct_*.tif", "slice": 12, "pixel": ["0.1 mm", "0.2 mm"], "lower": [0, "50 mm"], "up": "first-row",
      "crop": { "columns": [10, 109], "rows": [0, 49] }, "flip": ["x", "y"], "quarter_turns": 3, "bodies": "by-component",
      "connectivity": 8, "split": 1.5, "speckle": 20, "fill": "covered-fraction",
      "legend": [ { "grey_range": [20000, 65535], "body": "grain", "material": "clay", "temperature": 350,
                    "angular_velocity": 2 },
                  { "grey_range": [0, 19999], "void": true } ],
      "temperature": { "file": "heat.png", "black": "300 K", "white": "400 K" },
      "orientation": { "file": "axes.png", "black": 0, "white": "180 deg" } }
  ],
  "contact": { "laws": [ { "bodies": ["grain", "frame"], "law": { "type": "stick" } },
                         { "bodies": ["grain", "grain"], "law": { "type": "stick" } },
                         { "bodies": ["grain-07", "all"], "law": { "type": "perfect" } } ] }
})";

/// The same in three dimensions.
inline const std::string example_solids = R"({
  "analysis": "3d",
  "grid": { "cell": "1 mm", "lower": [0, 0, 0], "upper": ["100 mm", "100 mm", "100 mm"] },
  "time": { "end": "1 ms" },
  "materials": { "clay": { "model": "neo-hookean", "density": 1500, "youngs_modulus": "1 MPa", "poissons_ratio": 0.3 } },
  "shapes": {
    "rod": { "cylinder": { "from": [0, 0, 0], "to": [0, 0, "20 mm"], "radius": "3 mm" } },
    "tip": { "cone": { "from": [0, 0, "20 mm"], "to": [0, 0, "25 mm"], "radius": "3 mm", "top_radius": "1 mm" } },
    "pencil": { "union": ["rod", "tip"] },
    "drop": { "implicit": { "expression": "x^2 + y^2 + z^2 - 1", "unit": "5 mm", "lower": ["-6 mm", "-6 mm", "-6 mm"],
                            "upper": ["6 mm", "6 mm", "6 mm"] } }
  },
  "bodies": [
    { "name": "pencil", "material": "clay", "shape": "pencil", "angular_velocity": [0, 0, "3 rad/s"] },
    { "name": "egg", "material": "clay", "ellipsoid": { "center": ["50 mm", "50 mm", "50 mm"],
      "semi_axes": ["5 mm", "6 mm", "7 mm"], "axis": [1, 1, 0], "angle": "30 deg" }, "stress": { "yz": 1000 } },
    { "name": "part", "material": "clay", "surface": { "file": "part.stl", "scale": "1 mm", "axis": [0, 1, 0],
      "angle": "90 deg", "translation": [0, 0, "10 mm"], "repair": true } },
    { "name": "brick", "material": "clay", "box": { "lower": ["80 mm", "80 mm", "80 mm"],
      "upper": ["90 mm", "90 mm", "90 mm"], "angle": "20 deg", "axis": [1, 0, 0] } }
  ],
  "images": [
    { "file": "stack.tif", "pixel": "50 um", "lower": [0, "50 mm", 0], "crop": { "slices": [3, 99] }, "quarter_turns": 1,
      "turn_axis": "x", "legend": [ { "grey": 255, "body": "grain", "material": "clay" }, { "grey": 0, "void": true } ] }
  ]
})";

/// A small axisymmetric scene.
inline const std::string example_axisymmetric = R"({
  "analysis": "axisymmetric",
  "grid": { "cell": ["1 mm", "2 mm"], "lower": [0, 0], "upper": ["20 mm", "20 mm"] },
  "time": { "end": "1 ms" },
  "method": { "shape": "gimp", "transfer": { "scheme": "pic", "position": "mean-velocity" }, "stress_update": "usl+" },
  "materials": { "rubber": { "model": "neo-hookean", "density": 1000, "bulk_modulus": 1e6, "shear_modulus": 0 } },
  "bodies": [ { "name": "can", "material": "rubber", "box": { "lower": [0, 0], "upper": ["10 mm", "10 mm"] },
                "velocity_gradient": [[1, 0], [0, -2]] } ],
  "boundaries": [
    { "name": "mantle", "wall": { "axis": "x", "side": "upper", "position": "10 mm",
                                  "gradient": { "pulse": { "start": "1 us", "width": "2 us", "peak": "5 1/s" } } } }
  ]
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

/// A scene, if not the example, with the value at a pointer replaced or added; an empty value removes it.
inline std::string changed(const std::string& pointer, const std::string& value, const std::string& from = example) {
    Json scene = parsed(from);
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

/// One change of a scene and the one problem it must bring.
struct Case {
    std::string pointer, value; ///< see changed()
    std::string at, fragment;   ///< the problem
};

inline void expect_problems(const std::vector<Case>& cases, const std::string& from = example) {
    for (const Case& one : cases) {
        const std::vector<Problem> problems = problems_of(changed(one.pointer, one.value, from));
        EXPECT_THAT(problems, testing::ElementsAre(IsProblem(one.at, one.fragment)))
            << "after " << one.pointer << " = " << one.value << "\n"
            << in_lines(problems);
    }
}

} // namespace abut::scene_test

#pragma once
/// \file study_support.h
/// Study files in folders of their own, and what is wrong with them.

#include "io/scene/json.h"
#include "io/study/read_study.h"
#include "io/study/variants.h"
#include "scene/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace abut::study_test {

using testing::HasSubstr;

/// A folder that is removed with the test.
class Folder {
public:
    Folder() {
        static int count = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("abut_study_" + std::to_string(getpid()) + "_" + std::to_string(count++));
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

/// A falling block, 2 by 2 cells.
inline const std::string block = R"({
  "grid": { "cell": "1 mm", "lower": [0, 0], "upper": ["10 mm", "10 mm"] },
  "time": { "end": "0.1 ms", "cfl": 0.2 },
  "method": { "transfer": { "scheme": "fmpm", "order": 2 } },
  "materials": { "rubber": { "model": "neo-hookean", "density": "1 g/cm^3",
                             "youngs_modulus": "10 MPa", "poissons_ratio": 0.3 } },
  "bodies": [ { "name": "block", "material": "rubber", "velocity": [0, "-1 m/s"],
                "box": { "lower": ["4 mm", "4 mm"], "upper": ["6 mm", "6 mm"] } } ],
  "gravity": [0, -9.81]
})";

/// A study of `block` with three axes.
inline Json study_json() {
    Json study = Json::parse(R"({
      "title": "A falling block",
      "axes": {
        "cell": { "pointer": "/grid/cell", "values": ["2 mm", "1 mm", "0.5 mm"], "center": "1 mm" },
        "transfer": { "variants": { "FLIP": { "/method/transfer": { "scheme": "flip" } },
                                    "FMPM 4": { "/method/transfer/order": 4 } } },
        "cfl": { "pointer": "/time/cfl", "values": [0.4, 0.2] }
      },
      "metrics": { "loss": { "type": "energy-loss" },
                   "height": { "value": "block.y", "exact": "first_block.y - v*t - g*t^2/2", "reduce": "rms" } },
      "parameters": { "v": "1 m/s", "g": 9.81, "h": "/grid/cell", "twice": "2*h" },
      "tolerances": { "loss": 0.01 },
      "repeats": 2
    })");
    study["base"] = Json::parse(block);
    return study;
}

/// study_json() with an RFC 7396 merge patch.
inline std::string patched(const std::string& patch) {
    Json study = study_json();
    study.merge_patch(Json::parse(patch));
    return study.dump();
}

/// All that is wrong with a study, its variants included: "FILE: POINTER: MESSAGE" lines; empty if nothing is.
inline std::string complaint(const std::string& text) {
    const Folder folder;
    try {
        make_variants(read_study(folder.write("study.json", text)));
        return "";
    } catch (const SceneError& error) {
        return error.what();
    }
}

} // namespace abut::study_test

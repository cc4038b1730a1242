#pragma once
#include "scene/space.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// A series of result files: which frames and arrays it has.
struct SeriesSpec {
    bool write = true;
    std::optional<double> every;     ///< time between two frames [s]; not given: OutputSpec::every
    std::vector<std::string> arrays; ///< names, see results/arrays.h; empty: all
};

/// Contact nodes whose clouds, planes and methods side by side are written beside each contact frame.
struct ContactCloudsSpec {
    std::vector<std::array<int, 3>> nodes; ///< indices from the grid's lower corner; z in plane scenes: -1
    std::vector<Vector> near;              ///< the contact nodes nearest to these places [m]
    std::optional<double> disagreement;    ///< every contact node where normals of methods differ by more [rad]
};

struct OutputSpec {
    double every = 0;                    ///< [s]; 0: first and last state only
    std::optional<double> history_every; ///< [s]; not given: a hundredth of `every`, at least each step
    SeriesSpec particles;
    SeriesSpec grid;
    SeriesSpec contact;                              ///< used by scenes with contact only
    bool pairs = true;                               ///< likewise: pairs.csv
    std::vector<std::string> bodies;                 ///< whose particles and contacts are written; empty: all
    bool single_precision = false;                   ///< reals in the series as float32
    std::optional<ContactCloudsSpec> contact_clouds; ///< scenes with contact
    bool checkpoint = true;                          ///< whether a run can be resumed
    std::optional<double> checkpoint_every;          ///< [s] of the simulation
    std::optional<int> checkpoint_every_steps;
    double checkpoint_every_wall = 600; ///< [s] of wall time
    bool live = false;                  ///< a picture at each frame of the particles, live.png
    std::string live_preset = "bodies"; ///< of that picture, as `abut render` has them
};

} // namespace abut

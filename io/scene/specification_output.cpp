#include "io/render/render_series.h"
#include "io/scene/specification_sections.h"
#include "results/arrays.h"

namespace abut {

namespace {

std::vector<std::string> names(std::span<const ArrayInfo> arrays) {
    std::vector<std::string> result;
    for (const ArrayInfo& array : arrays) result.emplace_back(array.name);
    return result;
}

/// "/output/grid", "/output/grid_every", "/output/grid_arrays", "/output/grid_arrays/#"
void add_series(std::vector<Key>& keys, const std::string& name, const std::string& what, const std::string& where,
                const std::string& list, std::span<const ArrayInfo> arrays) {
    const std::string path = "/output/" + name;
    keys.push_back({.path = path,
                    .kind = Kind::boolean,
                    .otherwise = "true",
                    .meaning = "Whether to write " + what + where + "."});
    keys.push_back({.path = path + "_every",
                    .kind = Kind::quantity,
                    .dimension = dimensions::time,
                    .range = above(0),
                    .meaning = "Time between two frames of " + what + "; not given: `every`."});
    keys.push_back({.path = "/output/" + list,
                    .kind = Kind::list,
                    .range = at_least(1),
                    .meaning = "Which arrays " + what + " have; not given: all. The arrays are explained below."});
    keys.push_back(
        {.path = "/output/" + list + "/#", .kind = Kind::word, .words = names(arrays), .meaning = "Name of an array."});
}

} // namespace

std::vector<Key> output_keys() {
    std::vector<Key> keys{
        {.path = "/output", .kind = Kind::object, .otherwise = "{}", .meaning = "What is written, and when."},
        {.path = "/output/every",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .otherwise = "0",
         .range = at_least(0),
         .meaning = "Time between two frames, each written at the first step at or after its time; 0 writes only the "
                    "first and the last state."},
        {.path = "/output/history_every",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = above(0),
         .meaning =
             "Time between two rows of history.csv, bodies.csv and pairs.csv; not given: a hundredth of `every`, or of "
             "`end` if that is 0."},
    };
    add_series(keys, "particles", "particles (.vtu)", "", "particle_arrays", particle_arrays());
    add_series(keys, "grid", "the grid's nodes (.vti)", "", "grid_arrays", grid_arrays());
    add_series(keys, "contact", "contact pairs at nodes (.vtp)", ", in scenes with contact", "contact_arrays",
               contact_arrays());
    const std::vector<Key> others{
        {.path = "/output/bodies",
         .kind = Kind::list,
         .range = at_least(1),
         .meaning = "Names of the bodies whose particles and contacts are written; not given: all. The grid and the "
                    "tables always tell of all."},
        {.path = "/output/bodies/#", .kind = Kind::name, .meaning = "Name of a body."},
        {.path = "/output/precision",
         .kind = Kind::word,
         .words = {"double", "single"},
         .otherwise = quoted("double"),
         .meaning = "Of the reals in particles, grid and contact pairs: `single` files are about half as large and "
                    "have 7 digits. Time and places of contact nodes stay double."},
        {.path = "/output/pairs",
         .kind = Kind::boolean,
         .otherwise = "true",
         .meaning = "Whether to write the forces between bodies to pairs.csv, in scenes with contact."},
        {.path = "/output/contact_clouds",
         .kind = Kind::object,
         .meaning = "Contact nodes to take apart: with each frame of contact pairs, what the search saw there is "
                    "written as `abut contact` does. In scenes with contact."},
        {.path = "/output/contact_clouds/nodes",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Nodes, by their numbers along the axes."},
        {.path = "/output/contact_clouds/nodes/#",
         .kind = Kind::list,
         .range = from_to(2, 3),
         .meaning = "Numbers of a node along the axes, from 0 at `grid/lower`."},
        {.path = "/output/contact_clouds/nodes/#/#",
         .kind = Kind::integer,
         .range = at_least(0),
         .meaning = "Number along one axis."},
        {.path = "/output/contact_clouds/near",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Places; of each the contact node that is nearest."},
        {.path = "/output/contact_clouds/near/#",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .meaning = "A place."},
        {.path = "/output/contact_clouds/disagreement",
         .kind = Kind::quantity,
         .dimension = dimensions::angle,
         .range = above(0),
         .meaning = "Every contact node where the normals of two methods differ by more than this angle, among "
                    "bodies nearer than a tenth of a cell."},
        {.path = "/output/live",
         .kind = Kind::boolean,
         .otherwise = "false",
         .meaning = "Whether to draw the particles at each of their frames into `live.png` in the result folder, to "
                    "watch a run."},
        {.path = "/output/live_preset",
         .kind = Kind::word,
         .words = render_presets(),
         .otherwise = quoted("bodies"),
         .meaning = "What `live.png` shows: a preset of `abut render`."},
        {.path = "/output/checkpoint",
         .kind = Kind::boolean,
         .otherwise = "true",
         .meaning = "Whether to save the state in `checkpoint.h5`, so that `abut run --resume` can go on: at the "
                    "intervals below, when the run is interrupted and at its end. The last but one is kept as "
                    "`checkpoint-previous.h5`."},
        {.path = "/output/checkpoint_every",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = above(0),
         .meaning = "Simulated time between two checkpoints."},
        {.path = "/output/checkpoint_every_steps",
         .kind = Kind::integer,
         .range = at_least(1),
         .meaning = "Steps between two checkpoints."},
        {.path = "/output/checkpoint_every_wall",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .otherwise = quoted("10 min"),
         .range = above(0),
         .meaning = "Wall time between two checkpoints."},
    };
    keys.insert(keys.end(), others.begin(), others.end());
    return keys;
}

} // namespace abut

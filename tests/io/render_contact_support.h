#pragma once
/// Results of two bodies and their contact pairs, for pictures.

#include "io/render/contact_arrows.h"
#include "io/results/pvd.h"
#include "io/results/write_frame.h"
#include "render_support.h"
#include "results_support.h"

namespace abut::test {

namespace fs = std::filesystem;

constexpr Bounds box{{0, 0, 0}, {2e-3, 1e-3, 0}};

/// Body 0 fills the left half of the box, body 1 the right one.
inline PointFrame particles(double time = 0) {
    PointFrame frame;
    frame.time = time;
    frame.points = {0.5e-3, 0.5e-3, 0, 1.5e-3, 0.5e-3, 0};
    frame.arrays = {{"half_size", 3, std::vector<double>{0.5e-3, 0.5e-3, 0, 0.5e-3, 0.5e-3, 0}},
                    {"body", 1, std::vector<std::int32_t>{0, 1}},
                    {"von_mises_stress", 1, std::vector<double>{1e6, 2e6}},
                    {"strain_energy_density", 1, std::vector<double>{0, 3e3}}};
    frame.words = {{"body_names", {"left", "right"}}};
    return frame;
}

/// Pairs up the middle: in contact overlapping by 2 um, in contact with 1 um between, and two apart by 30 um; normals
/// to the right.
inline PointFrame contacts() {
    PointFrame frame;
    frame.points = {1e-3, 0.2e-3, 0, 1e-3, 0.4e-3, 0, 1e-3, 0.6e-3, 0, 1e-3, 0.8e-3, 0};
    frame.arrays = {{"normal", 3, std::vector<double>{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}},
                    {"separation", 1, std::vector<double>{-2e-6, 1e-6, 30e-6, 30e-6}},
                    {"in_contact", 1, std::vector<std::int32_t>{1, 1, 0, 0}},
                    {"body_a", 1, std::vector<std::int32_t>{0, 0, 0, 0}},
                    {"body_b", 1, std::vector<std::int32_t>{1, 1, 1, 1}}};
    return frame;
}

/// A series of one frame of each kind.
inline fs::path write_series(const TemporaryFolder& folder) {
    write_particles(folder / "p0.vtu", particles());
    PvdSeries{folder / "particles.pvd", {}}.append(0, "p0.vtu");
    write_contact(folder / "c0.vtp", contacts());
    PvdSeries{folder / "contact.pvd", {}}.append(0, "c0.vtp");
    GridFrame grid;
    grid.nodes = {3, 2, 1};
    grid.spacing = {1e-3, 1e-3, 1e-3};
    write_grid(folder / "g0.vti", grid);
    PvdSeries{folder / "grid.pvd", {}}.append(0, "g0.vti");
    return folder.path;
}

inline Layout contact_layout(const ColourScale& scale) {
    return make_layout(box, 1000, 0, std::max(panel_width(scale, 1), arrow_key_width(1)));
}

} // namespace abut::test

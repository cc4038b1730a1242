#include "scene/suggest.h"
#include "scene/validate.h"
#include "scene/validate_parts.h"

#include <cstdio>
#include <string>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

void check_grid(const Scene& scene, Problems& problems) {
    const GridSpec& grid = scene.grid;
    for (std::size_t axis = 0; axis < axes(scene); ++axis) {
        const double extent = grid.upper[axis] - grid.lower[axis];
        const std::string along = std::string(" along ") + axis_names[axis];
        demand(extent > 0, "/grid/upper",
               "must lie above \"lower\"" + along + ": it is at " + metres(grid.upper[axis]) + ", lower at " +
                   metres(grid.lower[axis]),
               problems);
        demand(grid.cell[axis] > 0, "/grid/cell", "must be greater than 0" + along, problems);
        if (extent > 0) {
            demand(!(grid.cell[axis] > extent * (1 + place_rounding)), "/grid/cell",
                   "larger than the grid" + along + ": a cell is " + metres(grid.cell[axis]) + ", the grid " +
                       metres(extent),
                   problems);
        }
    }
}

void check_time(const TimeSpec& time, Problems& problems) {
    demand(time.end > 0, "/time/end", "must be greater than 0 s", problems);
    if (time.step) {
        demand(*time.step > 0, "/time/step", "must be greater than 0 s", problems);
    } else {
        demand(time.cfl > 0 && time.cfl <= 1, "/time/cfl", "must be greater than 0 and at most 1", problems);
    }
    if (time.limits.speed) demand(*time.limits.speed > 0, "/time/limits/speed", "must be greater than 0 m/s", problems);
    demand(time.limits.energy_growth > 0, "/time/limits/energy_growth", "must be greater than 0", problems);
}

/// In axisymmetric scenes x is the radius: nothing lies below 0, and no force is the same all around but along the
/// axis.
void check_symmetry(const Scene& scene, Problems& problems) {
    if (scene.analysis != Analysis::axisymmetric) return;
    const double lower = scene.grid.lower[0];
    const double cell = scene.grid.cell[0];
    demand(lower >= 0, "/grid/lower", "r must not be negative: x is the radius in an axisymmetric scene", problems);
    demand(!(lower > 0 && lower < 2 * cell * (1 - place_rounding)), "/grid/lower",
           "nodes across the axis would be needed: r must begin at 0 or at least 2 cells (" + metres(2 * cell) +
               ") from the axis, not at " + metres(lower),
           problems);
    demand(scene.gravity[0] == 0, "/gravity/0", "gravity along x, the radius, is not symmetric about the axis",
           problems);
}

void check_method(const Scene& scene, Problems& problems) {
    const TransferSpec& transfer = scene.method.transfer;
    demand(transfer.order >= 1, "/method/transfer/order", "must be at least 1", problems);
    if (transfer.every_cfl)
        demand(*transfer.every_cfl > 0, "/method/transfer/every_cfl", "must be greater than 0", problems);
    demand(transfer.scheme != TransferScheme::flip || !transfer.position ||
               transfer.position == PositionUpdate::end_velocity,
           "/method/transfer/position", R"("flip" has its own rule; only "end-velocity" may be given instead)",
           problems);
    demand(!(transfer.scheme == TransferScheme::fmpm && transfer.position == PositionUpdate::start_velocity),
           "/method/transfer/position", R"("start-velocity" does not go with "fmpm"; use "mean-velocity")", problems);
    demand(!(transfer.scheme == TransferScheme::xpic && transfer.position == PositionUpdate::mean_velocity),
           "/method/transfer/position",
           R"("mean-velocity" does not go with "xpic", which leaves noise in the particles' own velocities; use )"
           R"("end-velocity")",
           problems);
    demand(transfer.scheme == TransferScheme::fmpm || scene.method.velocity_conditions == VelocityConditions::combined,
           "/method/velocity_conditions", "is a choice of the transfer scheme \"fmpm\" only", problems);
}

void check_materials(const Scene& scene, Problems& problems) {
    for (const MaterialSpec& material : scene.materials) {
        const std::string pointer = "/materials/" + pointer_token(material.name);
        demand(material.density > 0, pointer + "/density", "must be greater than 0 kg/m^3", problems);
        demand(material.bulk_modulus > 0, pointer, "the bulk modulus must be greater than 0 Pa", problems);
        demand(material.shear_modulus >= 0, pointer, "the shear modulus must not be negative", problems);
        demand(scene.analysis != Analysis::plane_stress || material.shear_modulus != 0, pointer,
               "plane stress needs a shear modulus greater than 0 Pa: a law without shear stiffness has no stress in "
               "the plane when there is none across it",
               problems);
    }
}

} // namespace

std::string with_unit(double value, const char* unit) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), *unit ? "%.6g %s" : "%.6g", value, unit);
    return buffer.data();
}

void demand(bool good, const std::string& pointer, const std::string& message, Problems& problems) {
    if (!good) problems.push_back({pointer, message});
}

std::vector<Problem> validate_numbers(const Scene& scene) {
    Problems problems;
    demand(scene.thickness > 0, "/thickness", "must be greater than 0 m", problems);
    check_grid(scene, problems);
    check_symmetry(scene, problems);
    check_time(scene.time, problems);
    check_method(scene, problems);
    check_materials(scene, problems);
    validate_matter(scene, problems);
    validate_contact(scene, problems);
    validate_boundaries(scene, problems);
    demand(scene.output.every >= 0, "/output/every", "must not be negative", problems);
    if (scene.output.history_every)
        demand(*scene.output.history_every > 0, "/output/history_every", "must be greater than 0 s", problems);
    return problems;
}

} // namespace abut

#include "io/scene/specification_sections.h"

#include "io/scene/words.h"

namespace abut {

std::vector<Key> general_keys() {
    return {
        {.path = "", .kind = Kind::object, .required = true, .meaning = "A scene: everything abut needs for a run."},
        {.path = "/$schema", .kind = Kind::text, .meaning = "Where an editor finds the JSON Schema; not used by abut."},
        {.path = "/abut_version",
         .kind = Kind::text,
         .meaning = "Version of abut that wrote a resolved scene; not used by abut."},
        {.path = "/title", .kind = Kind::text, .otherwise = quoted(""), .meaning = "What the scene shows."},
        {.path = "/analysis",
         .kind = Kind::word,
         .words = texts(analysis_words),
         .otherwise = quoted("plane-strain"),
         .meaning =
             "Kind of analysis. Vectors have 3 components in `3d`, else 2; in `axisymmetric` they are the radius "
             "r (x) and the axis z (y), and a body is the full ring."},
        {.path = "/thickness",
         .kind = Kind::quantity,
         .dimension = dimensions::length,
         .otherwise = "1",
         .range = above(0),
         .only_with = OnlyWith{"analysis", quoted_all({"plane-strain", "plane-stress"})},
         .meaning = "Thickness of a plane scene (in plane stress the one before loading); masses, forces and energies "
                    "are for this thickness."},

        {.path = "/grid", .kind = Kind::object, .required = true, .meaning = "The background grid."},
        {.path = "/grid/cell",
         .kind = Kind::per_axis,
         .dimension = dimensions::length,
         .required = true,
         .range = above(0),
         .meaning = "Wanted size of a cell, one for all axes or one per axis; the box is divided in the nearest whole "
                    "number of cells."},
        {.path = "/grid/lower",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Lower corner of the grid's box."},
        {.path = "/grid/upper",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Upper corner of the grid's box."},

        {.path = "/time", .kind = Kind::object, .required = true, .meaning = "How long and in which steps to run."},
        {.path = "/time/end",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .required = true,
         .range = above(0),
         .meaning = "Time at which the run ends; it begins at 0."},
        {.path = "/time/cfl",
         .kind = Kind::number,
         .otherwise = "0.4",
         .range = {0, 1, true, false},
         .meaning = "Time step divided by (cell size / wave speed); `fmpm` takes less where this would be unstable."},
        {.path = "/time/step",
         .kind = Kind::quantity,
         .dimension = dimensions::time,
         .range = above(0),
         .meaning = "Fixed time step, instead of `cfl`."},
        {.path = "/time/on_trouble",
         .kind = Kind::word,
         .words = texts(on_trouble_words),
         .otherwise = quoted("stop"),
         .meaning = "What happens when the run goes wrong (a particle turned inside out, out of the grid or past "
                    "`limits`, a fixed step above the stable one): `stop`: it ends with a diagnosis; `shrink-step`: it "
                    "goes back to a good state of 100 to 200 steps before and on from there with half the time step, "
                    "at most 5 times. May change on `--resume`."},
        {.path = "/time/limits",
         .kind = Kind::object,
         .otherwise = "{}",
         .meaning = "What no sound run passes; one that does has gone wrong. May change on `--resume`."},
        {.path = "/time/limits/speed",
         .kind = Kind::quantity,
         .dimension = dimensions::velocity,
         .range = above(0),
         .meaning = "Speed of a particle. Not given: ten times the largest wave speed of the scene at its start, or "
                    "ten times what bodies, walls, velocity conditions and gravity bring into it, if that is more."},
        {.path = "/time/limits/energy_growth",
         .kind = Kind::number,
         .otherwise = "1",
         .range = above(0),
         .meaning = "Energy that has appeared out of nothing, as a fraction of all that the scene was given: its "
                    "energy at the start and the work of boundaries, gravity and contact; with `fmpm` times its order. "
                    "Looked at with each row of `history.csv`, "
                    "at least every 50 steps, and at the end of a run."},

        {.path = "/method", .kind = Kind::object, .otherwise = "{}", .meaning = "The numerical method."},
        {.path = "/method/shape",
         .kind = Kind::word,
         .words = texts(shape_words),
         .otherwise = quoted("cpdi"),
         .meaning = "Shape functions between particles and nodes: `linear` sees particles as points, `ugimp` as boxes "
                    "that keep their size, `gimp` as boxes that stretch, `cpdi` as boxes that stretch, shear and turn; "
                    "`b2spline`, `b2gimp` and `b2cpdi` are smoother and wider, with quadratic B-splines."},
        {.path = "/method/transfer",
         .kind = Kind::object,
         .otherwise = "{}",
         .meaning = "What the grid gives back to the particles."},
        {.path = "/method/transfer/scheme",
         .kind = Kind::word,
         .words = texts(scheme_words),
         .otherwise = quoted("flip"),
         .meaning = "How velocities come back: `flip` keeps all detail and noise, `pic` damps most, `xpic` damps "
                    "little and filters noise, `fmpm` does so by an approximation to the full mass matrix."},
        {.path = "/method/transfer/order",
         .kind = Kind::integer,
         .otherwise = "2",
         .range = from_to(1, 100),
         .only_with = OnlyWith{"scheme", quoted_all({"xpic", "fmpm"})},
         .hint = "beyond about 16, round-off and cost outweigh what is gained",
         .meaning = "Number k of terms of XPIC(k) or FMPM(k); 1 is PIC. Beyond about 16, round-off and cost outweigh "
                    "what is gained."},
        {.path = "/method/transfer/position",
         .kind = Kind::word,
         .words = texts(position_words),
         .meaning =
             "How particles move: with the grid velocities at the end of the step, which also deform them; from "
             "those at its start, as published for XPIC (not with `fmpm`; leaves cracks and overlaps after "
             "large compression); or with the mean of the particle's own velocities before and after the step, "
             "as published for FMPM (not with `xpic`). Not given: `mean-velocity` with `fmpm`, `end-velocity` "
             "with `pic` and `xpic`. `flip` moves them by the mean of the grid's velocities at start and end; only "
             "`end-velocity` may be given instead, and is then also that of `flip` steps between others."},
        {.path = "/method/transfer/every_cfl",
         .kind = Kind::number,
         .range = above(0),
         .only_with = OnlyWith{"scheme", quoted_all({"pic", "xpic", "fmpm"})},
         .meaning = "Time between two steps with this scheme, as a multiple of (cell size / wave speed) like "
                    "`/time/cfl`; the steps between are `flip` steps. Not given: every step."},
        {.path = "/method/stress_update",
         .kind = Kind::word,
         .words = texts(stress_update_words),
         .otherwise = quoted("usl"),
         .meaning = "When stresses are updated: `usf` first, `usl` last in a time step, `usavg` by half at both ends; "
                    "`usl+` and `usavg+` extrapolate the new particle velocities to the grid before the last update."},
        {.path = "/method/deformation_increment",
         .kind = Kind::word,
         .words = texts(deformation_increment_words),
         .otherwise = quoted("exponential"),
         .meaning = "How a step's velocity gradient deforms particles: by exp(∇v Δt), as published, which never turns "
                    "them inside out; or by 1 + ∇v Δt, which with `\"position\": \"end-velocity\"` is just what the "
                    "grid's motion does to them, so that bodies spin for many turns without growing."},
        {.path = "/method/velocity_conditions",
         .kind = Kind::word,
         .words = texts(velocity_conditions_words),
         .otherwise = quoted("combined"),
         .meaning = "Where velocities set at nodes (walls, `velocity` boundaries) enter the mass matrix calculation of "
                    "`fmpm`: `lumped` before it, so that neighbours feel them; `velocity` after it, so that they "
                    "hold; `combined` both. Other schemes have only `combined`."},

        {.path = "/overlap",
         .kind = Kind::word,
         .words = texts(overlap_words),
         .otherwise = quoted("refuse"),
         .meaning = "What happens where bodies claim the same place: `refuse`: an error that says which and where; "
                    "`first`: it "
                    "stays with the one that comes first, bodies in their order, then images in theirs; `last`: it "
                    "goes to the "
                    "one that comes last. `abut particles` tells who gave what to whom."},
        {.path = "/gravity",
         .kind = Kind::vector,
         .dimension = dimensions::acceleration,
         .otherwise = "[0, 0]",
         .meaning = "Acceleration of every particle."},
    };
}

} // namespace abut

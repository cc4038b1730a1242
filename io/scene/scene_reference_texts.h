#pragma once
/// \file scene_reference_texts.h
/// What the reference page says beside its tables.

namespace abut {

inline constexpr const char* reference_introduction = R"(# Scene file reference

<!-- Made by `abut reference`; change io/scene/specification*.cpp and io/scene/scene_reference_texts.h instead. -->

A scene is a JSON file; `//` and `/* */` comments are allowed. Unknown keys are errors. `abut check SCENE` names all
the problems of a scene at once and says what a run would do. For completion and checks while you type, let the scene
name the schema: `"$schema": "PATH/TO/abut/io/scene/scene.schema.json"`.

```jsonc
{
  "title": "A ball drops on a block",
  "grid": { "cell": "1 mm", "lower": [0, 0], "upper": ["20 mm", "20 mm"] },
  "time": { "end": "2 ms" },
  "materials": { "rubber": { "model": "neo-hookean", "density": "1 g/cm^3",
                             "youngs_modulus": "10 MPa", "poissons_ratio": 0.4 } },
  "bodies": [
    { "name": "block", "material": "rubber", "box": { "lower": ["3 mm", 0], "upper": ["17 mm", "8 mm"] } },
    { "name": "ball", "material": "rubber", "disk": { "center": ["10 mm", "13 mm"], "radius": "4 mm" },
      "velocity": [0, "-5 m/s"] }
  ],
  "contact": { "law": { "type": "friction", "coefficient": 0.3 } },
  "boundaries": [ { "name": "floor", "wall": { "axis": "y", "side": "lower", "position": 0 } } ],
  "output": { "every": "0.1 ms" }
}
```

**Quantities.** A physical value is a number in SI units, or a text with a unit: `"78.09 GPa"`, `"2.78 g/cm^3"`,
`"14.3 um"`, `"-9.81 m/s^2"`, `"30 deg"`. Units are `m g s Pa N J W K Hz rad` with the prefixes `p n u µ m c k M G T`,
and `min h deg`; they combine by `*`, `/` (from left to right) and `^`. The unit must fit the key. The tables give the
SI unit of each key as its type.

**Vectors** are lists of one value per axis: three in `3d` scenes, two in all others. x points right, y up; in
`axisymmetric` scenes x is the radius r and y the axis. A **matrix** is a list of as many rows. In the headings below
`[ ]` stands for an entry of a list and `NAME` for a name of your own.

**Functions of time** are a quantity that does not change; or points, `{"times": [0, "2 us"], "values": [0, "5 m/s"]}`,
linear between them and constant before the first and after the last one; or a triangular pulse,
`{"pulse": {"start": "1 us", "width": "2 us", "peak": "3 MPa"}}`, which is 0 up to `start` (default 0), rises to `peak`
in half the width and falls back to 0 in the other half.

**Overrides.** `--set PTR=VALUE` replaces a value by its JSON pointer (entries of lists count from 0), for one run:
`--set /method/transfer/order=4`, `--set "/grid/cell=28.6 um"`, `--set /boundaries/3/wall/depth=1`. The value is read
as JSON, else as a text. `scene.json` in the result folder is the scene as it was run: overrides applied, defaults
filled in, SI units; it can be run again and gives the same results bit for bit.

## How things are meant

**Cells and particles.** The grid's box is divided in the nearest whole number of cells along each axis, so a cell may
be a little smaller or larger than asked for; `abut check` prints its size. Disks, ellipses and images are filled with
the places of one lattice, which starts at the grid's lower corner and has `particles_per_cell` particles in a cell
along each axis; a place belongs to a disk or an ellipse if its centre lies in it. A box has a lattice of its own that
fits it exactly; its particles are never wider than a cell. Bodies may touch but not overlap, must lie in the grid and
be no smaller than a cell.

**Analyses.** `plane-strain` allows no stretch across the plane; `plane-stress` finds the one that leaves no stress
across it, and so needs materials with a shear modulus. In `axisymmetric` scenes bodies are full rings about the axis
x = 0; nothing lies at x < 0, so the grid begins at 0 or at least 2 cells away from it, and gravity may only act along
y. Images, disks and ellipses are for these three, balls for `3d`.

**Images** may be PNG, TIFF, JPEG or uncompressed BMP, with 8 bits a channel (grey, palette or RGB) and no
transparency; 16-bit images and images with transparent pixels are refused. Lossy JPEG blurs colours: use it with
`tolerance` only. The first row of the image is the top of the scene unless `up` says otherwise. A particle gets
the body whose pixels cover most of it, whatever the sizes of pixels and particles; the empty space beyond the image's
edge counts as void; of equal shares a body wins over void, and the body that comes first in the legend over others. A
colour that no entry covers is an error that names it; an image without empty space needs no `void` entry. Entries of
the same `body` make up one body.

**Time.** The time step follows the wave speed in the stiffest particle (materials stiffen when compressed), unless
`step` fixes it; a fixed step above the stable one is refused at the start and ends the run later. With `fmpm` the
stable step is smaller, the more so the higher the order; `cfl` is then cut to what is stable (`abut check` tells).
Steps are never shortened for the sake of output: a frame, or a row of history, is written at the end of the first
step at or after the time it is due, and has that time. So output does not change results. Only the last step is
shortened, to end at `end` (or `--until`); the last state is always written.

**Walls.** The faces of the grid are *not* walls: material passes them freely, and a particle that leaves the grid by
more than a cell ends the run with an error. A wall sets the velocity component along its axis, at every node that
lies outside the wall or at most `depth` cells inside it, to `velocity` + `gradient` · (the node's coordinate − the
wall's), and leaves the other components free: it is frictionless. `depth` 0 sets only the nodes on and behind the
wall; with 1, the default, there is always a row of such nodes inside it too, wherever it has moved to. With `grip`
(the default) the wall also holds material that would move away; `"grip": false` lets go of it, as a real plate does.
Walls are unlimited along themselves. `velocity` and `gradient` are functions of time; the wall must stay inside the
grid up to the end.

**Set velocities** (`velocity` among the boundaries) hold one component at all nodes in a box, which does not move.
**Tractions** act on the faces of the particles at one end of a body as it was before any deformation, and go with these
faces: `stress` keeps its direction, `pressure` stays perpendicular to the deformed faces.

**Contact.** Without `contact` all bodies share one velocity field: they stick where they meet. With it, each has its
own, and where nodes see several bodies the `law` of the pair acts between them. `frictionless`, `friction` and
`stick` act only while bodies are pressed together; `perfect` bonds always. `normal` finds the direction of the
contact, `separation` whether bodies touch. Laws only stop bodies that approach; `overlap_correction` also parts those
that overlap already, by a little in each step.

**Results.** All values are in SI units, also those of plane scenes, where masses, forces and energies are those of
the `thickness`; in axisymmetric scenes they are those of the full ring, and what is called x in the tables is r. Stress is Cauchy stress, positive in tension; pressure is positive in compression. In `history.csv`,
`mean_stress_*` is the volume-weighted mean over all particles; `force_NAME_*` is the force of a boundary on the
bodies, its mean since the row before (so that forces times intervals add up to the change of momentum), 0 in the
first row; `external_work` is that of boundaries and gravity and `contact_work` that of contact, both on the bodies since
the start. With contact, the field data `interpenetration` of a particle file is the area by which particle domains of
different bodies overlap, over the area of all.

)";

} // namespace abut

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
be a little smaller or larger than asked for; `abut check` prints its size. Bodies are filled with the places of one
lattice, which starts at the grid's lower corner and has `particles_per_cell` particles in a cell along each axis. With
`fill` `centre` (shapes) or `majority` (images) a body has whole particles at the places whose centre it holds, or
of which it covers most: outlines have steps, and areas are off by some per cent if bodies are few particles wide. With
`covered-fraction` it has a particle wherever it covers any of a place, and the particle has the area (volume) of what is covered,
its centre and its proportions, in plane scenes with `cpdi` and `b2cpdi` also its direction: areas are right to 0.02 % or
better, and outlines follow the shape instead of the lattice. Parts of less than a tenth of a place join the particle beside them. A box has a lattice of its own that fits it exactly (`arrangement` `fitted`, which
others can have too); its particles are never wider than a cell. Bodies may touch (of the same `fill` and
`particles_per_cell`, or their particles may get into each other's way) but not overlap, unless `overlap` says who gives way; they must lie in the grid and be no smaller than a cell. `abut particles` prints for each body its area in
particles and in its image or shape, and how many cells its thinnest part is wide: less than two is too little.

**Shapes.** A body has one shape. `shapes` gives shapes names, so that others can be made of them by `union`,
`difference` and `intersection`. Surfaces from files must be closed, must not cross themselves and must have their outside
outside; else `abut check` says what is wrong, how often and where first. Files have no units: `scale` is the length of
one unit, `"scale": "1 mm"` for a file in millimetres. An implicit surface is meshed to 1/500 of a
particle's edge, which takes seconds where it is large or has sharp edges.

**Analyses.** `plane-strain` allows no stretch across the plane; `plane-stress` finds the one that leaves no stress
across it, and so needs materials with a shear modulus. In `axisymmetric` scenes bodies are full rings about the axis
x = 0; nothing lies at x < 0, so the grid begins at 0 or at least 2 cells away from it, and gravity may only act along
y. The headings of shapes below say which are plane and which for `3d`; boxes, combinations and images are for both.

**Images** may be PNG, TIFF, JPEG, uncompressed BMP or VTI, of 8 or 16 bits a channel, grey, palette or RGB, without
transparency. Several slices (TIFF of several pages, VTI, numbered files) are a stack: the bodies of a `3d` scene, the first
slice lowest, or one `slice` of a plane scene; a single image in `3d` is a stack of one slice, a plate. An image is cropped,
then placed with its first row up (unless `up` says otherwise), mirrored (`flip`) and turned (`quarter_turns`); what is left
begins at `lower`. `pixel` and `size` count along the axes of the scene. Lossy JPEG blurs colours: use it with
`tolerance` or `grey_range`. A colour that no entry covers is an error that names it; an image without empty space needs no
`void` entry. An exact colour wins over a tolerance, a tolerance over a range. Where a place reaches beyond the image, that part
is void; of equal shares the one that lies lower in the place has it, or else farther left, which biases no area. Entries of
the same `body` make up one body, unless `bodies` is `by-colour` or `by-component`: then each colour, or each connected
piece, is one, and the entry's name stands for all of them in `contact/laws`. Noise first: `speckle` removes
pieces of fewer pixels, `split` (1 suits grains) then divides what grew together.

**Initial state.** `velocity`, `velocity_gradient` and `angular_velocity` add up. `stress` is there from the start and acts on the
first step: it is in equilibrium only if something holds the body. Temperatures and orientations are stored and
written if any body has one, but no law of this version uses them. An image of the same pixels may give them place by place:
temperatures are averaged over a particle, orientations taken at its centre.

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

inline constexpr const char* result_arrays = R"(## Arrays of the results

What `output/particle_arrays`, `grid_arrays` and `contact_arrays` choose from. All are point data; vectors have 3
components in plane scenes too, symmetric tensors 6 in VTK's order (xx yy zz xy yz xz). Every file holds the time [s] as
field data `TimeValue`, the number of the step as `step`, the names of the bodies as `body_names` and the units of its
arrays as `units`. `abut render`, `abut contact` and the filter for deformed particles need `half_size` and
`deformation_gradient`.

)";

} // namespace abut

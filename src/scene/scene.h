#pragma once
/// \file scene.h
/// A scene as plain values, in SI units, after reading and before checking its meaning (see validate.h).
/// Two-dimensional analyses use the first two components of every vector and leave the third at zero; axisymmetric
/// ones have r for x and z for y.

#include "scene/time_function.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace abut {

/// Three components, SI units; z is 0 in two-dimensional scenes.
using Vector = std::array<double, 3>;

enum class Analysis {
    plane_strain,
    plane_stress, ///< the stretch across the plane is such that there is no stress across it
    axisymmetric, ///< x is the radius r, y the axis z; a body is the full ring, 2π around
    three_d
};

// === Grid and time

struct GridSpec {
    Vector cell{};  ///< wanted cell size per axis [m]; the box is divided in the nearest whole number of cells
    Vector lower{}; ///< lower corner of the box [m]
    Vector upper{}; ///< upper corner of the box [m]
};

/// What a run does when it goes wrong (step/run_error.h).
enum class OnTrouble {
    stop,
    shrink_step, ///< goes back to a good state and on from there with half the time step, a few times
};

/// What no sound run passes; see step/watch.h.
struct LimitsSpec {
    std::optional<double> speed; ///< of a particle [m/s]; not given: see speed_limit()
    double energy_growth = 1;    ///< energy that appeared out of nothing / energy that the scene was given
};

struct TimeSpec {
    double end = 0;             ///< [s]
    double cfl = 0.4;           ///< time step / (cell / wave speed), cut to cfl_limit(); not used when `step` is given
    std::optional<double> step; ///< fixed time step [s]
    OnTrouble on_trouble = OnTrouble::stop;
    LimitsSpec limits;
};

// === Method

enum class ShapeKind { linear, ugimp, gimp, cpdi, b2spline, b2gimp, b2cpdi };
enum class TransferScheme { flip, pic, xpic, fmpm };

/// When stresses and strains are updated in a step (FMPM paper §2.3, task 5; notes 2.8).
enum class StressUpdate {
    usf,        ///< first: with the velocities at the start of the step
    usavg,      ///< half a step first and half a step last
    usl,        ///< last: with the velocities at the end of the step
    usl_plus,   ///< last, with the updated particle velocities extrapolated anew
    usavg_plus, ///< usavg with the last half as in usl_plus
};

/// How pic, xpic and fmpm move particles; the three rules are the three PIC methods of the FMPM paper's Eq. (2). flip
/// has its own second-order rule, or end_velocity.
enum class PositionUpdate {
    /// X += S v+ Δt: with the same grid velocities that deform the particle when stress is updated last. Positions and
    /// deformation gradients then stay together however far a body is deformed. "MPM PIC" of Eq. (2).
    end_velocity,
    /// X += [S m^-1 p + (V' − V)/2] Δt, as published for XPIC (FMPM paper §2.3). At walls, contacts and free edges the
    /// velocities at the start of a step are those of the last end smoothed once more by the extrapolation, so
    /// particles
    /// move by less than they deform: after large compression their domains leave cracks and overlaps.
    start_velocity,
    /// X += ½ (V + V') Δt, as published for FMPM (Table 1, task 4): the particle's own velocities. Only where the grid
    /// has filtered them (fmpm, pic).
    mean_velocity
};

struct TransferSpec {
    TransferScheme scheme = TransferScheme::flip;
    int order = 2;                          ///< k of xpic and fmpm; flip and pic have none
    std::optional<PositionUpdate> position; ///< not given: position_update()
    /// Time between two steps with pic, xpic or fmpm, in the unit of TimeSpec::cfl; those between are flip steps. Not
    /// given: every step.
    std::optional<double> every_cfl;
};

/// The rule by which particles move: as given, else mean_velocity for fmpm and end_velocity for pic and xpic.
inline PositionUpdate position_update(const TransferSpec& transfer) {
    return transfer.position.value_or(transfer.scheme == TransferScheme::fmpm ? PositionUpdate::mean_velocity
                                                                              : PositionUpdate::end_velocity);
}

/// What a step's velocity gradient makes of a particle: F ← dF F.
enum class DeformationIncrement {
    exponential, ///< dF = exp(∇v Δt), as published (FMPM paper Table 1, task 5): never turns a particle inside out
    /// dF = 1 + ∇v Δt, what a body undergoes whose points go straight by v Δt. With PositionUpdate::end_velocity and
    /// stress updated last, F is the gradient of the particles' own motion, to the last bit in a uniform gradient, so
    /// that a spinning body neither grows nor shrinks. In a spin by θ a step, exp(∇v Δt) has no stretch though
    /// particles come to lie √(1 + θ²) times as far out.
    linear
};

/// Where velocity conditions on nodes enter the full mass matrix calculation of fmpm (FMPM paper §2.4).
enum class VelocityConditions {
    combined, ///< before it, so that neighbours feel them, and after it, so that they hold
    velocity, ///< after it only
    lumped    ///< before it only
};

struct MethodSpec {
    ShapeKind shape = ShapeKind::cpdi;
    TransferSpec transfer;
    StressUpdate stress_update = StressUpdate::usl;
    DeformationIncrement deformation_increment = DeformationIncrement::exponential;
    VelocityConditions velocity_conditions = VelocityConditions::combined; ///< of fmpm
};

// === Materials and bodies

enum class MaterialModel { neo_hookean, neo_hookean_isochoric, linear_elastic };

/// A constitutive law with its constants. The reader converts any pair of elastic constants to (K, G).
struct MaterialSpec {
    std::string name;
    MaterialModel model = MaterialModel::neo_hookean;
    double density = 0;       ///< [kg/m^3]
    double bulk_modulus = 0;  ///< K [Pa]
    double shear_modulus = 0; ///< G [Pa]
};

struct Box {
    Vector lower{}, upper{}; ///< before it is turned [m]
    double angle = 0;        ///< it is turned about its centre, counter-clockwise seen against `axis` [rad]
    Vector axis{0, 0, 1};    ///< of the turn, of any length but 0; z in plane scenes
};
struct Disk {
    Vector center{};   ///< [m]
    double radius = 0; ///< [m]
};
struct Ellipse {
    Vector center{};                   ///< [m]
    std::array<double, 2> semi_axes{}; ///< [m]
    double angle = 0;                  ///< of the first semi-axis, counter-clockwise from x [rad]
};

struct Ball {
    Vector center{};   ///< [m]
    double radius = 0; ///< [m]
};
/// What lies between two circles.
struct Ring {
    Vector center{};         ///< [m]
    double inner_radius = 0; ///< [m]
    double outer_radius = 0; ///< [m]
};
using PlanePoint = std::array<double, 2>;
/// An outline and the outlines of holes in it, each closed from its last point to its first, in any direction.
struct Polygon {
    std::vector<PlanePoint> points;             ///< [m]
    std::vector<std::vector<PlanePoint>> holes; ///< [m]
};
/// How the coordinates of a file become those of the scene: scaled, then turned about the file's origin, then moved.
struct Placement {
    double scale = 1;     ///< what one unit of the file is [m]
    Vector axis{0, 0, 1}; ///< of the turn, of any length but 0; z in plane scenes
    double angle = 0;     ///< counter-clockwise seen against `axis` [rad]
    Vector translation{}; ///< [m]
};
/// Outlines from a CSV file of points or from the paths of an SVG file; those inside others are holes (even-odd).
struct Path {
    std::filesystem::path file;
    Placement placement;
};
struct Ellipsoid {
    Vector center{};      ///< [m]
    Vector semi_axes{};   ///< before it is turned [m]
    Vector axis{0, 0, 1}; ///< of the turn about its centre, of any length but 0
    double angle = 0;     ///< [rad]
};
struct Cylinder {
    Vector from{}, to{}; ///< centres of its ends [m]
    double radius = 0;   ///< [m]
};
struct Cone {
    Vector from{}, to{};   ///< centres of its ends [m]
    double radius = 0;     ///< at `from` [m]
    double top_radius = 0; ///< at `to`; 0: it ends in a point [m]
};
/// A closed surface of triangles from an STL, OFF, PLY or OBJ file.
struct Surface {
    std::filesystem::path file;
    Placement placement;
    bool repair =
        false; ///< close holes, turn faces outwards, remove what crosses itself; else such surfaces are refused
};
/// Where an expression in x, y, z is negative.
struct Implicit {
    std::string expression;
    double unit = 1;         ///< length that is 1 in the expression [m]
    Vector lower{}, upper{}; ///< box that holds it [m]
};
enum class Operation { union_, difference, intersection };
/// Shapes of Scene::shapes, by name; a difference is the first without all others.
struct Combination {
    Operation operation = Operation::union_;
    std::vector<std::string> shapes;
};
/// A shape of Scene::shapes.
struct NamedShape {
    std::string name;
};
using ShapeSpec = std::variant<Box, Disk, Ellipse, Ball, Ring, Polygon, Path, Ellipsoid, Cylinder, Cone, Surface,
                               Implicit, Combination, NamedShape>;

/// Which places of the particle lattice a body takes, and what its particles there are.
enum class Fill {
    centre,          ///< (shapes) places whose centre lies inside: whole particles
    majority,        ///< (images) places of which it covers the largest share: whole particles
    covered_fraction ///< every place it covers in part; particles there have the area and centre of what is covered
};

/// Where the lattice of a shape's particles begins.
enum class Arrangement {
    grid,  ///< at the grid's lower corner: the same for all bodies
    fitted ///< at the shape's own lower corner, its particles a little larger or smaller so that they end at its upper
           ///< one
};

/// Velocities v0 + L (x - x0) of a body's particles at time 0.
struct InitialVelocity {
    Vector value{};                   ///< v0 [m/s]
    std::array<Vector, 3> gradient{}; ///< L, row by row [1/s]
    Vector center{};                  ///< x0, used by the gradient [m]
    Vector at(const Vector& x) const {
        Vector v = value;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) v[i] += gradient[i][j] * (x[j] - center[j]);
        return v;
    }
    bool operator==(const InitialVelocity&) const = default;
};

/// What a body has at time 0 besides its place and its velocity. What is not given is neither stored nor computed.
struct InitialState {
    Vector angular_velocity{};                   ///< adds a rotation about the body's centre of mass [rad/s]
    std::optional<double> temperature;           ///< [K]
    std::optional<std::array<double, 6>> stress; ///< Cauchy, xx yy zz xy yz xz [Pa]
    std::optional<double> orientation;           ///< angle of the material's axes, counter-clockwise from x [rad]
    bool operator==(const InitialState&) const = default;
};

/// Prescribed motion of a body that does not deform and that no force moves (notes 4.2.4).
struct RigidSpec {
    std::array<TimeFunction, 3> velocity{}; ///< of its centre [m/s]
    TimeFunction angular_velocity;          ///< about `axis` through its centre, counter-clockwise [rad/s]
    Vector axis{0, 0, 1};                   ///< of any length but 0; z in plane scenes
    std::optional<Vector> center;           ///< at time 0 [m]; not given: the centre of its volume
};

/// Particles that share one velocity field.
struct BodySpec {
    std::string name;
    std::string material; ///< empty if it is rigid
    std::optional<RigidSpec> rigid;
    ShapeSpec shape;
    InitialVelocity velocity;
    int particles_per_cell = 2; ///< per axis
    Fill fill = Fill::centre;
    std::optional<Arrangement> arrangement{}; ///< not given: fitted for boxes, grid for all others
    InitialState state{};
};

/// A shape that bodies and other shapes use by its name.
struct NamedShapeSpec {
    std::string name;
    ShapeSpec shape;
};

/// One colour of an image, or a range of greys, and what it stands for.
struct LegendEntry {
    std::array<int, 3> rgb{}; ///< 0..255, or 0..65535 in images of 16 bits; equal components when the scene gave "grey"
    bool grey = false;        ///< how the scene named the colour (for messages)
    std::optional<std::array<int, 2>> grey_range; ///< instead of a colour: lowest and highest grey, both included
    int tolerance = 0;                            ///< largest difference per channel that still matches
    bool is_void = false;                         ///< no material; the members below are then unused
    std::string body;     ///< name of the body, or what the names of its bodies begin with (see BodiesBy)
    std::string material; ///< empty if the body is rigid
    std::optional<RigidSpec> rigid;
    Vector velocity{};
    InitialState state{};
};

/// What is one body in an image.
enum class BodiesBy {
    legend,   ///< all that has the same `body` in the legend
    colour,   ///< each colour (of those that the entry matches): body-017, body-d04020
    component ///< each connected component of an entry: body-001, body-002, …
};

/// An image of the same size and place as the bodies' image, whose greys are values of a quantity.
struct ValueImage {
    std::filesystem::path file;
    double black = 0, white = 0; ///< values at the lowest and the highest grey; linear between [SI]
};

/// A picture, or a stack of pictures.
struct ImageSpec {
    std::filesystem::path file; ///< as written; relative paths are relative to the scene file. One "*" in the name
                                ///< stands for the number of a slice: a stack of numbered files
    std::array<double, 3>
        pixel{}; ///< size of a pixel along the axes of the scene [m]; or zero (`size`, or the file's own)
    std::array<double, 3> size{}; ///< size of the whole image along the axes of the scene [m]; or zero
    Vector lower{};               ///< where the image's lower corner lies [m]
    bool first_row_is_up = true;  ///< false: the image's first row is the bottom of the box
    std::optional<int> slice;     ///< plane scenes: which slice of a stack, from 0
    /// First and last column, row (from the first in the file) and slice that are used, from 0; both included. {0, -1}:
    /// all.
    std::optional<std::array<std::array<int, 2>, 3>> crop;
    std::array<bool, 3> flip{}; ///< mirrored along these axes of the file (columns, rows, slices), after the crop
    int quarter_turns = 0;      ///< counter-clockwise, after the flip; 0..3
    int turn_axis = 2;          ///< about which axis
    BodiesBy bodies = BodiesBy::legend;
    int connectivity = 0;        ///< of components: 4 or 8 in the plane, 6, 18 or 26 in 3D; 0: 4 or 6
    int speckle = 0;             ///< components of fewer pixels go to what surrounds them
    std::optional<double> split; ///< components that touch at necks are divided there; depth of a neck [pixels]
    Fill fill = Fill::majority;
    int particles_per_cell = 2; ///< per axis
    std::vector<LegendEntry> legend;
    std::optional<ValueImage> temperature;
    std::optional<ValueImage> orientation;
};

/// What happens where bodies claim the same place.
enum class Overlap {
    refuse, ///< an error
    first,  ///< it stays with the one that comes first: bodies in their order, then images
    last    ///< it goes to the one that comes last
};

// === Contact

enum class NormalMethod {
    logistic_regression,
    linear_regression, ///< its first iterate
    irls_regression,   ///< the same by maximum likelihood (notes 3.4.6)
    average_gradient,
    maximum_gradient,
    maximum_volume,
    own_gradient, ///< each body its own, and apart from the others: does not conserve momentum
    specified     ///< ContactSpec::direction everywhere
};
enum class SeparationMethod { particle_edges, critical_position, fitted_position, displacement, none };
/// Fits of fitted_position from extrapolated positions to edges.
enum class PositionFit { power_law, two_per_cell, one_per_cell };
/// At nodes that see three or more bodies.
enum class ThreeOrMore {
    lumped,    ///< each body against all the others as one (contact paper Eq. 50); does not conserve momentum exactly
    explicit_, ///< every touching pair with its own normal, all pairs at once
    up_to_two  ///< explicit where at most two pairs touch, lumped elsewhere (contact paper §3.4)
};
enum class LawType {
    frictionless,
    friction, ///< Coulomb's
    stick,    ///< no sliding while pressed together
    perfect,  ///< bonded: one body
    adhesion, ///< bonded while touching up to a strength, friction beyond
    viscous_friction,
    linear_interface,   ///< springs between the bodies (notes 5.3)
    bilinear_interface, ///< springs that differ in tension and compression (notes 5.5, 5.6)
    cohesive_interface  ///< elastic traction law with a peak (notes 5.4)
};

struct LawSpec {
    LawType type = LawType::frictionless;
    double coefficient = 0;                     ///< µ of friction, viscous friction and adhesion that has failed
    std::optional<double> static_coefficient{}; ///< friction: at rest; not given: as `coefficient`
    double decay_velocity = 0;                  ///< friction: over which the static one decays [m/s]; 0: at once
    double viscosity = 0;                       ///< viscous friction: shear traction by sliding velocity [Pa s/m]
    std::optional<double> contact_stiffness{};  ///< (friction, frictionless) softened contact [Pa/m], notes 5.7

    double strength = 0;       ///< tensile: of adhesion, and the peak of a cohesive interface [Pa]
    double shear_strength = 0; ///< the same in shear [Pa]
    double reach = 0.1;        ///< adhesion, viscous friction: separation up to which they hold [cells]

    double tension_stiffness = 0;                  ///< D_nt of interfaces [Pa/m]
    std::optional<double> compression_stiffness{}; ///< D_nc [Pa/m]; not given: bodies don't penetrate
    double tangential_stiffness = 0;               ///< D_t [Pa/m]
    double opening = 0;                            ///< cohesive: separation at the peak [m]
    double sliding = 0;                            ///< cohesive: sliding displacement at the peak [m]
};

struct PairLawSpec {
    std::array<std::string, 2> bodies;
    LawSpec law;
};

struct ContactSpec {
    NormalMethod normal = NormalMethod::logistic_regression;
    SeparationMethod separation = SeparationMethod::particle_edges;
    Vector direction{};  ///< of a specified normal, of any length but 0: from the body listed first to the later one
    double offset = 0.8; ///< of critical_position, in cells
    PositionFit fit = PositionFit::power_law; ///< of fitted_position
    double exponent = 0.58;                   ///< of its power law
    int corrections = 2;                      ///< 1 or 2 a step
    ThreeOrMore three_or_more = ThreeOrMore::explicit_;
    /// Share of an overlap of two bodies that a step removes (particle-edges, not lumped). Contact laws stop bodies
    /// that approach, but don't part bodies that already overlap, so that small errors of many steps would add up.
    double overlap_correction = 0.01;
    /// Where a body has a smaller share of a pair's mass at a node, and the two touch, the pair is accelerated as one:
    /// its sliding velocity at the start of the step is kept. Forces that few particles spread over a node where they
    /// have next to no mass would else throw them along the interface.
    double screening = 1e-3;
    /// At a rigid body the normal is its own volume gradient's where that, times this, is at least as large as the
    /// other body's (notes 3.5); 0: never.
    double rigid_bias = 0;
    LawSpec law; ///< of every pair not named in `laws`
    std::vector<PairLawSpec> laws;
};

// === Boundaries and output

enum class Side { lower, upper };

/// A virtual moving wall across one axis (FMPM paper §2.5). It sets the normal velocity of the nodes at most `depth`
/// cells inside it and of every node outside it that has mass.
struct WallSpec {
    int axis = 0;                    ///< 0 x, 1 y, 2 z
    Side side = Side::lower;         ///< lower: material lies above the wall
    double position = 0;             ///< at time 0 [m]
    TimeFunction velocity;           ///< along the axis [m/s]
    double depth = 1;                ///< [cells]
    TimeFunction gradient;           ///< of the normal velocity along the axis at the wall [1/s]
    bool estimated_gradient = false; ///< instead: fitted to the extrapolated velocities (FMPM paper Eq. 4)
    bool grip = true;                ///< false: material may leave the wall
};

/// Sets one component of the velocity of all nodes in a box that stays where it is (notes 2.3.2).
struct VelocitySpec {
    Vector lower{}, upper{}; ///< both ends included [m]
    Vector direction{};      ///< of the component, of any length but 0
    TimeFunction velocity;   ///< along `direction` [m/s]
};

/// Traction on the outer faces of a body's particles (FMPM paper §2.4). Faces are chosen in the undeformed body and
/// deform with their particles.
struct TractionSpec {
    std::string body;
    int axis = 0;                           ///< faces across this axis of the undeformed body
    Side side = Side::lower;                ///< ... at the lower or the upper end of their particles
    std::optional<Box> within;              ///< only of particles whose centres lie in this box at time 0
    std::array<TimeFunction, 3> traction{}; ///< force per deformed area, fixed in direction [Pa]
    TimeFunction pressure;                  ///< against the outward normal of the deformed face [Pa]
};

struct BoundarySpec {
    std::string name;
    std::variant<WallSpec, VelocitySpec, TractionSpec> condition;
};

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

/// All of a scene file.
struct Scene {
    std::string title;
    Analysis analysis = Analysis::plane_strain;
    double thickness = 1; ///< plane strain and plane stress [m]
    GridSpec grid;
    TimeSpec time;
    MethodSpec method;
    std::vector<MaterialSpec> materials;
    std::vector<NamedShapeSpec> shapes;
    std::vector<BodySpec> bodies;
    std::vector<ImageSpec> images;
    Overlap overlap = Overlap::refuse;
    std::optional<ContactSpec> contact;
    std::vector<BoundarySpec> boundaries;
    Vector gravity{};
    OutputSpec output;
};

/// Number of space dimensions of an analysis.
constexpr int dimension(Analysis analysis) {
    return analysis == Analysis::three_d ? 3 : 2;
}

} // namespace abut

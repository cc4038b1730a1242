#pragma once
#include "scene/space.h"

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace abut {

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

/// A shape that bodies and other shapes use by its name.
struct NamedShapeSpec {
    std::string name;
    ShapeSpec shape;
};

} // namespace abut

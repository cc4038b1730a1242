#include "io/scene/specification_sections.h"

namespace abut {

namespace {

struct ShapeTable {
    std::string path;
    std::vector<Key> keys{};

    void object(const std::string& name, const std::string& meaning, const std::optional<OnlyWith>& only_with = {}) {
        keys.push_back({.path = path + name, .kind = Kind::object, .only_with = only_with, .meaning = meaning});
    }
    void place(const std::string& name, const std::string& meaning) {
        keys.push_back({.path = path + name,
                        .kind = Kind::vector,
                        .dimension = dimensions::length,
                        .required = true,
                        .meaning = meaning});
    }
    void length(const std::string& name, const std::string& meaning) {
        keys.push_back({.path = path + name,
                        .kind = Kind::quantity,
                        .dimension = dimensions::length,
                        .required = true,
                        .range = above(0),
                        .meaning = meaning});
    }
    void semi_axes(const std::string& name) {
        keys.push_back({.path = path + name,
                        .kind = Kind::vector,
                        .dimension = dimensions::length,
                        .required = true,
                        .range = above(0),
                        .meaning = "Halves of its diameters, before it is turned."});
    }
    void angle(const std::string& name, const std::string& meaning) {
        keys.push_back({.path = path + name,
                        .kind = Kind::quantity,
                        .dimension = dimensions::angle,
                        .otherwise = "0",
                        .meaning = meaning});
    }
    void axis(const std::string& name) {
        keys.push_back({.path = path + name,
                        .kind = Kind::vector,
                        .only_with = only_in_3d,
                        .meaning = "Axis of the turn, of any length but 0; not given: z."});
    }
    void file(const std::string& name, const std::string& meaning) {
        keys.push_back({.path = path + name, .kind = Kind::file, .required = true, .meaning = meaning});
    }
    void placement(const std::string& name) {
        keys.push_back({.path = path + name + "/scale",
                        .kind = Kind::quantity,
                        .dimension = dimensions::length,
                        .otherwise = "1",
                        .range = above(0),
                        .meaning = "Length of one unit of the file: \"1 mm\" for a file in millimetres."});
        axis(name + "/axis");
        angle(name + "/angle", "By how much it is then turned about the file's origin, counter-clockwise.");
        keys.push_back({.path = path + name + "/translation",
                        .kind = Kind::vector,
                        .dimension = dimensions::length,
                        .otherwise = "[0, 0]",
                        .meaning = "By how much it is then moved."});
    }
    void names(const std::string& name, int least, const std::string& meaning) {
        keys.push_back({.path = path + name, .kind = Kind::list, .range = at_least(least), .meaning = meaning});
        keys.push_back({.path = path + name + "/#", .kind = Kind::name, .meaning = "Name of one of the `shapes`."});
    }
};

void add_plane_shapes(ShapeTable& table) {
    table.object("/disk", "A disk.", only_in_plane);
    table.place("/disk/center", "Centre.");
    table.length("/disk/radius", "Radius.");
    table.object("/ellipse", "An ellipse.", only_in_plane);
    table.place("/ellipse/center", "Centre.");
    table.semi_axes("/ellipse/semi_axes");
    table.angle("/ellipse/angle", "Direction of the first semi-axis, counter-clockwise from x.");
    table.object("/ring", "What lies between two circles.", only_in_plane);
    table.place("/ring/center", "Centre.");
    table.length("/ring/inner_radius", "Radius of the hole.");
    table.length("/ring/outer_radius", "Radius of the outline.");
    table.object("/polygon", "A polygon, with holes if it has any.", only_in_plane);
    table.keys.push_back({.path = table.path + "/polygon/points",
                          .kind = Kind::points,
                          .dimension = dimensions::length,
                          .required = true,
                          .meaning =
                              "Its corners, one after the other, either way around; it closes by itself and must not "
                              "cross itself."});
    table.keys.push_back({.path = table.path + "/polygon/holes",
                          .kind = Kind::outlines,
                          .dimension = dimensions::length,
                          .otherwise = "[]",
                          .meaning = "Corners of each hole."});
    table.object("/path",
                 "Outlines from a file: points in a CSV file (x, y a line; an empty line begins a new outline), or the "
                 "shapes of an SVG drawing, whose lower left corner is the origin. What lies inside an odd number of "
                 "outlines is solid.",
                 only_in_plane);
    table.file("/path/file", "CSV or SVG file; a relative path starts from the folder of the scene file.");
    table.placement("/path");
}

void add_solids(ShapeTable& table) {
    table.object("/ball", "A ball.", only_in_3d);
    table.place("/ball/center", "Centre.");
    table.length("/ball/radius", "Radius.");
    table.object("/ellipsoid", "An ellipsoid.", only_in_3d);
    table.place("/ellipsoid/center", "Centre.");
    table.semi_axes("/ellipsoid/semi_axes");
    table.axis("/ellipsoid/axis");
    table.angle("/ellipsoid/angle", "By how much it is turned about its centre, counter-clockwise.");
    table.object("/cylinder", "A cylinder.", only_in_3d);
    table.place("/cylinder/from", "Centre of one end.");
    table.place("/cylinder/to", "Centre of the other end.");
    table.length("/cylinder/radius", "Radius.");
    table.object("/cone", "A cone, or a part of one.", only_in_3d);
    table.place("/cone/from", "Centre of its base.");
    table.place("/cone/to", "Its tip, or the centre of its other end.");
    table.length("/cone/radius", "Radius of the base.");
    table.keys.push_back({.path = table.path + "/cone/top_radius",
                          .kind = Kind::quantity,
                          .dimension = dimensions::length,
                          .otherwise = "0",
                          .range = at_least(0),
                          .meaning = "Radius of the other end."});
    table.object("/surface",
                 "What is inside a closed surface of triangles: STL, OFF, PLY or OBJ. Surfaces that are open, cross "
                 "themselves or are inside out are refused, with what is wrong and where.",
                 only_in_3d);
    table.file("/surface/file", "The file; a relative path starts from the folder of the scene file.");
    table.placement("/surface");
    table.keys.push_back({.path = table.path + "/surface/repair",
                          .kind = Kind::boolean,
                          .otherwise = "false",
                          .meaning =
                              "Whether to close its holes, turn it inside in and remove what crosses itself; `abut "
                              "particles` tells what was done."});
    table.object("/implicit", "Where an expression in x, y and z is negative.", only_in_3d);
    table.keys.push_back({.path = table.path + "/implicit/expression",
                          .kind = Kind::name,
                          .required = true,
                          .meaning =
                              "For example \"sqrt(x^2 + y^2 + z^2) - 1\". Operators `+ - * / ^`, comparisons and "
                              "`? :`, functions `sin cos tan sqrt exp ln abs min max` and so on (those of muParser)."});
    table.keys.push_back(
        {.path = table.path + "/implicit/unit",
         .kind = Kind::quantity,
         .dimension = dimensions::length,
         .otherwise = "1",
         .range = above(0),
         .meaning = "The length that is 1 in the expression: with \"1 mm\", x, y and z are in millimetres."});
    table.place("/implicit/lower", "Lower corner of a box that holds it.");
    table.place("/implicit/upper", "Upper corner of that box.");
}

} // namespace

const std::vector<std::string>& shape_kinds() {
    static const std::vector<std::string> kinds{
        "box",      "disk", "ellipse", "ring",     "polygon", "path",  "ball",       "ellipsoid",
        "cylinder", "cone", "surface", "implicit", "shape",   "union", "difference", "intersection"};
    return kinds;
}

std::vector<Key> shape_keys(const std::string& path) {
    ShapeTable table{path};
    table.object("/box", "A rectangle, or in `3d` a cuboid.");
    table.place("/box/lower", "Lower corner, before it is turned.");
    table.place("/box/upper", "Upper corner, before it is turned.");
    table.angle(
        "/box/angle",
        "By how much it is turned about its centre, counter-clockwise. In plane scenes its particles are laid out "
        "along its own edges, and their domains are turned with them: `cpdi` and `b2cpdi` see them so, `ugimp` "
        "(and all but these two) as boxes along the axes. Tractions name the faces that they had before the turn.");
    table.axis("/box/axis");
    add_plane_shapes(table);
    add_solids(table);
    table.keys.push_back(
        {.path = path + "/shape", .kind = Kind::name, .meaning = "Name of one of the `shapes` of the scene."});
    table.names("/union", 1, "Names of `shapes`: what lies in any of them.");
    table.names("/difference", 2, "Names of `shapes`: what lies in the first and in none of the others.");
    table.names("/intersection", 2, "Names of `shapes`: what lies in all of them.");
    return table.keys;
}

std::vector<Key> shapes_keys() {
    std::vector<Key> keys{
        {.path = "/shapes",
         .kind = Kind::map,
         .otherwise = "{}",
         .meaning = "Shapes by name, for bodies and for other shapes to use. They make no particles by themselves."},
        {.path = "/shapes/*", .kind = Kind::object, .meaning = "A shape."}};
    for (Key& key : shape_keys("/shapes/*")) keys.push_back(std::move(key));
    return keys;
}

} // namespace abut

#include "io/scene/specification_sections.h"

#include "io/scene/words.h"

#include <iterator>

namespace abut {

namespace {

std::vector<Key> place_keys() {
    return {
        {.path = "/images",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Images whose colours become bodies; one image may hold many. In `3d` an image is a stack."},
        {.path = "/images/#", .kind = Kind::object, .meaning = "An image."},
        {.path = "/images/#/file",
         .kind = Kind::file,
         .required = true,
         .meaning =
             "PNG, TIFF, JPEG, BMP or VTI file; a relative path starts from the folder of the scene file. A stack is a "
             "TIFF of several pages, a VTI, or numbered files: one `*` stands for the number, as in "
             "\"slices/ct_*.png\"."},
        {.path = "/images/#/pixel",
         .kind = Kind::per_axis,
         .dimension = dimensions::length,
         .range = above(0),
         .meaning = "Size of a pixel along the axes of the scene, one for all or one per axis (in `3d` the last is the "
                    "distance of slices). VTI files have their own."},
        {.path = "/images/#/size",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .range = above(0),
         .meaning =
             "Size of the whole image (what `crop` leaves of it) along the axes of the scene, instead of `pixel`."},
        {.path = "/images/#/lower",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Where the lower left corner of the image lies; in `3d` that of the first slice."},
        {.path = "/images/#/up",
         .kind = Kind::word,
         .words = texts(up_words),
         .otherwise = quoted("first-row"),
         .meaning =
             "Which row of the image is up: `first-row` shows the scene as an image viewer does, `last-row` upside "
             "down, as a mirror does."},
        {.path = "/images/#/slice",
         .kind = Kind::integer,
         .range = at_least(0),
         .only_with = only_in_plane,
         .meaning = "Which slice of a stack makes up a plane scene, from 0."},
        {.path = "/images/#/crop",
         .kind = Kind::object,
         .meaning =
             "The part of the image that is used, in pixels of the file as an image editor counts them; the rest is "
             "as if it were not there."},
    };
}

Key crop_key(const std::string& name, const std::string& meaning) {
    return {.path = "/images/#/crop/" + name, .kind = Kind::list, .range = from_to(2, 2), .meaning = meaning};
}

std::vector<Key> arrangement_keys() {
    std::vector<Key> keys;
    const auto add_crop = [&](const std::string& name, const std::string& meaning) {
        keys.push_back(crop_key(name, meaning));
        keys.push_back({.path = "/images/#/crop/" + name + "/#",
                        .kind = Kind::integer,
                        .range = at_least(0),
                        .meaning = "Number of the first, and of the last that is used; counted from 0."});
    };
    add_crop("columns", "First and last column.");
    add_crop("rows", "First and last row, from the top of the file.");
    add_crop("slices", "First and last slice.");
    keys[keys.size() - 2].only_with = only_in_3d;
    const std::vector<Key> more{
        {.path = "/images/#/flip",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Axes along which the image is mirrored."},
        {.path = "/images/#/flip/#",
         .kind = Kind::word,
         .words = texts(axis_words),
         .meaning = "`x` exchanges left and right."},
        {.path = "/images/#/quarter_turns",
         .kind = Kind::integer,
         .otherwise = "0",
         .range = from_to(0, 3),
         .meaning = "By how many quarter turns it is then turned, counter-clockwise."},
        {.path = "/images/#/turn_axis",
         .kind = Kind::word,
         .words = texts(axis_words),
         .otherwise = quoted("z"),
         .only_with = only_in_3d,
         .meaning = "About which axis."},
        {.path = "/images/#/bodies",
         .kind = Kind::word,
         .words = texts(bodies_words),
         .otherwise = quoted("legend"),
         .meaning =
             "What is one body: `legend`: all pixels whose entries name the same body; `by-colour`: all pixels of one "
             "colour; `by-component`: each connected piece of an entry's pixels. With the last two, names of bodies "
             "are the entry's followed by the colour or a number: grain-d04020, grain-017."},
        {.path = "/images/#/connectivity",
         .kind = Kind::integer,
         .range = from_to(4, 26),
         .only_with = OnlyWith{"bodies", {quoted("by-component")}},
         .meaning = "Which neighbours of a pixel are connected with it: 4 or 8 in plane scenes, 6, 18 or 26 in `3d`. "
                    "Not given: "
                    "4 and 6, those that share an edge or a face."},
        {.path = "/images/#/split",
         .kind = Kind::number,
         .range = above(0),
         .only_with = OnlyWith{"bodies", {quoted("by-component")}},
         .meaning =
             "Divides pieces that only touch at their necks (watershed of the distance to the outside): where the "
             "neck's half-width is this many pixels less than that of both sides. 1 to 2 suits grains."},
        {.path = "/images/#/speckle",
         .kind = Kind::integer,
         .otherwise = "0",
         .range = at_least(0),
         .meaning = "Connected pieces of fewer pixels than this, holes too, become what surrounds them."},
        {.path = "/images/#/fill",
         .kind = Kind::word,
         .words = {std::string(text_of(fill_words, Fill::majority)),
                   std::string(text_of(fill_words, Fill::covered_fraction))},
         .otherwise = quoted("majority"),
         .meaning =
             "Which places of the particle lattice a body takes: `majority`: those of which it covers the largest "
             "share, as whole particles; `covered-fraction`: all that it covers in part, by particles with the area "
             "(volume), mass, centre and proportions of what is covered."},
        {.path = "/images/#/particles_per_cell",
         .kind = Kind::integer,
         .otherwise = "2",
         .range = from_to(1, 100),
         .meaning = "Particles in a cell along each axis."},
    };
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

std::vector<Key> legend_keys() {
    return {
        {.path = "/images/#/legend",
         .kind = Kind::list,
         .required = true,
         .range = at_least(1),
         .meaning = "What each colour of the image stands for."},
        {.path = "/images/#/legend/#", .kind = Kind::object, .meaning = "A colour, or a range of greys."},
        {.path = "/images/#/legend/#/grey",
         .kind = Kind::integer,
         .range = from_to(0, 65535),
         .meaning = "Grey level, 0 (black) to 255 (white), in images of 16 bits to 65535."},
        {.path = "/images/#/legend/#/grey_range",
         .kind = Kind::list,
         .range = from_to(2, 2),
         .meaning = "Lowest and highest grey level, both included."},
        {.path = "/images/#/legend/#/grey_range/#",
         .kind = Kind::integer,
         .range = from_to(0, 65535),
         .meaning = "Grey level."},
        {.path = "/images/#/legend/#/rgb", .kind = Kind::colour, .meaning = "Colour as \"#rrggbb\"."},
        {.path = "/images/#/legend/#/tolerance",
         .kind = Kind::integer,
         .otherwise = "0",
         .range = from_to(0, 65535),
         .meaning = "Largest difference in each channel that still counts as this colour."},
        {.path = "/images/#/legend/#/void",
         .kind = Kind::boolean,
         .otherwise = "false",
         .meaning = "Whether the colour is empty space."},
        {.path = "/images/#/legend/#/body",
         .kind = Kind::name,
         .required = true,
         .only_with = OnlyWith{"void", {"false"}},
         .meaning =
             "Name of the body, or what the names of its bodies begin with; several colours and images may make up "
             "one body."},
        {.path = "/images/#/legend/#/material",
         .kind = Kind::name,
         .required = true,
         .only_with = OnlyWith{"void", {"false"}},
         .unless = "rigid",
         .meaning = "Name of its material; rigid bodies have none."},
        {.path = "/images/#/legend/#/velocity",
         .kind = Kind::vector,
         .dimension = dimensions::velocity,
         .otherwise = "[0, 0]",
         .only_with = OnlyWith{"void", {"false"}},
         .unless = "rigid",
         .meaning = "Initial velocity of all its particles."},
    };
}

std::vector<Key> value_image_keys(const std::string& name, const Dimension& dimension, const Range& range,
                                  const std::string& meaning) {
    const std::string path = "/images/#/" + name;
    return {
        {.path = path, .kind = Kind::object, .meaning = meaning},
        {.path = path + "/file",
         .kind = Kind::file,
         .required = true,
         .meaning = "Grey image or stack with the pixels of the bodies' one; crop, flip and turn are the same."},
        {.path = path + "/black",
         .kind = Kind::quantity,
         .dimension = dimension,
         .required = true,
         .range = range,
         .meaning = "Value of grey 0."},
        {.path = path + "/white",
         .kind = Kind::quantity,
         .dimension = dimension,
         .required = true,
         .range = range,
         .meaning = "Value of the highest grey, 255 or in images of 16 bits 65535; linear between."},
    };
}

} // namespace

std::vector<Key> image_keys() {
    std::vector<Key> keys;
    for (std::vector<Key>& more :
         std::vector{place_keys(), arrangement_keys(), legend_keys(),
                     value_image_keys("temperature", dimensions::temperature, above(0),
                                      "Initial temperature of the particles, from a second image."),
                     value_image_keys("orientation", dimensions::angle, {},
                                      "Direction of the material's own x axis, from a second image.")})
        keys.insert(keys.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    return keys;
}

} // namespace abut

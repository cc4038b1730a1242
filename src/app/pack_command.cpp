#include "app/commands.h"
#include "geometry/images/image.h"
#include "geometry/packing/draw_grains.h"
#include "geometry/packing/micrograph.h"
#include "geometry/packing/pack.h"
#include "geometry/packing/pack_scene.h"
#include "scene/suggest.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace abut {

namespace {

std::string extension_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension;
}

void require(bool holds, const std::string& message) {
    if (!holds) throw UsageError(message);
}

/// What the grains and the file make meaningless is refused, not ignored.
void check(const PackOptions& options, GrainKind kind, const std::string& extension) {
    const bool balls = kind == GrainKind::balls, json = extension == ".json";
    const std::vector<std::string> known{".png", ".bmp", ".tif", ".tiff", ".json"};
    require(std::find(known.begin(), known.end(), extension) != known.end(),
            fmt::format("\"{}\": the name must end in .png, .bmp or .tif for a bitmap, or in .json for a scene{}",
                        options.file.string(), did_you_mean(extension, known)));
    require(!balls || json || extension == ".tif" || extension == ".tiff",
            fmt::format("\"{}\": balls are written as a .tif stack or a .json scene", options.file.string()));
    require(balls || !options.depth, "--depth is for balls only");
    require(kind == GrainKind::ellipses || (!options.min_aspect && !options.max_aspect),
            "--min-aspect and --max-aspect are for ellipses only");
    require(!json || (!options.shades && !options.neighbour_distance && !options.blur && !options.noise),
            "--shades, --neighbour-distance, --blur and --noise are for bitmaps; a .json scene has shapes");
    require((!options.blur && !options.noise) || (!options.shades && !options.neighbour_distance),
            "with --blur or --noise all grains have one grey: leave out --shades and --neighbour-distance");
    require(!options.pixel || (std::isfinite(*options.pixel) && *options.pixel > 0 && *options.pixel <= 1e3),
            "--pixel: a pixel must be longer than 0, and at most 1000 m");
    const bool plain = std::none_of(options.material.begin(), options.material.end(),
                                    [](unsigned char c) { return c < 0x20 || c == '"' || c == '\\'; });
    require(!options.material.empty() && plain,
            "--material: a name without quotation marks, backslashes and control characters is needed");
}

PackRequest request_of(const PackOptions& options, GrainKind kind) {
    const bool balls = kind == GrainKind::balls;
    PackRequest request;
    request.kind = kind;
    request.width = options.width.value_or(balls ? 100 : request.width);
    request.height = options.height.value_or(balls ? 100 : request.height);
    request.depth = balls ? options.depth.value_or(100) : 0;
    request.bodies = options.bodies;
    request.area_fraction = options.area_fraction.value_or(kind == GrainKind::polygons ? 0.9 : balls ? 0.4 : 0.55);
    if (options.sizes) request.sizes = parse_sizes(*options.sizes);
    // One of the two moves the other along where it must.
    if (options.min_aspect) request.max_aspect = std::max(request.max_aspect, *options.min_aspect);
    request.min_aspect = options.min_aspect.value_or(request.min_aspect);
    request.max_aspect = options.max_aspect.value_or(request.max_aspect);
    request.gap = options.gap;
    request.seed = options.seed;
    return request;
}

void write_text(const std::string& text, const std::filesystem::path& file) {
    const std::filesystem::path part = file.string() + fmt::format(".{}.part", getpid());
    std::ofstream stream(part, std::ios::binary);
    stream << text;
    stream.close();
    std::error_code error;
    if (stream) std::filesystem::rename(part, file, error);
    if (stream && !error) return;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw std::runtime_error(
        fmt::format("cannot write \"{}\": {}", file.string(),
                    error ? error.message() : "no such folder, no permission, or the disk is full"));
}

std::string summary(const PackOptions& options, const PackedGrains& packed) {
    const bool balls = packed.kind == GrainKind::balls;
    std::string text = fmt::format("{}: {} {} fill {:.4f} of the {}", options.file.string(), packed.grains.size(),
                                   word(packed.kind), packed.fraction, balls ? "volume" : "area");
    if (packed.kind == GrainKind::polygons) text += fmt::format(", gaps of {:.4g} pixels", packed.polygon_gap);
    if (balls || packed.kind == GrainKind::disks)
        text += fmt::format(", {} contacts (within 1 % of the mean diameter)", packed.contacts);
    return text;
}

/// The head of the image in a scene, up to its legend.
std::string image_head(const PackOptions& options, bool balls) {
    if (!options.pixel) return {};
    const std::string pixel =
        balls ? fmt::format("[{0}, {0}, {0}]", *options.pixel) : fmt::format("{}", *options.pixel);
    return fmt::format("\"file\": \"{}\", \"lower\": [0, 0{}], \"pixel\": {},\n", options.file.filename().string(),
                       balls ? ", 0" : "", pixel);
}

void write_pictures(const ShadedGrains& shaded, const std::function<Image(int)>& slice, const PackOptions& options,
                    bool stack) {
    if (stack)
        write_stack(shaded.slices, slice, options.file);
    else
        write_image(slice(0), options.file);
}

bool is_micrograph(const PackOptions& options) {
    return options.blur || options.noise;
}

DrawingStyle style_of(const PackOptions& options) {
    DrawingStyle style;
    style.seed = options.seed;
    style.neighbour_distance = options.neighbour_distance;
    style.shades = options.shades.value_or(style.shades);
    if (is_micrograph(options)) { // its greys are its own
        style.shades = 1;
        style.neighbour_distance.reset();
        style.all_alike = true;
    }
    return style;
}

MicrographStyle microscope_of(const PackOptions& options) {
    MicrographStyle style;
    style.blur = options.blur.value_or(0);
    style.noise = options.noise.value_or(0);
    style.seed = options.seed;
    return style;
}

/// What `work` gives; what it can't do is the fault of the command line: out of range, or more than there is room for.
template <class Work>
auto asked(const Work& work) {
    try {
        return work();
    } catch (const std::exception& error) {
        throw UsageError(error.what());
    }
}

int pack_bitmap(const PackOptions& options, const PackedGrains& packed) {
    const bool balls = packed.kind == GrainKind::balls, micrograph = is_micrograph(options);
    const MicrographStyle microscope = microscope_of(options);
    const ShadedGrains shaded = asked([&] { return shade_grains(packed, style_of(options)); });
    Micrograph picture(shaded, microscope);
    write_pictures(
        shaded, [&](int slice) { return micrograph ? picture.slice(slice) : draw(shaded, slice); }, options, balls);

    fmt::print("{}, {:.4f} of the pixels", summary(options, packed), shaded.fraction);
    if (!micrograph && shaded.shades.size() < packed.grains.size())
        fmt::print("; grains at most {} pixel{} apart differ", shaded.neighbour_distance,
                   shaded.neighbour_distance == 1 ? "" : "s");
    fmt::print("; a legend for a scene:\n{}{}\n", image_head(options, balls),
               micrograph ? legend_json(microscope, options.material) : legend_json(shaded, options.material));
    return 0;
}

} // namespace

int pack_command(const PackOptions& options) {
    const std::string extension = extension_of(options.file);
    const bool json = extension == ".json";
    const PackedGrains packed = asked([&] {
        const GrainKind kind = parse_grain_kind(options.grains);
        check(options, kind, extension);
        const PackRequest request = request_of(options, kind);
        if (!json) { // before the long work
            check_style(style_of(options));
            check_style(microscope_of(options));
        }
        return pack_grains(request);
    });
    if (!json) return pack_bitmap(options, packed);
    const std::string title = fmt::format("{} {}, seed {}", packed.grains.size(), word(packed.kind), options.seed);
    write_text(scene_of(packed, options.pixel.value_or(1e-6), options.material, title), options.file);
    fmt::print("{}\n", summary(options, packed));
    return 0;
}

} // namespace abut

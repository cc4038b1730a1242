#include "geometry/packing/pack.h"

#include "geometry/images/image.h"
#include "geometry/packing/ball_packing.h"
#include "geometry/packing/ellipse_packing.h"
#include "geometry/packing/laguerre.h"
#include "geometry/packing/polygon_packing.h"
#include "scene/suggest.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace abut {

namespace {

constexpr std::array<std::pair<std::string_view, GrainKind>, 4> kinds{{{"disks", GrainKind::disks},
                                                                       {"ellipses", GrainKind::ellipses},
                                                                       {"polygons", GrainKind::polygons},
                                                                       {"balls", GrainKind::balls}}};

void require(bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
}

void check(const PackRequest& request) {
    const bool balls = request.kind == GrainKind::balls, polygons = request.kind == GrainKind::polygons;
    require(request.width > 0 && request.height > 0, "width and height must be at least 1 pixel");
    require(!balls || request.depth > 0, "depth must be at least 1 pixel");
    require(static_cast<std::int64_t>(request.width) * request.height <= most_pixels,
            "width times height must not be more than 2^28 pixels");
    require(request.bodies > 0, "there must be at least 1 body");
    require(request.bodies <= most_grains, "there must not be more than 100000 bodies");
    require(!polygons || request.bodies > 1, "there must be at least 2 polygons");
    require(request.min_aspect >= 1 && request.max_aspect >= request.min_aspect && std::isfinite(request.max_aspect),
            "aspects must be at least 1, the largest not below the smallest");
    check_sizes(request.sizes);
    if (polygons)
        require(request.area_fraction > 0 && request.area_fraction <= 1,
                "the area fraction of polygons must lie between 0 and 1 (1: no gaps)");
    else
        require(request.area_fraction > 0 && request.area_fraction < 1,
                balls ? "the volume fraction must lie between 0 and 1" : "the area fraction must lie between 0 and 1");
    require(request.gap >= 0 && std::isfinite(request.gap), "the gap must not be negative");
}

template <int D>
PackedBalls<D> pack_round(const PackRequest& request, const PointD<D>& box, PackedGrains& packed) {
    Random random(request.seed + 1); // not the stream that places them
    const PackedBalls<D> balls = pack_balls<D>(
        {box, sample_sizes(request.sizes, request.bodies, random), request.area_fraction, request.gap, request.seed});
    const double mean_radius = std::accumulate(balls.radii.begin(), balls.radii.end(), 0.0) / request.bodies;
    packed.contacts = count_contacts<D>(balls, box, request.gap + 0.02 * mean_radius);
    return balls;
}

/// Area or volume of a grain.
double content(const ShapeSpec& grain) {
    if (const auto* disk = std::get_if<Disk>(&grain)) return std::numbers::pi * disk->radius * disk->radius;
    if (const auto* ball = std::get_if<Ball>(&grain)) return 4 * std::numbers::pi / 3 * std::pow(ball->radius, 3);
    if (const auto* polygon = std::get_if<Polygon>(&grain)) return signed_area(polygon->points);
    const auto& axes = std::get<Ellipse>(grain).semi_axes;
    return std::numbers::pi * axes[0] * axes[1];
}

} // namespace

GrainKind parse_grain_kind(std::string_view word) {
    std::vector<std::string> names;
    for (const auto& [name, kind] : kinds) {
        if (name == word) return kind;
        names.emplace_back(name);
    }
    throw std::invalid_argument(
        fmt::format("no grains \"{}\"{} (there are: {})", word, did_you_mean(word, names), quoted_list(names, "and")));
}

std::string word(GrainKind kind) {
    for (const auto& [name, each] : kinds)
        if (each == kind) return std::string(name);
    return {};
}

PackedGrains pack_grains(const PackRequest& request) {
    check(request);
    const auto width = static_cast<double>(request.width), height = static_cast<double>(request.height);
    PackedGrains packed{request.kind, request.width, request.height, 0, {}};
    if (request.kind == GrainKind::ellipses) {
        for (const Ellipse& each : pack_ellipses({width, height, request.bodies, request.min_aspect, request.max_aspect,
                                                  request.sizes, request.area_fraction, request.gap, request.seed}))
            packed.grains.emplace_back(each);
    } else if (request.kind == GrainKind::disks) {
        const PackedBalls<2> disks = pack_round<2>(request, {width, height}, packed);
        for (std::size_t k = 0; k < disks.radii.size(); ++k)
            packed.grains.emplace_back(Disk{{disks.centres[k][0], disks.centres[k][1], 0}, disks.radii[k]});
    } else if (request.kind == GrainKind::balls) {
        packed.depth = request.depth;
        const PackedBalls<3> balls =
            pack_round<3>(request, {width, height, static_cast<double>(request.depth)}, packed);
        for (std::size_t k = 0; k < balls.radii.size(); ++k)
            packed.grains.emplace_back(Ball{balls.centres[k], balls.radii[k]});
    } else {
        PackedPolygons polygons = pack_polygons(
            {width, height, request.bodies, request.sizes, request.area_fraction, request.gap, request.seed});
        packed.polygon_gap = polygons.gap;
        for (Polygon& each : polygons.polygons) packed.grains.emplace_back(std::move(each));
    }
    for (const ShapeSpec& grain : packed.grains) packed.fraction += content(grain);
    packed.fraction /= width * height * (request.kind == GrainKind::balls ? request.depth : 1);
    return packed;
}

} // namespace abut

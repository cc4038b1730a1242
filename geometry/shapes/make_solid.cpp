#include "geometry/shapes/make_solid.h"

#include "geometry/shapes/outline.h"
#include "geometry/shapes/path_file.h"
#include "geometry/shapes/round_solids.h"
#include "geometry/shapes/surface.h"
#include "scene/suggest.h"
#include "scene/turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace abut {

namespace {

/// Names of the shapes that are being made, one within the other.
using Nesting = std::vector<std::string>;

/// How often simple shapes may occur in a shape of shapes: names that double from shape to shape would grow without
/// end.
constexpr std::size_t most_parts = 10000;
constexpr std::size_t deepest = 100;

struct Making {
    const ShapeContext& context;
    std::vector<std::string>* repairs;
    Nesting nesting{};
    std::map<std::string, Solid> made{};        ///< each named shape is made once
    std::map<std::string, std::size_t> parts{}; ///< of simple shapes in it
    std::size_t count = 0;                      ///< of simple shapes in what is being made
};

Solid make(const ShapeSpec& shape, Making& making);

const ShapeSpec& look_up(const std::string& name, const ShapeContext& context) {
    std::vector<std::string> known;
    for (const NamedShapeSpec& named : context.shapes) {
        if (named.name == name) return named.shape;
        known.push_back(named.name);
    }
    throw std::runtime_error(fmt::format("no shape \"{}\"{}", name, did_you_mean(name, known)));
}

Solid make_named(const std::string& name, Making& making) {
    if (const auto known = making.made.find(name); known != making.made.end()) {
        making.count += making.parts[name];
        if (making.count > most_parts)
            throw std::runtime_error(fmt::format("shape \"{}\" and others make more than {} shapes", name, most_parts));
        return known->second;
    }
    if (making.nesting.size() >= deepest)
        throw std::runtime_error(fmt::format("shapes are made from shapes more than {} deep", deepest));
    if (std::find(making.nesting.begin(), making.nesting.end(), name) != making.nesting.end())
        throw std::runtime_error(fmt::format("shape \"{}\" is made from itself", name));
    const ShapeSpec& shape = look_up(name, making.context);
    if (!exists_in(shape, making.context.dimension))
        throw std::runtime_error(fmt::format("shape \"{}\" is {}, the scene is not", name,
                                             making.context.dimension == 2 ? "one in space" : "plane"));
    making.nesting.push_back(name);
    const std::size_t before = making.count;
    Solid solid = make(shape, making);
    making.nesting.pop_back();
    making.parts[name] = making.count - before;
    making.made[name] = solid;
    return solid;
}

Solid combine(const Combination& combination, Making& making) {
    if (combination.shapes.empty()) throw std::runtime_error("combines no shapes");
    std::vector<Solid> solids;
    for (const std::string& name : combination.shapes) solids.push_back(make_named(name, making));
    Solid result = solids.front();
    for (const Solid& solid : solids) result.half_open = result.half_open && solid.half_open;
    for (std::size_t k = 1; k < solids.size(); ++k) {
        for (std::size_t a = 0; a < 3; ++a) {
            if (combination.operation == Operation::union_) {
                result.lower[a] = std::min(result.lower[a], solids[k].lower[a]);
                result.upper[a] = std::max(result.upper[a], solids[k].upper[a]);
            } else if (combination.operation == Operation::intersection) {
                result.lower[a] = std::max(result.lower[a], solids[k].lower[a]);
                result.upper[a] = std::min(result.upper[a], solids[k].upper[a]);
            }
        }
        for (std::size_t a = 0; a < 2; ++a)
            result.breaks[a].insert(result.breaks[a].end(), solids[k].breaks[a].begin(), solids[k].breaks[a].end());
    }
    for (std::size_t a = 0; a < static_cast<std::size_t>(making.context.dimension); ++a)
        if (!(result.lower[a] < result.upper[a]))
            throw std::runtime_error("is empty: the shapes have nothing in common");
    for (auto& breaks : result.breaks) {
        std::sort(breaks.begin(), breaks.end());
        breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    }
    result.spans = [solids, operation = combination.operation](double x, double y) {
        Spans spans = solids.front().spans(x, y);
        for (std::size_t k = 1; k < solids.size(); ++k) {
            if (operation != Operation::union_ && spans.empty()) break;
            const Spans other = solids[k].spans(x, y);
            spans = operation == Operation::union_       ? united(spans, other)
                    : operation == Operation::difference ? difference(spans, other)
                                                         : intersection(spans, other);
        }
        return spans;
    };
    return result;
}

Solid make_polygon(const Polygon& polygon) {
    std::vector<Outline2D> outlines{without_repeats(polygon.points)};
    std::vector<std::string> names{"the polygon"};
    for (std::size_t k = 0; k < polygon.holes.size(); ++k) {
        outlines.push_back(without_repeats(polygon.holes[k]));
        names.push_back(fmt::format("hole {}", k));
    }
    check_outlines(outlines, names);
    // Holes that cross nothing lie inside or outside of others as a whole; a point inside them tells where.
    for (std::size_t k = 1; k < outlines.size(); ++k) {
        const Solid hole = solid_of_outlines({outlines[k]});
        double x = 0;
        Spans inside;
        for (double share = 0.5; inside.empty() && share > 1e-3; share /= 2) {
            x = hole.lower[0] + share * (hole.upper[0] - hole.lower[0]);
            inside = hole.spans(x, 0);
        }
        if (inside.empty()) continue;
        const double y = (inside[0].from + inside[0].to) / 2;
        const auto holds = [&](std::size_t other) {
            const Spans spans = solid_of_outlines({outlines[other]}).spans(x, 0);
            return std::any_of(spans.begin(), spans.end(), [&](const Span& s) { return s.from < y && y < s.to; });
        };
        if (!holds(0))
            throw std::runtime_error(
                fmt::format("hole {} lies outside the polygon, at ({:.6g} m, {:.6g} m)", k - 1, x, y));
        for (std::size_t other = 1; other < outlines.size(); ++other)
            if (other != k && holds(other))
                throw std::runtime_error(fmt::format("hole {} lies in hole {}", k - 1, other - 1));
    }
    return solid_of_outlines(outlines);
}

Solid make_path(const Path& path, const ShapeContext& context) {
    std::vector<Outline2D> outlines = read_path_file(context.folder / path.file);
    for (Outline2D& outline : outlines)
        for (PlanePoint& point : outline) {
            const Vector x =
                turned({path.placement.scale * point[0], path.placement.scale * point[1], 0}, path.placement.angle);
            point = {x[0] + path.placement.translation[0], x[1] + path.placement.translation[1]};
        }
    try {
        check_outlines(outlines);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("path \"{}\": {}", path.file.string(), error.what()));
    }
    return solid_of_outlines(outlines);
}

Solid make_surface(const Surface& surface, Making& making) {
    RepairedMesh repaired = read_surface(surface, making.context.folder / surface.file);
    if (making.repairs)
        for (const std::string& repair : repaired.repairs)
            making.repairs->push_back(fmt::format("surface \"{}\": {}", surface.file.string(), repair));
    return solid_of(std::move(repaired.mesh));
}

Solid make(const ShapeSpec& shape, Making& making) {
    const bool space = making.context.dimension == 3;
    if (!std::holds_alternative<Combination>(shape) && !std::holds_alternative<NamedShape>(shape)) ++making.count;
    struct Visitor {
        Making& making;
        bool space;
        Solid operator()(const Box& box) const { return space ? space_solid(box) : plane_solid(box); }
        Solid operator()(const Disk& disk) const { return plane_solid(disk); }
        Solid operator()(const Ellipse& ellipse) const { return plane_solid(ellipse); }
        Solid operator()(const Ring& ring) const { return plane_solid(ring); }
        Solid operator()(const Polygon& polygon) const { return make_polygon(polygon); }
        Solid operator()(const Path& path) const { return make_path(path, making.context); }
        Solid operator()(const Ball& ball) const { return space_solid(ball); }
        Solid operator()(const Ellipsoid& ellipsoid) const { return space_solid(ellipsoid); }
        Solid operator()(const Cylinder& cylinder) const { return space_solid(cylinder); }
        Solid operator()(const Cone& cone) const { return space_solid(cone); }
        Solid operator()(const Surface& surface) const { return make_surface(surface, making); }
        Solid operator()(const Implicit& implicit) const {
            return solid_of(mesh_implicit(implicit, making.context.resolution / 500));
        }
        Solid operator()(const Combination& combination) const { return combine(combination, making); }
        Solid operator()(const NamedShape& named) const { return make_named(named.name, making); }
    };
    return std::visit(Visitor{making, space}, shape);
}

} // namespace

bool exists_in(const ShapeSpec& shape, int dimension) {
    if (std::holds_alternative<Box>(shape) || std::holds_alternative<Combination>(shape) ||
        std::holds_alternative<NamedShape>(shape))
        return true;
    const bool plane = std::holds_alternative<Disk>(shape) || std::holds_alternative<Ellipse>(shape) ||
                       std::holds_alternative<Ring>(shape) || std::holds_alternative<Polygon>(shape) ||
                       std::holds_alternative<Path>(shape);
    return plane == (dimension == 2);
}

Solid make_solid(const ShapeSpec& shape, const ShapeContext& context, std::vector<std::string>* repairs) {
    Making making{context, repairs};
    return make(shape, making);
}

} // namespace abut

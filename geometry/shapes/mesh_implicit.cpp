// Surfaces of expressions by Delaunay refinement (CGAL's Mesh_3). The triangles are those between tetrahedra inside and
// outside: closed whatever happens. Compiling this file takes a minute and 3 GB.
#include "expression/expression.h"
#include "geometry/shapes/check_surface.h"
#include "geometry/shapes/sign_raster.h"
#include "geometry/shapes/surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/refine_mesh_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace abut {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
namespace params = CGAL::parameters;

constexpr long long most_evaluations = 100'000'000;

struct TooMany {};
struct NotANumber {
    Vector where;
};

/// The expression at points of the scene. Counts.
class Field {
public:
    explicit Field(const Implicit& spec) : expression_(spec.expression, {"x", "y", "z"}), unit_(spec.unit) {
        if (expression_.used().empty())
            throw std::runtime_error(
                fmt::format("\"{}\": x, y and z don't occur, so it is the same everywhere", spec.expression));
    }
    double operator()(const Vector& x) const {
        return expression_(std::array{x[0] / unit_, x[1] / unit_, x[2] / unit_});
    }
    double counted(const Vector& x) {
        if (++evaluations_ > most_evaluations) throw TooMany();
        const double value = (*this)(x);
        if (std::isnan(value)) throw NotANumber{x};
        return value;
    }

private:
    Expression expression_;
    double unit_;
    long long evaluations_ = 0;
};

/// Looks twice: small things in large boxes escape a coarse raster.
SignRaster look(const Field& field, const Implicit& spec) {
    const auto value = [&](const Vector& x) { return field(x); };
    for (const int count : {65, 161}) {
        SignRaster raster = sample_signs(value, spec.lower, spec.upper, spec.unit, count);
        if (!raster.points.empty()) return raster;
    }
    throw std::runtime_error("is nowhere negative in its box (looked at 161³ points)");
}

TriangleMesh boundary_of(const Complex& complex) {
    TriangleMesh mesh;
    std::map<Complex::Vertex_handle, int> index;
    const auto& triangulation = complex.triangulation();
    const auto number = [&](Complex::Vertex_handle vertex) {
        const auto [entry, added] = index.try_emplace(vertex, static_cast<int>(mesh.points.size()));
        if (added) {
            const auto& p = vertex->point();
            mesh.points.push_back({p.x(), p.y(), p.z()});
        }
        return entry->second;
    };
    for (auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end(); ++cell) {
        if (!complex.is_in_complex(cell)) continue;
        for (int i = 0; i < 4; ++i) {
            if (complex.is_in_complex(cell->neighbor(i))) continue;
            // These corners run clockwise seen from outside the cell.
            std::array<int, 3> triangle{};
            for (int k = 0; k < 3; ++k)
                triangle[static_cast<std::size_t>(2 - k)] =
                    number(cell->vertex(Triangulation::vertex_triple_index(i, k)));
            mesh.triangles.push_back(triangle);
        }
    }
    return mesh;
}

double volume(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& triangle : mesh.triangles) {
        std::array<Vector, 3> x{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                x[i][axis] = mesh.points[static_cast<std::size_t>(triangle[i])][axis] - mesh.points.front()[axis];
        sum += x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) + x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2]) +
               x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
    }
    return sum / 6;
}

TriangleMesh mesh(const Implicit& spec, double distance) {
    Field field(spec);
    const SignRaster raster = look(field, spec);
    // CGAL sees a box whose longest edge is 1.
    double length = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) length = std::max(length, spec.upper[axis] - spec.lower[axis]);
    const auto scene = [&](const Kernel::Point_3& p) {
        return Vector{spec.lower[0] + length * p.x(), spec.lower[1] + length * p.y(), spec.lower[2] + length * p.z()};
    };
    const auto unit_box = [&](const Vector& x) {
        return Kernel::Point_3((x[0] - spec.lower[0]) / length, (x[1] - spec.lower[1]) / length,
                               (x[2] - spec.lower[2]) / length);
    };
    CGAL::Random random(0);
    CGAL::get_default_random() = CGAL::Random(0);
    const double relative_distance = distance / length;
    const Domain domain = Domain::create_implicit_mesh_domain(
        [&](const Kernel::Point_3& p) { return field.counted(scene(p)); },
        CGAL::Iso_cuboid_3<Kernel>(Kernel::Point_3(0, 0, 0), unit_box(spec.upper)),
        params::relative_error_bound = std::min(1e-3, relative_distance / 20), params::p_rng = &random);
    const Criteria criteria(params::facet_angle = 20, params::facet_size = 0.1,
                            params::facet_distance = relative_distance);
    Complex complex;
    const auto patch = domain.index_from_surface_patch_index(Domain::Surface_patch_index(0, 1));
    for (const Vector& x : raster.points) {
        const auto vertex = complex.triangulation().insert(Triangulation::Weighted_point(unit_box(x)));
        complex.set_dimension(vertex, 2);
        complex.set_index(vertex, patch);
    }
    CGAL::refine_mesh_3(complex, domain, criteria, params::no_exude(), params::no_perturb());
    TriangleMesh result = boundary_of(complex);
    for (Vector& x : result.points) x = scene({x[0], x[1], x[2]});
    const double enclosed = result.triangles.empty() ? 0 : volume(result);
    if (!(enclosed > 0) || std::abs(enclosed - raster.volume) > raster.doubt)
        throw std::runtime_error(
            fmt::format("was not found as a whole: its triangles enclose {:.4g} m³, but it is negative "
                        "in about {:.4g} m³ of its box. A smaller box may help",
                        enclosed, raster.volume));
    return result;
}

} // namespace

TriangleMesh mesh_implicit(const Implicit& spec, double distance) {
    silence_cgal();
    try {
        return mesh(spec, distance);
    } catch (const TooMany&) {
        throw std::runtime_error(fmt::format(
            "implicit surface: \"{}\" takes too many triangles to be followed to within {:.3g} m, as sharp edges "
            "and surfaces without an inside do: round its edges or make particles larger",
            spec.expression, distance));
    } catch (const NotANumber& found) {
        throw std::runtime_error(fmt::format(
            "implicit surface: \"{}\" is not a number at x = {:.4g}, y = {:.4g}, z = {:.4g}", spec.expression,
            found.where[0] / spec.unit, found.where[1] / spec.unit, found.where[2] / spec.unit));
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("implicit surface: {}", error.what()));
    }
}

} // namespace abut

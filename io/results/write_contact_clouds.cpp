#include "io/results/write_contact_clouds.h"

#include "io/results/csv.h"
#include "io/results/write_frame.h"
#include "io/results/write_text.h"
#include "io/scene/words.h"
#include "results/frame_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace abut {

namespace {

constexpr std::array separation_names{"separation_particle_edges", "separation_critical_position",
                                      "separation_fitted_position", "separation_displacement"};
static_assert(separation_names.size() == inspected_separations.size());

/// Columns of a frame under way, by name.
struct Columns {
    std::vector<Array> arrays;

    template <class Value>
    void add(const char* name, int components, const Value* first) {
        const auto same = std::find_if(arrays.begin(), arrays.end(), [&](const Array& a) { return a.name == name; });
        Array& array =
            same == arrays.end()
                ? arrays.emplace_back(Array{name, components, std::vector<Value>{}, std::string(unit_of_array(name))})
                : *same;
        auto& values = std::get<std::vector<Value>>(array.values);
        values.insert(values.end(), first, first + components);
    }
    void add(const char* name, double value) { add(name, 1, &value); }
    void add(const char* name, std::int32_t value) { add(name, 1, &value); }
    void add(const char* name, bool value) { add(name, static_cast<std::int32_t>(value)); }
    void add(const char* name, const Vector& value) { add(name, 3, value.data()); }
};

template <int D>
std::array<std::int32_t, 3> three(const Index<D>& node) {
    std::array<std::int32_t, 3> result{};
    std::copy(node.begin(), node.end(), result.begin());
    return result;
}

template <int D>
void add_key(Columns& columns, const NodeSeen<D>& node, std::size_t pair) {
    columns.add("node", 3, three<D>(node.node).data());
    columns.add("pair", static_cast<std::int32_t>(pair));
    columns.add("body_a", node.points[pair].body_a);
    columns.add("body_b", node.points[pair].body_b);
}

/// What both kinds of files have besides their cells.
template <int D>
CellFrame frame_of(const State<D>& state, const std::vector<NodeSeen<D>>& nodes) {
    CellFrame frame;
    frame.time = state.time;
    frame.globals.push_back(step_number(state.step));
    frame.words = {body_names(state), {"method_names", texts(normal_words)}};
    if (nodes.size() == 1) {
        const auto numbers = three<D>(nodes[0].node);
        const Vector place = to_array<D>(nodes[0].position);
        frame.globals.push_back({"node", 3, std::vector<std::int32_t>(numbers.begin(), numbers.end())});
        frame.globals.push_back({"node_position", 3, std::vector<double>(place.begin(), place.end()), "m"});
    }
    return frame;
}

template <int D>
void add_cell(CellFrame& frame, const std::vector<Vec<D>>& corners) {
    std::vector<std::int32_t>& cell = frame.cells.emplace_back();
    for (const Vec<D>& x : corners) {
        const Vector corner = to_array<D>(x);
        cell.push_back(static_cast<std::int32_t>(frame.points.size() / 3));
        frame.points.insert(frame.points.end(), corner.begin(), corner.end());
    }
}

/// The corners of a domain in VTK's order: counter-clockwise, the lower face first.
template <int D>
std::vector<Vec<D>> corners_of(const ParticleSeen<D>& particle) {
    std::vector<Vec<D>> corners;
    for (int k = 0; k < (D == 2 ? 1 : 2); ++k)
        for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            Vec<D> arm = particle.half_size;
            arm[0] *= i;
            arm[1] *= j;
            if constexpr (D == 3) arm[2] *= 2 * k - 1;
            corners.push_back(particle.position + particle.deformation_gradient * arm);
        }
    return corners;
}

template <int D>
void add_particle(Columns& columns, const ParticleSeen<D>& particle) {
    columns.add("body", particle.body);
    columns.add("id", particle.id);
    columns.add("distance", particle.distance);
    columns.add("edge_distance", particle.edge_distance);
    columns.add("support", particle.support);
    Mat<3> F = Mat<3>::Identity();
    F.topLeftCorner<D, D>() = particle.deformation_gradient;
    const Mat<3> by_rows = F.transpose();
    columns.add("deformation_gradient", 9, by_rows.data());
    columns.add("half_size", to_array<D>(particle.half_size));
    columns.add("centre", to_array<D>(particle.position));
}

template <int D>
void add_plane(Columns& columns, const PointSeen<D>& point, const PlaneSeen<D>& plane) {
    columns.add("normal", to_array<D>(plane.normal));
    columns.add("fitted_normal", to_array<D>(plane.fitted));
    for (std::size_t s = 0; s < separation_names.size(); ++s) columns.add(separation_names[s], plane.separation[s]);
    columns.add("end_a", plane.end_a);
    columns.add("end_b", plane.end_b);
    columns.add("iterations", plane.iterations);
    columns.add("angle", plane.angle);
    columns.add("method", static_cast<std::int32_t>(plane.method));
    columns.add("chosen", plane.chosen);
    columns.add("lumped", point.lumped);
}

/// A frame without cells has all its arrays too, empty.
template <int D>
void add_empty(Columns& columns, void (*add)(Columns&)) {
    if (!columns.arrays.empty()) return;
    NodeSeen<D> node;
    node.node.fill(0);
    node.points.resize(1);
    add_key(columns, node, 0);
    add(columns);
    for (Array& array : columns.arrays) std::visit([](auto& values) { values.clear(); }, array.values);
}

/// The plane's corners: a segment or a square about the node's place on it that the cloud's domains just fit in.
template <int D>
std::vector<Vec<D>> plane_corners(const Vec<D>& node, const std::vector<ParticleSeen<D>>& cloud,
                                  const PlaneSeen<D>& plane) {
    const Vec<D> middle = node + plane.place() * plane.normal;
    double half = 0;
    for (const ParticleSeen<D>& particle : cloud)
        for (const Vec<D>& corner : corners_of(particle)) {
            const Vec<D> x = corner - middle;
            half = std::max(half, (x - x.dot(plane.normal) * plane.normal).norm());
        }
    if constexpr (D == 2) {
        const Vec<2> along = half * Vec<2>(-plane.normal[1], plane.normal[0]);
        return {middle - along, middle + along};
    } else {
        Vec<3> u = Vec<3>::Zero();
        int axis = 0;
        plane.normal.cwiseAbs().minCoeff(&axis);
        u[axis] = 1;
        u = half * (u - u.dot(plane.normal) * plane.normal).normalized();
        const Vec<3> v = plane.normal.cross(u);
        return {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
    }
}

} // namespace

template <int D>
CellFrame cloud_frame(const State<D>& state, const std::vector<NodeSeen<D>>& nodes) {
    CellFrame frame = frame_of(state, nodes);
    Columns columns;
    for (const NodeSeen<D>& node : nodes)
        for (std::size_t pair = 0; pair < node.points.size(); ++pair)
            for (const ParticleSeen<D>& particle : node.points[pair].cloud) {
                add_cell<D>(frame, corners_of(particle));
                add_key(columns, node, pair);
                add_particle(columns, particle);
            }
    add_empty<D>(columns, [](Columns& c) { add_particle<D>(c, {}); });
    frame.arrays = std::move(columns.arrays);
    return frame;
}

template <int D>
CellFrame plane_frame(const State<D>& state, const std::vector<NodeSeen<D>>& nodes) {
    CellFrame frame = frame_of(state, nodes);
    Columns columns;
    for (const NodeSeen<D>& node : nodes)
        for (std::size_t pair = 0; pair < node.points.size(); ++pair)
            for (const PlaneSeen<D>& plane : node.points[pair].planes) {
                if (!std::isfinite(plane.place())) continue;
                add_cell<D>(frame, plane_corners<D>(node.position, node.points[pair].cloud, plane));
                add_key(columns, node, pair);
                add_plane(columns, node.points[pair], plane);
            }
    add_empty<D>(columns, [](Columns& c) { add_plane<D>(c, {}, {}); });
    frame.arrays = std::move(columns.arrays);
    return frame;
}

template <int D>
std::string node_table(const State<D>& state, const std::vector<NodeSeen<D>>& nodes) {
    constexpr std::string_view axes = D == 2 ? "ij" : "ijk";
    constexpr std::string_view components = D == 2 ? "xy" : "xyz";
    std::string text;
    const auto out = std::back_inserter(text);
    for (const char axis : axes) fmt::format_to(out, "node_{},", axis);
    text += "body_a,body_b,lumped,cloud_size,method,chosen";
    for (const char* normal : {"normal", "fitted_normal"})
        for (const char component : components) fmt::format_to(out, ",{}_{}", normal, component);
    text += ",angle,iterations,end_a,end_b";
    for (const char* name : separation_names) fmt::format_to(out, ",{}", name);
    text += '\n';
    for (const NodeSeen<D>& node : nodes)
        for (const PointSeen<D>& point : node.points)
            for (const PlaneSeen<D>& plane : point.planes) {
                for (const int i : node.node) fmt::format_to(out, "{},", i);
                fmt::format_to(out, "{},{},{:d},{},{},{:d}", csv_cell(state.bodies[point.body_a].name),
                               csv_cell(state.bodies[point.body_b].name), point.lumped, point.cloud.size(),
                               text_of(normal_words, plane.method), plane.chosen);
                for (const Vec<D>& normal : {plane.normal, plane.fitted})
                    for (int a = 0; a < D; ++a) fmt::format_to(out, ",{}", normal[a]);
                fmt::format_to(out, ",{},{},{},{}", plane.angle, plane.iterations, plane.end_a, plane.end_b);
                for (const double separation : plane.separation) fmt::format_to(out, ",{}", separation);
                text += '\n';
            }
    return text;
}

template <int D>
std::string node_file_suffix(int frame, const Index<D>& node) {
    std::string suffix = fmt::format("{:05}", frame);
    for (const int i : node) suffix += fmt::format("_{}", i);
    return suffix;
}

void make_node_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && !std::filesystem::is_directory(folder)) error = std::make_error_code(std::errc::not_a_directory);
    if (error) throw std::runtime_error(fmt::format("{}: {}", folder.string(), error.message()));
}

template <int D>
std::vector<std::filesystem::path> write_node_files(const State<D>& state, const std::vector<NodeSeen<D>>& nodes,
                                                    const std::filesystem::path& folder, const std::string& suffix) {
    make_node_folder(folder);
    const std::filesystem::path cloud = folder / ("cloud_" + suffix + ".vtu");
    const std::filesystem::path plane = folder / ("plane_" + suffix + ".vtp");
    const std::filesystem::path table = folder / ("node_" + suffix + ".csv");
    write_cells(cloud, cloud_frame(state, nodes));
    write_cells(plane, plane_frame(state, nodes));
    write_text_atomically(table, node_table(state, nodes));
    return {cloud, plane, table};
}

template CellFrame cloud_frame<2>(const State<2>&, const std::vector<NodeSeen<2>>&);
template CellFrame cloud_frame<3>(const State<3>&, const std::vector<NodeSeen<3>>&);
template CellFrame plane_frame<2>(const State<2>&, const std::vector<NodeSeen<2>>&);
template CellFrame plane_frame<3>(const State<3>&, const std::vector<NodeSeen<3>>&);
template std::string node_table<2>(const State<2>&, const std::vector<NodeSeen<2>>&);
template std::string node_table<3>(const State<3>&, const std::vector<NodeSeen<3>>&);
template std::string node_file_suffix<2>(int, const Index<2>&);
template std::string node_file_suffix<3>(int, const Index<3>&);
template std::vector<std::filesystem::path> write_node_files<2>(const State<2>&, const std::vector<NodeSeen<2>>&,
                                                                const std::filesystem::path&, const std::string&);
template std::vector<std::filesystem::path> write_node_files<3>(const State<3>&, const std::vector<NodeSeen<3>>&,
                                                                const std::filesystem::path&, const std::string&);

} // namespace abut

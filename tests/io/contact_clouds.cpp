/// Files of contact nodes taken apart, read back with VTK; states from frames.

#include "io/results/pvd.h"
#include "io/results/read_frame.h"
#include "io/results/read_state.h"
#include "io/results/write_contact_clouds.h"
#include "io/results/write_frame.h"
#include "io/scene/words.h"
#include "results/frames.h"
#include "results_support.h"
#include "step/step.h"

#include <Eigen/LU>
#include <cmath>
#include <gmock/gmock.h>
#include <sstream>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace abut::test {
namespace {

using testing::HasSubstr;

constexpr const char* array_of_separation[] = {"separation_particle_edges", "separation_critical_position",
                                               "separation_fitted_position", "separation_displacement"};

struct Choice {
    Analysis analysis = Analysis::plane_strain;
    bool rigid = false;
    NormalMethod normal = NormalMethod::logistic_regression;
    SeparationMethod separation = SeparationMethod::particle_edges;
};

BodySpec body_spec(const std::string& name, bool rigid) {
    BodySpec body;
    body.name = name;
    if (rigid) {
        body.rigid = RigidSpec{};
        body.rigid->velocity[1] = -0.2;
        body.rigid->angular_velocity = 0.1;
        if (rigid) body.rigid->axis = {0, 0, 1};
    } else {
        body.material = "solid";
    }
    return body;
}

/// Three bodies that press on one another, after some steps, `look`ed at.
template <int D>
State<D> pressed(const Choice& choice = {}) {
    Scene scene;
    scene.analysis = D == 3 ? Analysis::three_d : choice.analysis;
    scene.grid = {{1, 1, D == 3 ? 1.0 : 0.0}, {0, 0, 0}, {8, 8, D == 3 ? 6.0 : 0.0}};
    scene.time.end = 100;
    scene.method.shape = ShapeKind::cpdi;
    MaterialSpec material;
    material.name = "solid";
    material.density = 2;
    material.bulk_modulus = 10;
    material.shear_modulus = 4;
    scene.materials = {material};
    scene.contact.emplace();
    scene.contact->normal = choice.normal;
    scene.contact->separation = choice.separation;
    scene.contact->law = {LawType::friction, 0.3};
    scene.bodies = {body_spec("left", false), body_spec("right, \"b\"", false), body_spec("upper", choice.rigid)};
    Model model;
    for (const BodySpec& body : scene.bodies) model.bodies.push_back({body.name, body.rigid ? -1 : 0, {}, body.rigid});
    model.bodies[0].velocity.value = {0.4, 0.1, 0};
    model.bodies[1].velocity.value = {-0.4, 0, 0};
    model.bodies[2].velocity.value = {0, -0.4, 0};
    const auto box = [&](int body, Vector lower, int nx, int ny, int nz) {
        for (int k = 0; k < (D == 3 ? nz : 1); ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) {
                    model.position.push_back(
                        {lower[0] + 0.5 * i + 0.25, lower[1] + 0.5 * j + 0.25, D == 3 ? lower[2] + 0.5 * k + 0.25 : 0});
                    model.half_size.push_back({0.25, 0.25, D == 3 ? 0.25 : 0});
                    model.body.push_back(body);
                }
    };
    box(0, {2.1, 2, 2}, 4, 4, 3);
    box(1, {4.15, 2.1, 2}, 4, 4, 3);
    box(2, {3, 4.15, 2}, 4, 4, 3);
    State<D> state = make_state<D>(scene, model);
    auto tasks = step_tasks<D>(scene);
    for (int step = 0; step < 12; ++step) {
        state.dt = next_step(state, 100);
        advance(state, tasks);
    }
    look(state);
    return state;
}

template <int D>
std::vector<Index<D>> all_nodes(const State<D>& state) {
    std::vector<Index<D>> nodes;
    for (const ContactGroup<D>& group : state.contact.groups) {
        nodes.push_back(group.node);
        for (int& i : nodes.back()) i -= grid_margin;
    }
    return nodes;
}

template <class Reader>
auto read(const std::filesystem::path& path) {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0u) << path;
    return vtkSmartPointer<std::remove_pointer_t<decltype(reader->GetOutput())>>(reader->GetOutput());
}

/// The same bits, NaN included.
void expect_same(double a, double b) {
    if (std::isnan(b))
        EXPECT_TRUE(std::isnan(a));
    else
        EXPECT_EQ(a, b);
}

template <int D>
void expect_vector(vtkDataSet& data, const char* name, vtkIdType cell, const Vec<D>& expected) {
    vtkDataArray* array = data.GetCellData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    ASSERT_EQ(array->GetNumberOfComponents(), 3) << name;
    for (int a = 0; a < 3; ++a) expect_same(array->GetComponent(cell, a), a < D ? expected[a] : 0.0);
}
void expect_number(vtkDataSet& data, const char* name, vtkIdType cell, double expected) {
    vtkDataArray* array = data.GetCellData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    ASSERT_EQ(array->GetNumberOfComponents(), 1) << name;
    expect_same(array->GetComponent(cell, 0), expected);
}

template <int D>
void expect_key(vtkDataSet& data, vtkIdType cell, const NodeSeen<D>& node, std::size_t pair) {
    for (int a = 0; a < 3; ++a)
        EXPECT_EQ(data.GetCellData()->GetArray("node")->GetComponent(cell, a),
                  a < D ? node.node[static_cast<std::size_t>(a)] : 0);
    expect_number(data, "pair", cell, static_cast<double>(pair));
    expect_number(data, "body_a", cell, node.points[pair].body_a);
    expect_number(data, "body_b", cell, node.points[pair].body_b);
}

void expect_field_data(vtkDataSet& data, double time) {
    EXPECT_EQ(data.GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), time);
    auto* bodies = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("body_names"));
    ASSERT_NE(bodies, nullptr);
    ASSERT_EQ(bodies->GetNumberOfValues(), 3);
    EXPECT_EQ(bodies->GetValue(1), "right, \"b\"");
    EXPECT_EQ(data.GetFieldData()->GetArray("step")->GetComponent(0, 0), 12);
    auto* methods = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("method_names"));
    ASSERT_NE(methods, nullptr);
    ASSERT_EQ(methods->GetNumberOfValues(), 8);
    for (const auto& word : normal_words) EXPECT_EQ(methods->GetValue(static_cast<int>(word.value)), word.text);
}

/// Corners of a domain by VTK's definition of the cell: x + F (±half sizes), in its parametric coordinates.
template <int D>
void expect_domain(vtkCell& cell, const ParticleSeen<D>& particle) {
    const double* parameters = cell.GetParametricCoords();
    for (int corner = 0; corner < cell.GetNumberOfPoints(); ++corner) {
        Vec<D> arm;
        for (int a = 0; a < D; ++a) arm[a] = (2 * parameters[3 * corner + a] - 1) * particle.half_size[a];
        const Vec<D> x = particle.position + particle.deformation_gradient * arm;
        double found[3];
        cell.GetPoints()->GetPoint(corner, found);
        for (int a = 0; a < 3; ++a) EXPECT_EQ(found[a], a < D ? x[a] : 0);
    }
}

template <int D>
void check_files() {
    const TemporaryFolder folder;
    State<D> state = pressed<D>();
    const std::vector<NodeSeen<D>> nodes = inspect_contact<D>(state, all_nodes(state));
    const auto files = write_node_files<D>(state, nodes, folder / "new/clouds", "00007");
    EXPECT_THAT(files,
                testing::ElementsAre(folder / "new/clouds/cloud_00007.vtu", folder / "new/clouds/plane_00007.vtp",
                                     folder / "new/clouds/node_00007.csv"));

    const auto cloud = read<vtkXMLUnstructuredGridReader>(files[0]);
    const auto planes = read<vtkXMLPolyDataReader>(files[1]);
    expect_field_data(*cloud, state.time);
    expect_field_data(*planes, state.time);
    vtkIdType c = 0;
    vtkIdType q = 0;
    std::size_t supports = 0, three = 0;
    for (const NodeSeen<D>& node : nodes)
        for (std::size_t pair = 0; pair < node.points.size(); ++pair) {
            const PointSeen<D>& point = node.points[pair];
            three += pair == 2;
            for (const ParticleSeen<D>& particle : point.cloud) {
                ASSERT_LT(c, cloud->GetNumberOfCells());
                EXPECT_EQ(cloud->GetCellType(c), D == 2 ? VTK_QUAD : VTK_HEXAHEDRON);
                expect_domain<D>(*cloud->GetCell(c), particle);
                expect_key(*cloud, c, node, pair);
                expect_number(*cloud, "body", c, particle.body);
                expect_number(*cloud, "id", c, particle.id);
                expect_number(*cloud, "distance", c, particle.distance);
                expect_number(*cloud, "edge_distance", c, particle.edge_distance);
                expect_number(*cloud, "support", c, particle.support);
                expect_vector<D>(*cloud, "half_size", c, particle.half_size);
                expect_vector<D>(*cloud, "centre", c, particle.position);
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j)
                        EXPECT_EQ(cloud->GetCellData()->GetArray("deformation_gradient")->GetComponent(c, 3 * i + j),
                                  i < D && j < D ? particle.deformation_gradient(i, j) : i == j);
                supports += particle.support;
                ++c;
            }
            for (const PlaneSeen<D>& plane : point.planes) {
                if (plane.normal.isZero(0)) continue;
                ASSERT_LT(q, planes->GetNumberOfCells());
                vtkCell* cell = planes->GetCell(q);
                EXPECT_EQ(cell->GetCellType(), D == 2 ? VTK_LINE : VTK_QUAD);
                // Every corner lies in the plane, and their middle is the node's place on it.
                Vec<D> middle = Vec<D>::Zero();
                for (int corner = 0; corner < cell->GetNumberOfPoints(); ++corner) {
                    Vec<D> x;
                    for (int a = 0; a < D; ++a) x[a] = cell->GetPoints()->GetPoint(corner)[a];
                    EXPECT_NEAR((x - node.position).dot(plane.normal), (plane.end_a + plane.end_b) / 2, 1e-12);
                    middle += x / static_cast<double>(cell->GetNumberOfPoints());
                }
                EXPECT_NEAR((middle - node.position - plane.place() * plane.normal).norm(), 0, 1e-12);
                EXPECT_GT(cell->GetLength2(), 1) << "as wide as the cloud";
                expect_key(*planes, q, node, pair);
                expect_vector<D>(*planes, "normal", q, plane.normal);
                expect_vector<D>(*planes, "fitted_normal", q, plane.fitted);
                for (std::size_t s = 0; s < 4; ++s)
                    expect_number(*planes, array_of_separation[s], q, plane.separation[s]);
                expect_number(*planes, "end_a", q, plane.end_a);
                expect_number(*planes, "end_b", q, plane.end_b);
                expect_number(*planes, "iterations", q, plane.iterations);
                expect_number(*planes, "angle", q, plane.angle);
                expect_number(*planes, "method", q, static_cast<int>(plane.method));
                expect_number(*planes, "chosen", q, plane.method == NormalMethod::logistic_regression);
                expect_number(*planes, "lumped", q, point.lumped);
                ++q;
            }
        }
    EXPECT_EQ(c, cloud->GetNumberOfCells());
    EXPECT_EQ(q, planes->GetNumberOfCells());
    EXPECT_GT(supports, 10U);
    EXPECT_GT(three, 0U) << "a node of three pairs";
}

TEST(ContactClouds, AreReadBackAsWritten) {
    check_files<2>();
}
TEST(ContactClouds, AreReadBackAsWrittenInSpace) {
    check_files<3>();
}

TEST(ContactClouds, TableHasARowForEachMethod) {
    State<2> state = pressed<2>();
    const std::vector<NodeSeen<2>> nodes = inspect_contact<2>(state, {all_nodes(state).at(2)});
    std::istringstream table(node_table(state, nodes));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "node_i,node_j,body_a,body_b,lumped,cloud_size,method,chosen,normal_x,normal_y,fitted_normal_x,"
                    "fitted_normal_y,angle,iterations,end_a,end_b,separation_particle_edges,"
                    "separation_critical_position,separation_fitted_position,separation_displacement");
    std::size_t rows = 0;
    while (std::getline(table, line)) {
        const PlaneSeen<2>& plane = nodes[0].points.at(rows / 7).planes.at(rows % 7);
        EXPECT_THAT(line, HasSubstr(std::string(text_of(normal_words, plane.method)) + (plane.chosen ? ",1," : ",0,")));
        std::vector<double> last;
        for (std::size_t at = line.size(), k = 0; k < 4; ++k) {
            at = line.rfind(',', at - 1);
            last.insert(last.begin(), std::strtod(line.c_str() + at + 1, nullptr));
        }
        for (std::size_t s = 0; s < 4; ++s) expect_same(last[s], plane.separation[s]);
        ++rows;
    }
    EXPECT_EQ(rows, 7 * nodes[0].points.size());
}

TEST(ContactClouds, NamesWithCommasAreQuotedInTheTable) {
    State<2> state = pressed<2>();
    EXPECT_THAT(node_table(state, inspect_contact<2>(state, all_nodes(state))), HasSubstr(",\"right, \"\"b\"\"\","));
}

TEST(ContactClouds, NodeWithoutContactHasEmptyFilesWithAllArrays) {
    const TemporaryFolder folder;
    State<2> state = pressed<2>();
    const auto files = write_node_files<2>(state, inspect_contact<2>(state, {{0, 0}}), folder.path, "00000_0_0");
    const auto full = write_node_files<2>(state, inspect_contact<2>(state, all_nodes(state)), folder.path, "00000");
    const auto compare = [](vtkDataSet& empty, vtkDataSet& with_cells) {
        EXPECT_EQ(empty.GetNumberOfCells(), 0);
        ASSERT_EQ(empty.GetCellData()->GetNumberOfArrays(), with_cells.GetCellData()->GetNumberOfArrays());
        for (int i = 0; i < empty.GetCellData()->GetNumberOfArrays(); ++i)
            EXPECT_STREQ(empty.GetCellData()->GetArrayName(i), with_cells.GetCellData()->GetArrayName(i));
        EXPECT_EQ(empty.GetFieldData()->GetArray("node_position")->GetComponent(0, 1), 0);
        EXPECT_EQ(with_cells.GetFieldData()->GetArray("node"), nullptr) << "for one node only";
    };
    compare(*read<vtkXMLUnstructuredGridReader>(files[0]), *read<vtkXMLUnstructuredGridReader>(full[0]));
    compare(*read<vtkXMLPolyDataReader>(files[1]), *read<vtkXMLPolyDataReader>(full[1]));
}

TEST(ContactClouds, FullDiskLeavesNothingHalfWritten) {
    const TemporaryFolder folder;
    State<2> state = pressed<2>();
    const std::vector<NodeSeen<2>> nodes = inspect_contact<2>(state, all_nodes(state));
    const DiskLimit limit(1000);
    EXPECT_THAT(error_of([&] { write_node_files<2>(state, nodes, folder.path, "00000"); }),
                HasSubstr("cloud_00000.vtu: cannot write"));
    EXPECT_EQ(folder.count(), 0U);
}

TEST(ContactClouds, SeriesOfARunListWhatWasWritten) {
    const TemporaryFolder folder;
    State<2> state = pressed<2>();
    const std::vector<Index<2>> nodes = all_nodes(state);
    ContactCloudsSpec& spec = state.scene.output.contact_clouds.emplace();
    spec.nodes = {{nodes[3][0], nodes[3][1], -1}, {0, 0, -1}};
    spec.near = {{2.9, 4.4, 0}, {7, 7, 0}};
    spec.disagreement = 0.02;
    const auto first_near = *nearest_contact_node<2>(state, {2.9, 4.4});
    const double first_time = state.time;
    write_contact_clouds(state, folder.path, 4);
    auto tasks = step_tasks<2>(state.scene);
    for (int step = 0; step < 3; ++step) {
        state.dt = next_step(state, 100);
        advance(state, tasks);
    }
    look(state);
    write_contact_clouds(state, folder.path, 5);
    write_contact_clouds(state, folder.path, 5); // a resumed run comes by again
    const auto suffix = [](const Index<2>& node) { return node_file_suffix<2>(4, node); };
    EXPECT_EQ(suffix({-1, 12}), "00004_-1_12");
    const auto check = [&](const std::string& name, const std::string& first) {
        const PvdSeries series = read_pvd(folder / ("clouds/" + name + ".pvd"));
        ASSERT_EQ(series.entries.size(), 2U) << name;
        EXPECT_EQ(series.entries[0].time, first_time);
        EXPECT_EQ(series.entries[1].time, state.time);
        EXPECT_EQ(series.entries[0].file, first);
        for (const PvdEntry& entry : series.entries)
            EXPECT_TRUE(std::filesystem::is_regular_file(folder / ("clouds/" + entry.file))) << entry.file;
    };
    check("cloud_" + suffix(nodes[3]).substr(6), "cloud_" + suffix(nodes[3]) + ".vtu");
    check("plane_0_0", "plane_00004_0_0.vtp");
    check("cloud_near_0", "cloud_" + suffix(first_near) + ".vtu");
    check("plane_near_1", "plane_" + suffix(*nearest_contact_node<2>(state, {7, 7})) + ".vtp");
    check("cloud_disagreement", "cloud_00004.vtu");
    check("plane_disagreement", "plane_00004.vtp");
    const auto all = read<vtkXMLPolyDataReader>(folder / "clouds/plane_00005.vtp");
    std::set<std::array<double, 2>> written;
    vtkDataArray* node = all->GetCellData()->GetArray("node");
    for (vtkIdType i = 0; i < all->GetNumberOfCells(); ++i)
        written.insert({node->GetComponent(i, 0), node->GetComponent(i, 1)});
    std::set<std::array<double, 2>> expected;
    for (const Disagreement<2>& one : nodes_in_disagreement(state, 0.02))
        expected.insert({double(one.node[0]), double(one.node[1])});
    EXPECT_EQ(written, expected);
    EXPECT_FALSE(written.empty());
}

// === States from frames

template <int D>
void check_state_from_frame(const Choice& choice) {
    const TemporaryFolder folder;
    State<D> state = pressed<D>(choice);
    write_particles(folder / "p.vtu", particle_frame(state));
    State<D> again = read_state<D>(state.scene, read_points(folder / "p.vtu", arrays_of_state()));
    look(again);
    EXPECT_EQ(again.time, state.time);
    EXPECT_EQ(again.step, 12);
    const PointFrame expected = contact_frame(state);
    const PointFrame found = contact_frame(again);
    ASSERT_FALSE(expected.points.empty());
    EXPECT_EQ(found.points, expected.points);
    for (std::size_t i = 0; i < expected.arrays.size(); ++i) {
        const std::string& name = expected.arrays[i].name;
        if (name == "force" || name == "in_contact") continue; // of the last step
        if (const auto* reals = std::get_if<std::vector<double>>(&expected.arrays[i].values)) {
            const auto& others = std::get<std::vector<double>>(found.arrays[i].values);
            ASSERT_EQ(others.size(), reals->size());
            for (std::size_t k = 0; k < reals->size(); ++k)
                if (std::isfinite((*reals)[k]))
                    EXPECT_NEAR(others[k], (*reals)[k], 1e-12) << name;
                else
                    EXPECT_EQ(others[k], (*reals)[k]) << name;
        } else {
            EXPECT_EQ(found.arrays[i].values, expected.arrays[i].values) << name;
        }
    }
    for (std::size_t p = 0; p < state.particles.size(); ++p) { // masses are what extrapolated positions hang on
        const auto id = static_cast<std::size_t>(state.particles.id[p]);
        const auto q = std::find(again.particles.id.begin(), again.particles.id.end(), id) - again.particles.id.begin();
        EXPECT_NEAR(again.particles.mass[q], state.particles.mass[p], 1e-14 * state.particles.mass[p]);
        EXPECT_NEAR(again.particles.volume[q], state.particles.volume[p], 1e-14 * state.particles.volume[p]);
    }
}

TEST(ReadState, FindsTheContactsOfTheRun) {
    for (const NormalMethod normal :
         {NormalMethod::logistic_regression, NormalMethod::average_gradient, NormalMethod::own_gradient})
        for (const SeparationMethod separation : {SeparationMethod::particle_edges, SeparationMethod::fitted_position,
                                                  SeparationMethod::displacement, SeparationMethod::none})
            check_state_from_frame<2>({Analysis::plane_strain, false, normal, separation});
}
TEST(ReadState, FindsThemInEveryAnalysis) {
    for (const Analysis analysis : {Analysis::plane_stress, Analysis::axisymmetric})
        check_state_from_frame<2>({analysis, false, NormalMethod::average_gradient, SeparationMethod::fitted_position});
    check_state_from_frame<3>({});
}
TEST(ReadState, FindsThemAtRigidBodies) {
    check_state_from_frame<2>(
        {Analysis::plane_strain, true, NormalMethod::average_gradient, SeparationMethod::fitted_position});
    check_state_from_frame<3>({Analysis::three_d, true});
}

TEST(ReadState, KnowsBodiesOfImagesByTheirGroups) {
    State<2> state = pressed<2>();
    const PointFrame frame = [&] {
        PointFrame f = particle_frame(state);
        f.words[0].values = {"grain-001", "grain-big-002", "upper"};
        return f;
    }();
    Scene scene = state.scene;
    scene.bodies = {body_spec("upper", false)};
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].name = "hard";
    scene.materials[1].density = 7;
    ImageSpec image;
    image.bodies = BodiesBy::component;
    for (const char* name : {"grain", "grain-big"}) {
        LegendEntry entry;
        entry.body = name;
        entry.material = image.legend.empty() ? "solid" : "hard";
        image.legend.push_back(entry);
    }
    scene.images = {image};
    const State<2> read = read_state<2>(scene, frame);
    EXPECT_EQ(read.bodies[0].group, "grain");
    EXPECT_EQ(read.bodies[1].group, "grain-big");
    EXPECT_EQ(read.bodies[1].material, 1);
    EXPECT_EQ(read.bodies[2].group, "");
    EXPECT_EQ(read.bodies[2].material, 0);
}

TEST(ReadState, SaysWhatIsMissing) {
    State<2> state = pressed<2>();
    const PointFrame good = particle_frame(state);
    const auto error = [&](const Scene& scene, const PointFrame& frame) {
        return error_of([&] { read_state<2>(scene, frame); });
    };
    for (const std::string& name : arrays_of_state()) {
        PointFrame frame = good;
        std::erase_if(frame.arrays, [&](const Array& array) { return array.name == name; });
        EXPECT_THAT(error(state.scene, frame), HasSubstr("no array \"" + name + "\""));
    }
    Scene some = state.scene;
    some.output.bodies = {"left"};
    EXPECT_THAT(error(some, good), HasSubstr("only the particles of some bodies were written"));
    PointFrame cut = good;
    for (Array& array : cut.arrays)
        std::visit([&](auto& values) { values.erase(values.begin(), values.begin() + array.components); },
                   array.values);
    cut.points.erase(cut.points.begin(), cut.points.begin() + 3);
    EXPECT_THAT(error(state.scene, cut), HasSubstr("doesn't hold all particles"));
    PointFrame unnamed = good;
    unnamed.words.clear();
    EXPECT_THAT(error(state.scene, unnamed), HasSubstr("body_names"));
    PointFrame other = good;
    other.words[0].values[0] = "elsewhere";
    EXPECT_THAT(error(state.scene, other), HasSubstr("a body \"elsewhere\" that the scene doesn't have"));
}

} // namespace
} // namespace abut::test

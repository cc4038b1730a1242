/// Files of contact nodes taken apart, read back with VTK.

#include "contact_clouds_support.h"
#include "io/results/write_contact_clouds.h"
#include "io/scene/words.h"
#include "results/arrays.h"

#include <gmock/gmock.h>
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

/// The reference page and the files are of one table.
TEST(ContactClouds, HaveTheArraysOfTheReferencePage) {
    State<2> state = pressed<2>();
    const std::vector<NodeSeen<2>> nodes = inspect_contact<2>(state, all_nodes(state));
    const auto expect = [](const std::vector<Array>& arrays, std::span<const ArrayInfo> table) {
        ASSERT_EQ(arrays.size(), table.size());
        for (std::size_t i = 0; i < table.size(); ++i) {
            EXPECT_EQ(arrays[i].name, table[i].name);
            EXPECT_EQ(arrays[i].components, table[i].components) << table[i].name;
            EXPECT_EQ(arrays[i].unit, table[i].unit) << table[i].name;
            EXPECT_NE(table[i].meaning, "") << table[i].name;
        }
    };
    expect(cloud_frame(state, nodes).arrays, cloud_arrays());
    expect(plane_frame(state, nodes).arrays, plane_arrays());
    for (const auto& [name, unit] : {std::pair{"angle", "rad"},
                                     {"end_a", "m"},
                                     {"separation_displacement", "m"},
                                     {"centre", "m"},
                                     {"edge_distance", "m"},
                                     {"lumped", ""}})
        EXPECT_EQ(unit_of_array(name), unit) << name;
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

} // namespace
} // namespace abut::test

/// The table of contact nodes taken apart, and the series of a run.

#include "contact_clouds_support.h"
#include "io/results/pvd.h"
#include "io/results/write_contact_clouds.h"
#include "io/results/write_text.h"
#include "io/scene/words.h"

#include <gmock/gmock.h>
#include <set>
#include <sstream>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

namespace abut::test {
namespace {

using testing::HasSubstr;

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
    CloudSeries of_first_run, of_resumed_run;
    write_contact_clouds(state, folder.path, 4, of_first_run);
    auto tasks = step_tasks<2>(state.scene);
    for (int step = 0; step < 3; ++step) {
        state.dt = next_step(state, 100);
        advance(state, tasks);
    }
    look(state);
    write_contact_clouds(state, folder.path, 5, of_first_run);
    write_contact_clouds(state, folder.path, 5, of_resumed_run); // comes by again
    // A run under way knows its series, and doesn't read them again.
    write_text_atomically(folder / "clouds/cloud_disagreement.pvd", "broken");
    write_contact_clouds(state, folder.path, 5, of_resumed_run);
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

} // namespace
} // namespace abut::test

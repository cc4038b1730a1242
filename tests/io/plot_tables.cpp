// Tables written by hand: which bodies and columns are drawn, and what is said where there is nothing to draw.
#include "io/render/plot_results.h"
#include "io/render/render_series.h"
#include "results_support.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

void write(const TemporaryFolder& folder, const std::string& file, const std::string& text) {
    std::ofstream(folder / file, std::ios::binary) << text;
}

PlotOutcome plot(const TemporaryFolder& folder, PlotOptions options) {
    options.width = 300;
    options.height = 200;
    return plot_results(folder.path, options);
}

std::vector<std::string> names(const PlotOutcome& outcome) {
    std::vector<std::string> result;
    for (const auto& file : outcome.files) result.push_back(file.filename().string());
    return result;
}

TEST(PlotTables, OneWithoutRowsIsSaidToHaveNone) {
    const TemporaryFolder folder;
    write(folder, "history.csv", "step,time,total_energy,kinetic_energy,mean_stress_xx,force_floor_x\n");
    write(folder, "bodies.csv", "step,time,body,x,y,vx,vy\n");
    write(folder, "pairs.csv", "step,time,body_a,body_b,force_x,force_y,force_z,area\n");
    const auto expect = [&](const PlotOptions& options, const std::string& file) {
        const PlotOutcome outcome = plot(folder, options);
        EXPECT_TRUE(outcome.files.empty());
        EXPECT_THAT(outcome.notes, ElementsAre(EndsWith(file + ": the table has no rows yet")));
    };
    PlotOptions options;
    expect(options, "history.csv");
    options.columns = {"kinetic_energy"};
    expect(options, "history.csv");
    options = {};
    options.bodies = {"all"};
    expect(options, "bodies.csv");
    options.pairs = true;
    expect(options, "pairs.csv");
    options.bodies = {};
    expect(options, "pairs.csv");
    EXPECT_EQ(folder.count(), 3U);
}

TEST(PlotTables, ColumnsOfSpaceAreDrawnWhereTheyShowAnything) {
    const TemporaryFolder folder;
    PlotOptions options;
    options.bodies = {"all"};
    write(folder, "bodies.csv", "step,time,body,x,y,z,vx,vy,vz\n0,0,ball,1,2,3,4,5,0\n1,1,ball,1,2,3,4,5,6\n");
    EXPECT_THAT(names(plot(folder, options)), ElementsAre("bodies-x.png", "bodies-y.png", "bodies-z.png",
                                                          "bodies-vx.png", "bodies-vy.png", "bodies-vz.png"));
    write(folder, "bodies.csv", "step,time,body,x,y,z,vx,vy,vz\n0,0,ball,1,2,0,4,5,0\n");
    const PlotOutcome plane = plot(folder, options);
    EXPECT_THAT(names(plane), ElementsAre("bodies-x.png", "bodies-y.png", "bodies-vx.png", "bodies-vy.png"));
    EXPECT_TRUE(plane.notes.empty());
}

TEST(PlotTables, AGroupStandsForItsBodies) {
    const TemporaryFolder folder;
    write(folder, "bodies.csv", "step,time,body,x\n0,0,grain-1,1\n0,0,grain-2,1\n0,0,grain-x,1\n0,0,floor,1\n");
    write(folder, "pairs.csv", "step,time,body_a,body_b,area\n0,0,grain-1,floor,1\n0,0,grain-x,floor,1\n");
    PlotOptions options;
    // What is drawn: the same as with the names of all its bodies, and not the same as with others.
    const auto picture = [&](const std::vector<std::string>& bodies) {
        options.bodies = bodies;
        return read_text(plot(folder, options).files.at(0));
    };
    EXPECT_TRUE(picture({"grain"}) == picture({"grain-1", "grain-2"}));
    EXPECT_TRUE(picture({"grain", "grain-2"}) == picture({"grain-1", "grain-2"}));
    EXPECT_FALSE(picture({"grain"}) == picture({"grain-1", "grain-2", "grain-x"}));
    options.pairs = true;
    EXPECT_TRUE(picture({"grain"}) == picture({"grain-1"}));
    EXPECT_FALSE(picture({"grain"}) == picture({"grain-1", "grain-x"}));
    options.bodies = {"grian"};
    EXPECT_THAT(error_of([&] { plot(folder, options); }), HasSubstr("no body \"grian\""));
    options.bodies = {"all", "grian"};
    EXPECT_THAT(error_of([&] { plot(folder, options); }), HasSubstr("no body \"grian\""));
}

} // namespace
} // namespace abut::test

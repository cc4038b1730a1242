/// Result folders that hold nothing, half of a series, or files that are broken; wrong requests.
#include "app_support.h"

#include <fstream>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

namespace fs = std::filesystem;

/// The results of a short run, made once.
const Folder& finished_run() {
    static const Folder folder;
    static const bool done = [] {
        folder.write("scene.json", small_scene().dump());
        return folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code == 0;
    }();
    EXPECT_TRUE(done);
    return folder;
}

/// A copy of them that a test may break.
struct Results {
    Folder folder;
    Results() { fs::copy(finished_run() / "results", folder / "results", fs::copy_options::recursive); }

    void cut(const std::string& file, double fraction) const {
        const fs::path path = folder / ("results/" + file);
        fs::resize_file(path, static_cast<std::uintmax_t>(fraction * static_cast<double>(fs::file_size(path))));
    }
    void write(const std::string& file, const std::string& text) const { folder.write("results/" + file, text); }
};

void expect_refusal(const Outcome& outcome, int exit_code, const std::vector<std::string>& words) {
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    ASSERT_EQ(lines(outcome.err).size(), 1U) << outcome.err;
    for (const std::string& word : words) EXPECT_THAT(outcome.err, HasSubstr(word));
    for (const char* inner : {"std::", "filesystem error", "vtk", "terminate"})
        EXPECT_THAT(outcome.err, testing::Not(HasSubstr(inner)));
}

TEST(BrokenResults, FolderWithoutResults) {
    const Folder folder;
    folder.write("empty/notes.txt", "x");
    for (const std::string command : {"render", "plot", "contact"}) {
        SCOPED_TRACE(command);
        expect_refusal(folder.abut({command, "nowhere"}), 2, {"nowhere: no such folder"});
        expect_refusal(folder.abut({command, "empty/notes.txt"}), 2, {"empty/notes.txt"});
        expect_refusal(folder.abut({command, "empty"}), 2, {"empty: no ", "is it the result folder of a run?"});
        EXPECT_EQ(folder.content().size(), 2U);
    }
}

TEST(BrokenResults, SeriesWithMissingOrHalfFiles) {
    const struct {
        std::string file;
        Arguments command;
    } cases[] = {{"particles/particles_00002.vtu", {"render", "results", "--width", "200"}},
                 {"grid/grid_00000.vti", {"render", "results", "--width", "200"}},
                 {"contact/contact_00003.vtp", {"render", "results", "--preset", "normals", "--width", "200"}}};
    for (const auto& [file, command] : cases) {
        SCOPED_TRACE(file);
        for (const double fraction : {0.0, 0.5, 0.9, 0.99}) {
            SCOPED_TRACE(fraction);
            const Results results;
            results.cut(file, fraction);
            expect_refusal(results.folder.abut(command), 1, {"results/" + file + ": cannot read"});
        }
        const Results results;
        fs::remove(results.folder / ("results/" + file));
        const bool of_series = !file.starts_with("grid/"); // of the grid only the first file's box is used
        expect_refusal(results.folder.abut(command), 1,
                       {"results/" + file + (of_series ? ": cannot read: no such file (frame " : ": no such file"),
                        of_series ? "of its series); nothing was drawn" : ""});
    }
}

TEST(BrokenResults, SeriesWithABrokenList) {
    const std::string begin = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"><Collection>\n";
    const std::string end = "</Collection></VTKFile>\n";
    for (const std::string& text :
         {std::string(), std::string("particles"), std::string(300, '\0'), begin, "<a></a>" + begin,
          std::string("<VTKFile><Collections/></VTKFile>"),
          begin + "<DataSet file=\"particles/particles_00000.vtu\"/>" + end, begin + "<DataSet timestep=\"0\"/>" + end,
          begin + "<DataSet timestep=\"soon\" file=\"a.vtu\"/>" + end}) {
        SCOPED_TRACE(text);
        const Results results;
        results.write("particles.pvd", text);
        expect_refusal(results.folder.abut({"render", "results"}), 1, {"results/particles.pvd: cannot read"});
    }
    for (const std::string file : {"../secret.vtu", "/etc/passwd", "particles/../../secret.vtu"}) {
        SCOPED_TRACE(file);
        const Results results;
        results.folder.write("secret.vtu", finished_run().read("results/particles/particles_00000.vtu"));
        results.write("particles.pvd", begin + "<DataSet timestep=\"0\" file=\"" + file + "\"/>" + end);
        expect_refusal(results.folder.abut({"render", "results"}), 1,
                       {"results/particles.pvd: cannot read: entry 0 is no file of its folder: \"" + file + "\""});
    }
    const Results results;
    results.write("particles.pvd", begin + end);
    expect_refusal(results.folder.abut({"render", "results"}), 2, {"particles.pvd: the series has no frames"});
}

TEST(BrokenResults, ThingsThatAreNotThere) {
    const Results results;
    const auto command = [&](Arguments arguments) { return results.folder.abut(arguments); };
    expect_refusal(command({"render", "results", "--array", "presure"}), 2,
                   {"\"presure\"", "did you mean \"pressure\"?"});
    expect_refusal(command({"render", "results", "--preset", "normal"}), 2,
                   {"\"normal\"", "did you mean \"normals\"?"});
    expect_refusal(command({"render", "results", "--frames", "77"}), 2, {"77"});
    expect_refusal(
        command({"plot", "results", "--columns", "kinetic_enery"}), 2,
        {"results/history.csv: no column \"kinetic_enery\"; did you mean \"kinetic_energy\"?", "momentum_x"});
    expect_refusal(command({"plot", "results", "--against", "tim"}), 2, {"no column \"tim\"; did you mean \"time\"?"});
    expect_refusal(command({"plot", "results", "--bodies", "bal"}), 2,
                   {"results/bodies.csv: no body \"bal\"; did you mean \"ball\"? (there are: block, ball)"});
    expect_refusal(command({"plot", "results", "--bodies", "ball", "--columns", "velocity"}), 2,
                   {"results/bodies.csv: no column \"velocity\"", "angular_velocity_z"});
    expect_refusal(command({"plot", "results", "--pairs", "--columns", "forces"}), 2,
                   {"results/pairs.csv: no column \"forces\"; did you mean \"force\"?"});
    expect_refusal(command({"plot", "results", "--pairs", "--bodies", "bal"}), 2, {"no body \"bal\""});
    expect_refusal(command({"plot", "results", "--pairs", "--against", "dt"}), 2, {"--against takes time or step"});
    fs::remove(results.folder / "results/pairs.csv");
    expect_refusal(command({"plot", "results", "--pairs"}), 2, {"results: no pairs.csv"});
    EXPECT_FALSE(fs::exists(results.folder / "results/plots"));
    EXPECT_EQ(command({"plot", "results", "--width", "5"}).exit_code, 2);
    EXPECT_EQ(command({"plot"}).exit_code, 2);
}

TEST(BrokenResults, TablesThatAreBroken) {
    const Results results;
    const std::string whole = results.folder.read("results/history.csv");
    const auto plot = [&](const std::string& text) {
        results.write("history.csv", text);
        return results.folder.abut({"plot", "results"});
    };
    expect_refusal(plot(""), 1, {"results/history.csv: cannot read: there is no whole row"});
    expect_refusal(plot("step,time\n0,0\n1\n"), 1, {"results/history.csv: line 3: 1 values for 2 columns"});
    expect_refusal(plot("step,time\n0,now\n"), 1,
                   {"results/history.csv: line 2: column \"time\": \"now\" is no number"});
    expect_refusal(plot("step\n0\n"), 2, {"results/history.csv: no column \"time\""});
    EXPECT_FALSE(fs::exists(results.folder / "results/plots"));
    // Of a run that is still writing, whole rows are drawn.
    const Outcome cut = plot(whole.substr(0, whole.size() - 30));
    EXPECT_EQ(cut.exit_code, 0) << cut.err;
    EXPECT_TRUE(fs::exists(results.folder / "results/plots/energies.png"));
    // Also only one row, or none.
    for (const std::size_t rows : {1U, 2U}) {
        std::string text;
        for (std::size_t i = 0; i < rows; ++i) text += lines(whole)[i] + "\n";
        EXPECT_EQ(plot(text).exit_code, 0) << rows;
    }
}

} // namespace
} // namespace abut::app_test

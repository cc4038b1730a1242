/// abut plot: which pictures it draws, and what it says.
#include "app_support.h"

#include "geometry/images/image.h"

#include <algorithm>

namespace abut::app_test {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;

TEST(Plot, DrawsTheTablesOfARun) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    const Outcome outcome = folder.abut({"plot", "results"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(lines(outcome.out), IsSupersetOf({"results/plots/energies.png", "results/plots/stresses.png",
                                                  "results/plots/forces.png", "results/plots/momentum.png"}));
    EXPECT_THAT(outcome.out, HasSubstr("balance error"));
    const Image picture = read_image(folder / "results/plots/energies.png");
    EXPECT_EQ(picture.width, 1200);
    EXPECT_EQ(picture.height, 800);
    const std::string first = folder.read("results/plots/energies.png");
    ASSERT_EQ(folder.abut({"plot", "results"}).exit_code, 0);
    EXPECT_TRUE(folder.read("results/plots/energies.png") == first) << "the same table, another picture";
}

TEST(Plot, DrawsWhatIsAskedFor) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    const auto files = [&](Arguments arguments) {
        const Arguments place{"results", "-o", "p", "--width", "400", "--height", "300"};
        arguments.insert(arguments.begin(), "plot");
        arguments.insert(arguments.end(), place.begin(), place.end());
        std::filesystem::remove_all(folder / "p");
        const Outcome outcome = folder.abut(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        std::vector<std::string> names;
        if (std::filesystem::exists(folder / "p"))
            for (const auto& entry : std::filesystem::directory_iterator(folder / "p")) {
                names.push_back(entry.path().filename().string());
                EXPECT_EQ(read_image(entry.path()).width, 400);
                EXPECT_THAT(outcome.out, HasSubstr("p/" + names.back() + "\n"));
            }
        std::sort(names.begin(), names.end());
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(files({"--columns", "kinetic_energy,strain_energy"}), Names{"kinetic_energy-strain_energy.png"});
    EXPECT_EQ(files({"--columns", "kinetic_energy,momentum_x", "--log-y", "--log-x"}),
              (Names{"kinetic_energy.png", "momentum_x.png"}));
    EXPECT_EQ(files({"--columns", "mean_stress_yy", "--against", "step", "--title", "Stress"}),
              Names{"mean_stress_yy.png"});
    EXPECT_EQ(files({"--bodies", "ball,block", "--columns", "vx"}), Names{"bodies-vx.png"});
    EXPECT_THAT(files({"--bodies", "all"}), IsSupersetOf({"bodies-vy.png", "bodies-kinetic_energy.png"}));
    EXPECT_THAT(files({"--pairs"}), IsSupersetOf({"pairs-force.png", "pairs-area.png", "pairs-work.png"}));
    EXPECT_EQ(files({"--pairs", "--bodies", "ball", "--columns", "force_y,force_x"}),
              (Names{"pairs-force_x.png", "pairs-force_y.png"}));
}

TEST(Plot, SaysThatThereAreNoForces) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"boundaries": null, "gravity": null, "contact": null})"}).dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet", "--until", "20us"}).exit_code, 0);
    const Outcome outcome = folder.abut({"plot", "results"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("no forces.png: the table has no force other than zero"));
    EXPECT_FALSE(std::filesystem::exists(folder / "results/plots/forces.png"));
}

} // namespace
} // namespace abut::app_test

/// Runs that go on after an end, a signal or a kill give what an uninterrupted run gives, bit for bit.
#include "app_support.h"

#include "geometry/images/image.h"

#include <csignal>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path source = ABUT_SOURCE_DIR;

struct Case {
    const char* name;
    const char* patch;
};

/// What a state may hold: each transfer, tractions, rigid bodies, rings, the stretch across the plane, prestress,
/// interfaces, three dimensions.
const std::vector<Case> cases{
    {"friction", "{}"},
    {"cpdi, fmpm", R"({"method": {"shape": "cpdi", "transfer": {"scheme": "fmpm", "order": 3}}})"},
    {"periodic fmpm", R"({"method": {"transfer": {"scheme": "fmpm", "order": 2, "every_cfl": 1.5}}})"},
    {"usavg+", R"({"method": {"transfer": {"scheme": "flip", "order": null}, "stress_update": "usavg+"}})"},
    {"gradients", R"({"contact": {"normal": "average-gradient", "separation": "fitted-position"}})"},
    {"interface",
     R"({"contact": {"law": {"type": "linear-interface", "normal_stiffness": "1 GPa/m", "coefficient": null,
                      "tangential_stiffness": "1 GPa/m"}}})"},
    {"plane stress", R"({"analysis": "plane-stress"})"},
    {"no contact", R"({"contact": null})"},
};

TEST(Resume, GoesOnBitIdenticallyAlsoWithOtherThreads) {
    for (const Case& one : cases) {
        const Folder folder;
        folder.write("scene.json", small_scene({one.patch}).dump());
        const auto run = [&](const Arguments& more) {
            Arguments arguments{"run", "scene.json", "--quiet"};
            arguments.insert(arguments.end(), more.begin(), more.end());
            const Outcome outcome = folder.abut(arguments);
            EXPECT_EQ(outcome.exit_code, 0) << one.name << ": " << outcome.err;
        };
        run({"-o", "whole", "--threads", "1"});
        run({"-o", "parts", "--threads", "2", "--until", "0.13 ms"});
        run({"-o", "parts", "--threads", "1", "--resume", "--steps", "80"});
        run({"-o", "parts", "--threads", "2", "--resume"});
        expect_same_results(folder, "whole", "parts", one.name);
    }
}

TEST(Resume, GoesOnInEveryExample) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "examples")) {
        if (entry.path().filename() != "scene.json") continue;
        const Folder folder;
        const auto run = [&](const Arguments& more) {
            Arguments arguments{"run", entry.path().string(), "--quiet", "--set", "/output/history_every=1e-30"};
            arguments.insert(arguments.end(), more.begin(), more.end());
            const Outcome outcome = folder.abut(arguments);
            EXPECT_EQ(outcome.exit_code, 0) << entry.path() << ": " << outcome.err;
        };
        run({"-o", "whole", "--threads", "2", "--steps", "7"});
        run({"-o", "parts", "--threads", "1", "--steps", "4"});
        run({"-o", "parts", "--threads", "2", "--steps", "7", "--resume"});
        expect_same_results(folder, "whole", "parts", entry.path().string());
        ++scenes;
    }
    EXPECT_GT(scenes, 10);
}

/// Waits until the program has ended, or kills it after `milliseconds`. \return whether it was killed
bool killed_after(const Folder& folder, pid_t process, int milliseconds, int signal, Outcome& outcome) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(process, signal);
    outcome = folder.end_of(process);
    return outcome.exit_code == 128 + signal || outcome.exit_code == 130;
}

TEST(Resume, SurvivesKillsAtRandomMoments) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"time": {"end": "1 ms"},
                                  "output": {"every": "20 us", "checkpoint_every_steps": 5, "history_every": "3 us"}})"})
                                   .dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "whole", "--quiet"}).exit_code, 0);
    std::mt19937 random(7);
    int kills = 0;
    for (int round = 0; kills < 24 && round < 24; ++round) { // on fast machines a run is over after a few
        bool resume = false;
        Outcome outcome;
        for (int tries = 0; tries < 400; ++tries) {
            Arguments arguments{"run", "scene.json", "-o", "parts", "--quiet"};
            arguments.push_back(resume ? "--resume" : "--overwrite");
            const int wait = std::uniform_int_distribution<>(30, 200 + 5 * tries)(random); // ends on slow machines too
            if (!killed_after(folder, folder.start(arguments), wait, kills % 5 == 4 ? SIGTERM : SIGKILL, outcome))
                break;
            ++kills;
            resume = std::filesystem::exists(folder / "parts/checkpoint.h5") ||
                     std::filesystem::exists(folder / "parts/checkpoint-previous.h5");
        }
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        expect_same_results(folder, "whole", "parts", "killed");
    }
    EXPECT_GE(kills, 24);
    std::printf("[ figures  ] %d kills\n", kills);
}

TEST(Resume, ALaterEndIsAsIfItHadBeenMeantFromTheStart) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    const Arguments longer{"--set", "/time/end=0.55 ms", "--set", "/output/every=0.05 ms"};
    const auto run = [&](Arguments arguments, const Arguments& more) {
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = folder.abut(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    };
    run({"run", "scene.json", "-o", "whole", "--quiet"}, longer);
    run({"run", "scene.json", "-o", "parts", "--quiet"}, {});
    run({"run", "scene.json", "-o", "parts", "--quiet", "--resume"}, longer);
    EXPECT_TRUE(folder.read("whole/history.csv") == folder.read("parts/history.csv"));
    EXPECT_TRUE(folder.read("whole/pairs.csv") == folder.read("parts/pairs.csv"));
    EXPECT_TRUE(folder.read("whole/particles/particles_00011.vtu") ==
                folder.read("parts/particles/particles_00007.vtu"))
        << "the last frames; those before 0.4 ms were written half as often";
}

TEST(Resume, RefusesWhatDoesNotFit) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    const Outcome none = folder.abut({"run", "scene.json", "-o", "r", "--resume"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_THAT(none.err, HasSubstr("r: no checkpoint.h5 to resume from"));
    EXPECT_FALSE(std::filesystem::exists(folder / "r"));

    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "r", "--quiet", "--until", "0.1 ms"}).exit_code, 0);
    const auto before = folder.content();
    const Outcome changed = folder.abut(
        {"run", "scene.json", "-o", "r", "--resume", "--set", "/method/shape=cpdi", "--set", "/grid/cell=2 mm"});
    EXPECT_EQ(changed.exit_code, 2);
    EXPECT_THAT(changed.err, AllOf(HasSubstr("/method/shape: was \"ugimp\", is \"cpdi\""), HasSubstr("/grid/cell")));
    const Outcome both = folder.abut({"run", "scene.json", "-o", "r", "--resume", "--overwrite"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_EQ(folder.content(), before);

    std::filesystem::resize_file(folder / "r/history.csv", 100);
    const Outcome cut = folder.abut({"run", "scene.json", "-o", "r", "--resume"});
    EXPECT_EQ(cut.exit_code, 2);
    EXPECT_THAT(cut.err, HasSubstr("r/history.csv"));
}

/// The files of frames after the checkpoint are removed: only those that a run has written.
TEST(Resume, RefusesASeriesThatListsOtherFiles) {
    const Folder made;
    made.write("scene.json", small_scene().dump());
    ASSERT_EQ(made.abut({"run", "scene.json", "-o", "r", "--quiet", "--until", "0.25 ms"}).exit_code, 0);
    const std::string list = made.read("r/particles.pvd");
    const std::string last = "particles/particles_00003.vtu";
    ASSERT_THAT(list, HasSubstr(last)) << "after the checkpoint";
    for (const std::string entry : {"../x", "ABSOLUTE", "link/x", "particles/../../x", "scene.json", "particles",
                                    "particles/particles_00001.vtu", "particles/../particles/particles_00003.vtu"}) {
        SCOPED_TRACE(entry);
        const Folder folder;
        std::filesystem::copy(made / "r", folder / "r", std::filesystem::copy_options::recursive);
        folder.write("scene.json", made.read("scene.json"));
        folder.write("x", "precious");
        std::filesystem::create_directory_symlink("..", folder / "r/link");
        std::string changed = list;
        changed.replace(changed.find(last), last.size(), entry == "ABSOLUTE" ? (folder / "x").string() : entry);
        folder.write("r/particles.pvd", changed);
        const auto before = results_in(folder, ".");
        const Outcome outcome = folder.abut({"run", "scene.json", "-o", "r", "--resume"});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("r/particles.pvd: "), HasSubstr("entry 3 is ")));
        EXPECT_EQ(lines(outcome.err).size(), 1U) << outcome.err;
        EXPECT_TRUE(results_in(folder, ".") == before) << "nothing is touched, outside or in the folder";
    }
}

TEST(Resume, FollowsNoLinkOutOfItsFolder) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    const Arguments command{"run", "scene.json", "-o", "r", "--quiet"};
    Arguments part = command, on = command;
    part.insert(part.end(), {"--until", "0.25 ms"});
    on.emplace_back("--resume");
    ASSERT_EQ(folder.abut(part).exit_code, 0);
    // The frames are elsewhere.
    std::filesystem::rename(folder / "r/particles", folder / "elsewhere");
    std::filesystem::create_directory_symlink("../elsewhere", folder / "r/particles");
    const auto before = results_in(folder, ".");
    const Outcome refused = folder.abut(on);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("r/particles: is a link"));
    EXPECT_TRUE(results_in(folder, ".") == before);
    std::filesystem::remove(folder / "r/particles");
    std::filesystem::rename(folder / "elsewhere", folder / "r/particles");
    // The list is elsewhere: it is read there and written here.
    std::filesystem::rename(folder / "r/particles.pvd", folder / "list.pvd");
    std::filesystem::create_symlink("../list.pvd", folder / "r/particles.pvd");
    const std::string list = folder.read("list.pvd");
    EXPECT_EQ(folder.abut(on).exit_code, 0);
    EXPECT_EQ(folder.read("list.pvd"), list);
    EXPECT_FALSE(std::filesystem::is_symlink(folder / "r/particles.pvd"));
}

TEST(Resume, TakesTheCheckpointBeforeIfTheLastIsBroken) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"output": {"checkpoint_every_steps": 10}})"}).dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "whole", "--quiet"}).exit_code, 0);
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "parts", "--quiet", "--steps", "55"}).exit_code, 0);
    std::filesystem::resize_file(folder / "parts/checkpoint.h5", 3000);
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "parts", "--quiet", "--resume"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_same_results(folder, "whole", "parts", "broken");

    for (const char* name : {"parts/checkpoint.h5", "parts/checkpoint-previous.h5"})
        std::filesystem::resize_file(folder / name, 3000);
    const Outcome broken = folder.abut({"run", "scene.json", "-o", "parts", "--resume"});
    EXPECT_EQ(broken.exit_code, 2);
    EXPECT_THAT(broken.err, AllOf(HasSubstr("checkpoint.h5: "), HasSubstr("checkpoint-previous.h5: ")));
}

TEST(Resume, AChangedImageIsNoticed) {
    const Folder folder;
    const auto draw = [&](int first_row) {
        Image picture{40, 40, 3, std::vector<std::uint16_t>(3 * 40 * 40, 255)};
        for (int i = 40 * first_row; i < 40 * (first_row + 12); ++i)
            std::fill_n(picture.pixels.begin() + 3 * i, 3, std::uint16_t{0});
        write_image(picture, folder / "a.png");
    };
    draw(20);
    folder.write("scene.json", small_scene({R"({"bodies": [], "images": [{"file": "a.png", "pixel": "0.25 mm",
        "lower": ["1 mm", "1 mm"], "legend": [{"grey": 0, "body": "bar", "material": "rubber"},
                                              {"grey": 255, "void": true}]}]})"})
                                   .dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "r", "--quiet", "--steps", "5"}).exit_code, 0);
    draw(16);
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "r", "--resume"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("has an image or another file that it names been changed?"));
}

TEST(Checkpoint, CanBeSwitchedOff) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"output": {"checkpoint": false}})"}).dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "r", "--quiet"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "r/checkpoint.h5"));
}

} // namespace
} // namespace abut::app_test

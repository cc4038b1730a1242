/// abut render: processes, animations, what is wrong with a series; the picture of a run under way.
#include "app_support.h"

#include <fmt/format.h>

#include <filesystem>

namespace abut::app_test {

namespace {

using testing::HasSubstr;

/// A folder with the results of a small run.
void run_small_scene(const Folder& folder, const std::vector<std::string>& patches = {}) {
    folder.write("scene.json", small_scene(patches).dump());
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "results", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

std::size_t frames_of(const Folder& folder) {
    std::size_t count = 0;
    for (const auto& [name, size] : folder.content()) count += name.starts_with("results/particles/") ? 1 : 0;
    return count;
}

TEST(AppRender, PicturesDontDependOnTheNumberOfProcesses) {
    const Folder folder;
    run_small_scene(folder);
    const std::size_t frames = frames_of(folder);
    ASSERT_GE(frames, 2u);
    for (const char* preset : {"contact", "stress"}) {
        for (const char* jobs : {"1", "2", "7"}) {
            const Outcome outcome = folder.abut({"render", "results", "--preset", preset, "--width", "300", "--jobs",
                                                 jobs, "-o", std::string(preset) + jobs});
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            EXPECT_THAT(outcome.out, HasSubstr(std::to_string(frames) + " pictures"));
            EXPECT_EQ(outcome.err, ""); // the bar is for terminals
        }
        for (std::size_t f = 0; f < frames; ++f) {
            const std::string name = fmt::format("/frame_{:05}.png", f);
            const std::string one = folder.read(preset + std::string("1") + name);
            EXPECT_GT(one.size(), 1000u);
            EXPECT_EQ(one, folder.read(preset + std::string("2") + name));
            EXPECT_EQ(one, folder.read(preset + std::string("7") + name));
        }
    }
}

TEST(AppRender, AnAnimationBesideThePictures) {
    const Folder folder;
    run_small_scene(folder);
    const Outcome outcome = folder.abut({"render", "results", "--particles", "ellipses", "--bodies", "ball", "--region",
                                         "0,0,5e-3,10 mm", "--width", "200", "--animation", "all.apng", "--fps", "4"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("; and all.apng"));
    EXPECT_THAT(folder.read("all.apng"), HasSubstr("acTL"));
    ASSERT_EQ(folder.abut({"render", "results", "--width", "200", "--animation", "all.ogv", "--quiet"}).out, "");
    EXPECT_EQ(folder.read("all.ogv").substr(0, 4), "OggS");
    for (const auto& [name, size] : folder.content()) EXPECT_THAT(name, testing::Not(HasSubstr(".tmp")));
}

TEST(AppRender, WhatIsWrongIsSaidAndNothingDrawn) {
    const Folder folder;
    run_small_scene(folder);
    const auto before = folder.content();
    const auto expect = [&](Arguments arguments, int exit_code, const std::string& message) {
        arguments.insert(arguments.begin(), {"render", "results"});
        const Outcome outcome = folder.abut(arguments);
        EXPECT_EQ(outcome.exit_code, exit_code) << message;
        EXPECT_THAT(outcome.err, HasSubstr(message));
        EXPECT_EQ(folder.content(), before) << message;
    };
    expect({"--preset", "temperature"}, 2, "this scene has no temperature; what can be drawn: bodies, ");
    expect({"--bodies", "bal"}, 2, "did you mean \"ball\"?");
    expect({"--region", "0,0,1 kg,1"}, 2, "--region 0,0,1 kg,1: ");
    expect({"--region", "0,0,1mm"}, 2, "a region has 4 numbers");
    expect({"--region", "0,,1mm,1"}, 2, "a length is missing");
    expect({"--animation", "film.mp4"}, 2, ".ogv");
    expect({"--particles", "discs"}, 2, "--particles");
    expect({"--range", "1", "2", "--percentile", "99"}, 2, "not both");
    expect({"--jobs", "0"}, 2, "--jobs");
    expect({"--range", "-inf", "inf"}, 2, "must be finite");
    expect({"--region", "0,0,inf,1"}, 2, "must be finite");
    expect({"--region", "0,0,1e300,1e300"}, 2, "nothing would be seen");
    expect({"--region", "1,1,2,2"}, 2, "outside the grid");
    expect({"--animation", "results"}, 2, "results");
    expect({"-o", "scene.json/pictures"}, 1, "scene.json/pictures: ");
}

TEST(AppRender, FramesWithoutContactPairsAreTold) {
    const Folder folder;
    run_small_scene(folder, {R"({"output": {"every": "20 us", "contact_every": "40 us"}})"});
    const Arguments command{"render", "results", "--preset", "contact", "--width", "200", "-o", "p"};
    const Outcome all = folder.abut(command);
    EXPECT_EQ(all.exit_code, 0) << all.err;
    ASSERT_EQ(lines(all.err).size(), 1u);
    EXPECT_THAT(all.err, HasSubstr("frames are not drawn: results/contact.pvd has no frame at their times"));
    EXPECT_EQ(folder.content().count("p/frame_00002.png"), 1u);
    EXPECT_EQ(folder.content().count("p/frame_00001.png"), 0u);
    Arguments one = command;
    one.insert(one.end(), {"--frames", "1"});
    const Outcome outcome = folder.abut(one);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("frame 1: results/contact.pvd has no frame at its time (contact_every)"));
}

TEST(AppRender, AFileThatAWorkerFindsBrokenIsNamed) {
    const Folder folder;
    run_small_scene(folder);
    std::string file = folder.read("results/particles/particles_00001.vtu");
    const std::size_t at = file.find("<Piece");
    ASSERT_NE(at, std::string::npos);
    file.replace(at, 6, "<Peace"); // whole at its end
    folder.write("results/particles/particles_00001.vtu", file);
    const Outcome outcome = folder.abut({"render", "results", "--width", "200", "--jobs", "2"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("particles_00001.vtu: cannot read"));
    EXPECT_EQ(lines(outcome.err).size(), 1u);
}

TEST(AppRender, ARunUnderWayDrawsItsLivePicture) {
    const Folder folder;
    run_small_scene(folder, {R"({"output": {"live": true, "live_preset": "contact"}})"});
    EXPECT_EQ(folder.read("results/live.png").substr(1, 3), "PNG");
    EXPECT_EQ(folder.content().count("results/.live.png.tmp"), 0u);
    // A run without one in the same folder leaves none.
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet", "--overwrite"}).exit_code, 0);
    EXPECT_EQ(folder.content().count("results/live.png"), 0u);
}

TEST(AppRender, ALivePictureThatFailsDoesNotEndTheRun) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"output": {"live": true, "live_preset": "temperature"}})"}).dump());
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "results", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("live.png is not drawn: "));
    EXPECT_THAT(outcome.err, HasSubstr("this scene has no temperature"));
    EXPECT_EQ(lines(outcome.err).size(), 1u);
    EXPECT_EQ(folder.content().count("results/live.png"), 0u);
}

} // namespace

} // namespace abut::app_test

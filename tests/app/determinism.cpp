/// The same bits, whatever the number of threads and whatever is written.
#include "app_support.h"

namespace abut::app_test {
namespace {

/// A scene with all that threads share: many bodies that meet, CPDI's stored stencils, regression normals, walls.
Json busy_scene() {
    Json scene = small_scene({R"({"method": {"shape": "cpdi", "transfer": {"order": 5}},
                                  "output": {"every": 0, "history_every": "2 us"}, "time": {"end": "0.3 ms"}})"});
    scene["bodies"] = Json::array();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            scene["bodies"].push_back({{"name", "disk-" + std::to_string(3 * i + j)},
                                       {"material", "rubber"},
                                       {"disk", {{"center", {2e-3 + 4e-3 * i, 2e-3 + 4e-3 * j}}, {"radius", 2e-3}}},
                                       {"velocity", {1.0 - i, -4.0 * j}}});
    return scene;
}

TEST(Run, IsBitIdenticalForAnyNumberOfThreads) {
    const Folder folder;
    folder.write("scene.json", busy_scene().dump());
    for (const std::string method : {"logistic-regression", "average-gradient"}) {
        std::vector<std::string> histories, bodies, particles, contacts;
        for (const std::string threads : {"1", "2", "3"}) {
            const std::string results = method + threads;
            const Outcome outcome = folder.abut({"run", "scene.json", "-o", results, "--threads", threads, "--quiet",
                                                 "--set", "/contact/normal=" + method});
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            histories.push_back(folder.read(results + "/history.csv"));
            bodies.push_back(folder.read(results + "/bodies.csv"));
            particles.push_back(folder.read(results + "/particles/particles_00001.vtu"));
            contacts.push_back(folder.read(results + "/contact/contact_00001.vtp"));
        }
        EXPECT_GT(lines(histories[0]).size(), 50U);
        for (const auto& files : {histories, bodies, particles, contacts}) {
            EXPECT_TRUE(files[0] == files[1]) << method;
            EXPECT_TRUE(files[0] == files[2]) << method;
        }
    }
}

TEST(Run, DoesNotDependOnWhatIsWritten) {
    const Folder folder;
    folder.write("scene.json", busy_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "seldom", "--quiet"}).exit_code, 0);
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "often", "--quiet", "--set", "/output/every=3e-6"}).exit_code, 0);
    EXPECT_TRUE(folder.read("often/history.csv") == folder.read("seldom/history.csv"));
    EXPECT_TRUE(folder.read("often/bodies.csv") == folder.read("seldom/bodies.csv"));
}

} // namespace
} // namespace abut::app_test

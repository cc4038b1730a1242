/// A disk that fills up while the program writes: what is left is whole, and the message says what happened.
#include "app_support.h"

#include "io/results/pvd.h"
#include "io/results/read_csv.h"
#include "io/results/read_frame.h"

#include <sys/mount.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

/// A small disk of its own (tmpfs), mounted while it lives.
class SmallDisk {
public:
    SmallDisk(const fs::path& place, int kilobytes) : place_(place) {
        fs::create_directories(place);
        const std::string options = "size=" + std::to_string(kilobytes) + "k";
        if (::mount("tmpfs", place.c_str(), "tmpfs", 0, options.c_str()) != 0) cause_ = std::strerror(errno);
    }
    ~SmallDisk() {
        if (cause_.empty()) ::umount2(place_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    /// Why there is no such disk; empty: there is.
    const std::string& cause() const { return cause_; }

private:
    fs::path place_;
    std::string cause_;
};

/// Every file of a result folder that exists can be read and is whole. \return number of files looked at
int expect_whole_results(const fs::path& results) {
    int files = 0;
    if (!fs::exists(results)) return 0;
    for (const auto& entry : fs::recursive_directory_iterator(results)) {
        if (!entry.is_regular_file()) continue;
        ++files;
        const fs::path& file = entry.path();
        EXPECT_THAT(file.filename().string(), testing::Not(StartsWith("."))) << "left over";
        const std::string extension = file.extension().string();
        if (extension == ".vtu" || extension == ".vtp") {
            EXPECT_NO_THROW(read_points(file)) << file;
        } else if (extension == ".vti") {
            EXPECT_NO_THROW(read_grid(file)) << file;
        } else if (extension == ".json") {
            EXPECT_TRUE(Json::accept(Folder().read(file.string()))) << file;
        } else if (extension == ".csv") {
            const std::string text = Folder().read(file.string());
            EXPECT_TRUE(text.empty() || text.back() == '\n') << file << " ends with " << text.substr(text.rfind('\n'));
            if (!text.empty()) {
                EXPECT_NO_THROW(read_csv(file, {"body", "body_a", "body_b", "method"})) << file;
            }
        } else if (extension == ".png") {
            vtkNew<vtkPNGReader> reader;
            reader->SetFileName(file.c_str());
            reader->Update();
            EXPECT_EQ(reader->GetErrorCode(), 0U) << file;
            EXPECT_GT(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
        } else {
            EXPECT_EQ(extension, ".pvd") << file;
        }
        if (extension != ".pvd") continue;
        for (const PvdEntry& frame : read_pvd(file).entries)
            EXPECT_TRUE(fs::is_regular_file(file.parent_path() / frame.file)) << file << ": " << frame.file;
    }
    return files;
}

void expect_full_disk(const Outcome& outcome, const std::string& where) {
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(lines(outcome.err), testing::ElementsAre(AllOf(StartsWith("abut: "), HasSubstr(where),
                                                               HasSubstr("No space left on device"))));
}

/// A scene whose tables and frames grow at the same pace.
std::string scene() {
    return small_scene({R"({"output": {"every": "20 us", "history_every": "2 us"}})"}).dump();
}

TEST(FullDisk, RunLeavesWholeFiles) {
    const Folder folder;
    folder.write("scene.json", scene());
    int most = 0;
    for (const int kilobytes : {4, 16, 40, 60, 100, 150, 300, 500}) {
        SCOPED_TRACE(std::to_string(kilobytes) + " kB");
        const SmallDisk disk(folder / "disk", kilobytes);
        if (!disk.cause().empty()) GTEST_SKIP() << "no tmpfs can be mounted: " << disk.cause();
        expect_full_disk(folder.abut({"run", "scene.json", "-o", "disk/results", "--quiet"}), "disk/results");
        most = std::max(most, expect_whole_results(folder / "disk/results"));
    }
    EXPECT_GT(most, 15);
    const SmallDisk disk(folder / "disk", 20000);
    EXPECT_EQ(folder.abut({"run", "scene.json", "-o", "disk/results", "--quiet"}).exit_code, 0);
}

TEST(FullDisk, RecordedContactNodesAreWhole) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"output": {"every": "20 us", "particles": false, "grid": false,
        "contact_clouds": {"near": [["6 mm", "4 mm"]], "disagreement": "5 deg"}}})"})
                                   .dump());
    std::size_t clouds = 0;
    for (const int kilobytes : {40, 60, 80, 100, 130, 160, 200}) {
        SCOPED_TRACE(std::to_string(kilobytes) + " kB");
        const SmallDisk disk(folder / "disk", kilobytes);
        if (!disk.cause().empty()) GTEST_SKIP() << "no tmpfs can be mounted: " << disk.cause();
        expect_full_disk(folder.abut({"run", "scene.json", "-o", "disk/results", "--quiet"}), "disk/results");
        expect_whole_results(folder / "disk/results");
        const fs::path series = folder / "disk/results/clouds/cloud_near_0.pvd";
        if (fs::exists(series)) clouds += read_pvd(series).entries.size();
    }
    EXPECT_GT(clouds, 3U);
}

TEST(FullDisk, RunWithFilesThatMayNotGrowLeavesWholeFiles) {
    const Folder folder; // ulimit -f: needs no root
    folder.write("scene.json", scene());
    for (const std::size_t limit : {700U, 2000U, 9000U, 12345U, 20000U}) {
        SCOPED_TRACE(limit);
        const Outcome outcome = folder.abut({"run", "scene.json", "-o", "results", "--overwrite", "--quiet"}, limit);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_THAT(lines(outcome.err),
                    testing::ElementsAre(AllOf(StartsWith("abut: results/"), EndsWith("File too large"))));
        EXPECT_GT(expect_whole_results(folder / "results"), 0);
    }
}

/// Commands that write pictures of finished results, or one model, to "disk".
const std::vector<Arguments>& writing_commands() {
    static const std::vector<Arguments> commands{
        {"render", "results", "-o", "disk/frames"},
        {"render", "results", "--preset", "normals", "-o", "disk/frames"},
        {"plot", "results", "-o", "disk/plots"},
        {"plot", "results", "--pairs", "-o", "disk/plots"},
        {"particles", "scene.json", "-o", "disk/model.vtu"},
    };
    return commands;
}

/// Commands that write an animation there; their pictures go elsewhere.
std::vector<Arguments> animating_commands() {
    std::vector<Arguments> commands;
    for (const char* name : {"disk/f.ogv", "disk/f.apng"})
        commands.push_back({"render", "results", "-o", "frames", "--animation", name});
    return commands;
}

TEST(FullDisk, PicturesAreWholeOrNotThere) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    std::vector<Arguments> commands = writing_commands();
    for (const Arguments& command : animating_commands()) commands.push_back(command);
    for (const Arguments& command : commands)
        for (const int kilobytes : {4, command[0] == "particles" ? 12 : 36}) {
            SCOPED_TRACE(command[0] + " on " + std::to_string(kilobytes) + " kB");
            const SmallDisk disk(folder / "disk", kilobytes);
            if (!disk.cause().empty()) GTEST_SKIP() << "no tmpfs can be mounted: " << disk.cause();
            expect_full_disk(folder.abut(command), "disk/");
            expect_whole_results(folder / "disk");
        }
}

TEST(FullDisk, PicturesThatMayNotGrowAreWholeOrNotThere) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    for (const Arguments& command : writing_commands())
        for (const std::size_t limit : {500U, 8000U}) {
            SCOPED_TRACE(command[0] + " with files of at most " + std::to_string(limit));
            fs::remove_all(folder / "disk");
            fs::create_directories(folder / "disk");
            const Outcome outcome = folder.abut(command, limit);
            EXPECT_EQ(outcome.exit_code, 1);
            EXPECT_THAT(lines(outcome.err),
                        testing::ElementsAre(AllOf(StartsWith("abut: disk/"), EndsWith("File too large"))));
            expect_whole_results(folder / "disk");
        }
}

TEST(FullDisk, AnimationsThatMayNotGrowLeaveTheOldOnes) {
    const Folder folder; // a limit that all pictures keep
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    fs::create_directories(folder / "disk");
    for (const Arguments& command : animating_commands()) {
        const std::string& name = command.back();
        ASSERT_EQ(folder.abut(command).exit_code, 0) << name;
        const std::string whole = folder.read(name);
        std::size_t largest = 0;
        for (const auto& picture : fs::directory_iterator(folder / "frames"))
            largest = std::max<std::size_t>(largest, picture.file_size());
        ASSERT_LT(largest, whole.size() - 1);
        for (const std::size_t limit : {largest, whole.size() - 1}) {
            SCOPED_TRACE(name + " of at most " + std::to_string(limit));
            const Outcome outcome = folder.abut(command, limit);
            EXPECT_EQ(outcome.exit_code, 1);
            EXPECT_THAT(lines(outcome.err),
                        testing::ElementsAre(AllOf(StartsWith("abut: " + name), EndsWith("File too large"))));
            EXPECT_TRUE(folder.read(name) == whole);
        }
    }
}

TEST(FullDisk, DevicesAreNoPlaceForFolders) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    for (const Arguments& command :
         {Arguments{"render", "results", "-o", "/dev/full"}, Arguments{"plot", "results", "-o", "/dev/full"}}) {
        const Outcome outcome = folder.abut(command);
        EXPECT_EQ(outcome.exit_code, 1) << command[0];
        EXPECT_THAT(lines(outcome.err), testing::ElementsAre(StartsWith("abut: /dev/full"))) << command[0];
    }
    const Outcome particles = folder.abut({"particles", "scene.json", "-o", "/dev/full"});
    EXPECT_EQ(particles.exit_code, 2);
    EXPECT_THAT(particles.err, HasSubstr("/dev/full: the name must end in .vtu"));
    const Outcome run = folder.abut({"run", "scene.json", "-o", "/dev/full"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(lines(run.err), testing::ElementsAre(StartsWith("abut: /dev/full: is a file")));
}

} // namespace
} // namespace abut::app_test

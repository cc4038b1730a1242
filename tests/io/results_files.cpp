// Text, tables, series and the result folder.
#include "io/results/csv.h"
#include "io/results/pvd.h"
#include "io/results/result_folder.h"
#include "io/results/write_text.h"
#include "results_support.h"

#include <charconv>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <optional>
#include <sstream>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

namespace abut::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(WriteText, ReplacesTheWholeFile) {
    TemporaryFolder folder;
    write_text_atomically(folder / "a.json", "a longer text\n");
    write_text_atomically(folder / "a.json", std::string("\0b", 2));
    EXPECT_EQ(read_text(folder / "a.json"), std::string("\0b", 2));
    EXPECT_EQ(folder.count(), 1u);
}

TEST(WriteText, FailuresNameFileAndCause) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { write_text_atomically(folder / "none/a.json", "x"); }),
                HasSubstr("none/a.json: cannot write: No such file or directory"));
    EXPECT_EQ(error_of([] { write_text_atomically("/dev/full", "x"); }),
              "/dev/full: cannot write: No space left on device");
    EXPECT_TRUE(fs::exists("/dev/full"));
    fs::create_directory(folder / "sub");
    EXPECT_THAT(error_of([&] { write_text_atomically(folder / "sub", "x"); }), HasSubstr("sub: cannot write"));

    write_text_atomically(folder / "a.json", "old");
    {
        DiskLimit full(10);
        error_of([&] { write_text_atomically(folder / "a.json", "a text of more than ten bytes"); });
    }
    EXPECT_EQ(read_text(folder / "a.json"), "old");
    EXPECT_EQ(folder.count(), 2u);
}

TEST(CsvTable, WritesHeaderAndRows) {
    TemporaryFolder folder;
    CsvTable table(folder / "t.csv", {"step", "time", "body"});
    EXPECT_EQ(read_text(folder / "t.csv"), "step,time,body\n");
    const std::string name = "a \"quoted\", one";
    table.row({1, 0.1, "block"});
    table.row({std::int64_t{20000000000}, -1e-300, name});
    EXPECT_EQ(read_text(folder / "t.csv"), "step,time,body\n"); // buffered
    table.flush();
    EXPECT_EQ(read_text(folder / "t.csv"),
              "step,time,body\n1,0.1,block\n20000000000,-1e-300,\"a \"\"quoted\"\", one\"\n");
    EXPECT_THROW(table.row({1, 2.0}), std::logic_error);
}

TEST(CsvTable, RealsReadBackToTheSameBits) {
    TemporaryFolder folder;
    std::vector<double> values{0.1, 1.0 / 3, -0.0, 1e22, 5e-324, std::numeric_limits<double>::max()};
    {
        CsvTable table(folder / "t.csv", std::vector<std::string>(values.size(), "x"));
        table.row(values);
    } // flushed by the destructor
    std::istringstream lines(read_text(folder / "t.csv"));
    std::string line;
    std::getline(lines, line);
    for (const double expected : values) {
        std::getline(lines, line, &expected == &values.back() ? '\n' : ',');
        double value = 1;
        std::from_chars(line.data(), line.data() + line.size(), value);
        EXPECT_EQ(value, expected);
        EXPECT_EQ(std::signbit(value), std::signbit(expected));
    }
}

TEST(CsvTable, ManyRowsReachTheFileWhole) {
    TemporaryFolder folder;
    CsvTable table(folder / "t.csv", {"a", "b"});
    for (int i = 0; i < 20000; ++i) table.row({i, i / 7.0});
    const std::string text = read_text(folder / "t.csv"); // as a killed run leaves it
    EXPECT_GT(text.size(), 100000u);
    EXPECT_EQ(text.back(), '\n');
}

TEST(CsvTable, GoesOnOnlyWhereARowOfItsOwnEnds) {
    TemporaryFolder folder;
    std::uintmax_t bytes = 0;
    {
        CsvTable table(folder / "t.csv", {"a", "b"});
        table.row({1.0, 2.0});
        bytes = table.bytes();
        table.row({3.0, 4.0});
    }
    const auto why_not = [&](const std::vector<std::string>& columns, std::uintmax_t end) {
        return error_of([&] { check_continued(folder / "t.csv", columns, end); });
    };
    EXPECT_NO_THROW(check_continued(folder / "t.csv", {"a", "b"}, bytes));
    EXPECT_NO_THROW(check_continued(folder / "t.csv", {"a", "b"}, fs::file_size(folder / "t.csv")));
    EXPECT_THAT(why_not({"a", "c"}, bytes), HasSubstr("other columns"));
    EXPECT_THAT(why_not({"a", "b"}, bytes + 1), HasSubstr("no row ends after"));
    EXPECT_THAT(why_not({"a", "b"}, 1000), HasSubstr("instead of at least 1000"));
    fs::remove(folder / "t.csv");
    EXPECT_THAT(why_not({"a", "b"}, bytes), HasSubstr("no such file"));
}

TEST(CsvTable, FailuresNameFileAndCause) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { CsvTable(folder / "none/t.csv", {"a"}); }),
                HasSubstr("none/t.csv: cannot write: No such file or directory"));
    EXPECT_EQ(error_of([] { CsvTable("/dev/full", {"a"}); }), "/dev/full: cannot write: No space left on device");
}

TEST(Pvd, ListsFramesAndReadsBack) {
    TemporaryFolder folder;
    PvdSeries series{folder / "particles.pvd", {}};
    series.append(0, "particles/particles_00000.vtu");
    EXPECT_EQ(read_pvd(folder / "particles.pvd").entries.size(), 1u);
    series.append(0.1e-6, "a & \"b\".vtu");
    const PvdSeries back = read_pvd(folder / "particles.pvd");
    ASSERT_EQ(back.entries.size(), 2u);
    EXPECT_EQ(back.entries[0].file, "particles/particles_00000.vtu");
    EXPECT_EQ(back.entries[1].time, 0.1e-6);
    EXPECT_EQ(back.entries[1].file, "a & \"b\".vtu");
    EXPECT_THAT(read_text(folder / "particles.pvd"),
                HasSubstr("<DataSet timestep=\"1e-07\" group=\"\" part=\"0\" file=\"a &amp; &quot;b&quot;.vtu\"/>"));
}

TEST(Pvd, ResumedRunReplacesLaterFrames) {
    TemporaryFolder folder;
    PvdSeries series{folder / "p.pvd", {}};
    for (int i = 0; i < 4; ++i) series.append(i, std::to_string(i));
    PvdSeries resumed = read_pvd(folder / "p.pvd");
    resumed.append(2, "2b");
    std::vector<std::string> files;
    for (const PvdEntry& entry : read_pvd(folder / "p.pvd").entries) files.push_back(entry.file);
    EXPECT_THAT(files, ElementsAre("0", "1", "2b"));
}

/// As "time part file" for each entry.
std::vector<std::string> parts_in(const std::filesystem::path& path) {
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
    vtkXMLDataElement* collection = root->FindNestedElementWithName("Collection");
    std::vector<std::string> entries;
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* e = collection->GetNestedElement(i);
        entries.push_back(std::string(e->GetAttribute("timestep")) + ' ' + e->GetAttribute("part") + ' ' +
                          e->GetAttribute("name") + ' ' + e->GetAttribute("file"));
    }
    return entries;
}

TEST(Pvd, PartsAtEachTimeAreTheLatestOfEachSeries) {
    TemporaryFolder folder;
    const PvdSeries particles{"particles.pvd", {{0, "p0"}, {1, "p1"}, {2, "p2"}}};
    const PvdSeries grid{"grid.pvd", {{0, "g0"}, {2, "g1"}}};
    const PvdSeries contact{"contact.pvd", {{1.5, "c0"}}};
    write_parts(folder / "all.pvd", {{"particles", &particles}, {"grid", &grid}, {"contact", &contact}});
    EXPECT_THAT(parts_in(folder / "all.pvd"),
                ElementsAre("0 0 particles p0", "0 1 grid g0", "1 0 particles p1", "1 1 grid g0", "1.5 0 particles p1",
                            "1.5 1 grid g0", "1.5 2 contact c0", "2 0 particles p2", "2 1 grid g1", "2 2 contact c0"));
}

TEST(Pvd, BrokenFileIsReported) {
    TemporaryFolder folder;
    std::ofstream(folder / "p.pvd") << "<VTKFile><Collection>";
    testing::internal::CaptureStderr();
    EXPECT_THAT(error_of([&] { read_pvd(folder / "p.pvd"); }), HasSubstr("p.pvd: cannot read"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_THAT(error_of([&] { read_pvd(folder / "q.pvd"); }), HasSubstr("q.pvd: no such file"));
}

// === Result folder

void touch(const fs::path& path) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "x";
}

TEST(ResultFolder, IsKeptByOneRunAtATime) {
    TemporaryFolder folder;
    std::optional<FolderLock> first(prepare_result_folder(folder / "r", false));
    EXPECT_THAT(error_of([&] { FolderLock second(folder / "r"); }), HasSubstr("another run writes to this folder"));
    EXPECT_THAT(error_of([&] { prepare_result_folder(folder / "r", true); }), HasSubstr("another run writes"));
    FolderLock moved = std::move(*first);
    first.reset();
    EXPECT_THAT(error_of([&] { FolderLock second(folder / "r"); }), HasSubstr("another run writes to this folder"));
    moved = FolderLock();
    EXPECT_NO_THROW(FolderLock(folder / "r"));
}

TEST(ResultFolder, NewAndEmptyFoldersAreTaken) {
    TemporaryFolder folder;
    prepare_result_folder(folder / "a/b", false);
    EXPECT_TRUE(fs::is_empty(folder / "a/b"));
    prepare_result_folder(folder / "a/b", false);
}

TEST(ResultFolder, ResultsAreRefusedUnlessOverwritten) {
    for (const char* mark : {"history.csv", "scene.json", "grid.pvd"}) {
        TemporaryFolder folder;
        touch(folder / mark);
        EXPECT_THAT(error_of([&] { prepare_result_folder(folder.path, false); }), HasSubstr("holds results already"));
        EXPECT_TRUE(fs::exists(folder / mark));
        prepare_result_folder(folder.path, true);
        EXPECT_FALSE(fs::exists(folder / mark));
    }
}

TEST(ResultFolder, OnlyOwnFilesAreRemoved) {
    TemporaryFolder folder;
    for (const char* name : {"history.csv", "bodies.csv", "particles.pvd", "particles/particles_00000.vtu",
                             "particles/.particles_00001.vtu.tmp", "checkpoint.h5", "contact/contact_00003.vtp"})
        touch(folder / name);
    const std::vector<std::string> others{"notes.txt", "particles/mine.vtu", "particles/particles_x.vtu", "my.pvd",
                                          "frames/a.png"};
    for (const std::string& name : others) touch(folder / name);
    prepare_result_folder(folder.path, true);
    for (const std::string& name : others) EXPECT_TRUE(fs::exists(folder / name)) << name;
    EXPECT_EQ(folder.count(), 4u); // notes.txt, particles/, my.pvd, frames/
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "particles"), {}), 2);
}

TEST(ResultFolder, ForeignFolderIsRefused) {
    TemporaryFolder folder;
    touch(folder / "thesis.tex");
    EXPECT_THAT(error_of([&] { prepare_result_folder(folder.path, false); }), HasSubstr("is not empty"));
    prepare_result_folder(folder.path, true);
    EXPECT_TRUE(fs::exists(folder / "thesis.tex"));
    EXPECT_THAT(error_of([&] { prepare_result_folder(folder / "thesis.tex", true); }), HasSubstr("is a file"));
}

TEST(ResultFolder, TheSceneOfTheRunIsNeverReplaced) {
    TemporaryFolder folder;
    touch(folder / "scene.json");
    touch(folder / "history.csv");
    EXPECT_THAT(error_of([&] { prepare_result_folder(folder.path, true, {folder / "scene.json"}); }),
                HasSubstr("choose another folder"));
    EXPECT_EQ(folder.count(), 2u);
}

TEST(ResultFolder, FolderThatCannotBeWrittenIsReported) {
    EXPECT_THAT(error_of([] { prepare_result_folder("/proc/abut", false); }), HasSubstr("/proc/abut"));
}

} // namespace
} // namespace abut::test

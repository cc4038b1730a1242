// Tables read back: against CsvTable bit for bit, and files that are broken.
#include "io/results/csv.h"
#include "io/results/read_csv.h"
#include "results_support.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gmock/gmock.h>
#include <limits>
#include <random>

namespace abut::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CsvFile read_of(const TemporaryFolder& folder, const std::string& text, const std::vector<std::string>& words = {}) {
    std::ofstream(folder / "t.csv", std::ios::binary) << text;
    return read_csv(folder / "t.csv", words);
}

TEST(ReadCsv, NumbersComeBackWithTheSameBits) {
    using Limits = std::numeric_limits<double>;
    std::vector<double> values{0.0,
                               -0.0,
                               0.1,
                               1e22,
                               1e23,
                               5e-324,
                               -Limits::denorm_min() * 12345,
                               Limits::min(),
                               Limits::max(),
                               Limits::lowest(),
                               Limits::infinity(),
                               -Limits::infinity(),
                               Limits::quiet_NaN(),
                               -Limits::quiet_NaN()};
    std::mt19937_64 random(1);
    while (values.size() < 5000) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isnan(value)) values.push_back(value);
    }
    const TemporaryFolder folder;
    {
        CsvTable table(folder / "t.csv", {"row", "value"});
        for (std::size_t i = 0; i < values.size(); ++i) table.row({static_cast<std::int64_t>(i), values[i]});
    }
    const CsvFile back = read_csv(folder / "t.csv");
    ASSERT_EQ(back.rows, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(back.columns[0].numbers[i], static_cast<double>(i));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back.columns[1].numbers[i]), std::bit_cast<std::uint64_t>(values[i]))
            << i;
    }
}

TEST(ReadCsv, WordsComeBackWhateverIsInThem) {
    const std::vector<std::string> words{"block", "", "a \"quoted\", one", "Körner & <more>", "two\nlines", "1e5", ","};
    const TemporaryFolder folder;
    {
        CsvTable table(folder / "t.csv", {"body", "mass, \"kg\""});
        for (const std::string& word : words) table.row({std::string_view(word), 1.5});
    }
    const CsvFile back = read_csv(folder / "t.csv", {"body"});
    EXPECT_EQ(back.columns[0].words, words);
    EXPECT_THAT(back.names(), ElementsAre("body", "mass, \"kg\""));
    EXPECT_EQ(back.find("mass, \"kg\"")->numbers, std::vector<double>(words.size(), 1.5));
    EXPECT_EQ(back.find("mass"), nullptr);
}

TEST(ReadCsv, OnlyWholeRowsCount) {
    const TemporaryFolder folder;
    const std::string text = "step,time\n1,0.5\n22,0.75\n";
    EXPECT_EQ(read_of(folder, text).rows, 2U);
    for (std::size_t size = 10; size < text.size(); ++size) { // as a run under way leaves it, cut anywhere
        const CsvFile table = read_of(folder, text.substr(0, size));
        EXPECT_EQ(table.rows, size < 16 ? 0U : 1U) << size;
        EXPECT_EQ(table.columns.size(), 2U);
    }
    EXPECT_EQ(read_of(folder, "a,b\r\n1,2\r\n").columns[1].numbers, std::vector<double>{2});
    EXPECT_EQ(read_of(folder, "a\n1\n\"x\nyz", {"a"}).rows, 1U);
}

TEST(ReadCsv, AFullDiskLeavesWholeRows) {
    const TemporaryFolder folder;
    for (const std::size_t limit : {100U, 1003U, 5000U}) {
        CsvTable table(folder / "t.csv", {"row", "value"});
        std::string error;
        {
            const DiskLimit full(limit);
            error = error_of([&] {
                for (int i = 0;; ++i) {
                    for (int k = 0; k < 3; ++k) table.row({i, i / 7.0}); // reach the file together
                    table.flush();
                }
            });
        }
        EXPECT_THAT(error, HasSubstr("t.csv: cannot write: File too large"));
        const std::string text = read_text(folder / "t.csv");
        EXPECT_EQ(text.back(), '\n');
        EXPECT_LE(text.size(), limit);
        EXPECT_GT(text.size() + 100, limit);
        const CsvFile back = read_csv(folder / "t.csv");
        EXPECT_EQ(back.rows % 3, 0U);
        EXPECT_EQ(back.columns[1].numbers.back(), static_cast<double>(back.rows / 3 - 1) / 7.0);
    }
}

TEST(ReadCsv, ErrorsNameFileLineAndCause) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& text) { return error_of([&] { read_of(folder, text); }); };
    EXPECT_THAT(error("a,b\n1,2\n3\n"), HasSubstr("t.csv: line 3: 1 values for 2 columns"));
    EXPECT_THAT(error("a,b\n1,2\n3,4,5\n"), HasSubstr("t.csv: line 3: 3 values for 2 columns"));
    EXPECT_THAT(error("a,b\n1,2\n\n"), HasSubstr("line 3: 1 values for 2 columns"));
    EXPECT_THAT(error("a,b\n1,2\n\n3,4\n"), HasSubstr("line 3"));
    for (const std::string cell : {"", "x", "1.5 J", "1,", "0x10", "1e", "--1", " 1", "+1"})
        EXPECT_THAT(error("a\n" + cell + "\n"), HasSubstr("t.csv: line 2")) << cell;
    EXPECT_THAT(error("a,b\n1,4 N\n"), HasSubstr("column \"b\": \"4 N\" is no number"));
    EXPECT_THAT(error("a,b\n1,\x01\n"), HasSubstr("\"?\" is no number"));
    EXPECT_THAT(error("a,b,a\n"), HasSubstr("line 1: two columns \"a\""));
    EXPECT_THAT(error(""), HasSubstr("t.csv: cannot read: there is no whole row of names"));
    EXPECT_THAT(error("step,time"), HasSubstr("no whole row of names"));
    EXPECT_THAT(error_of([&] { read_csv(folder / "none.csv"); }),
                HasSubstr("none.csv: cannot read: No such file or directory"));
    EXPECT_THAT(error_of([&] { read_csv(folder.path); }), HasSubstr("it is a folder"));
}

} // namespace
} // namespace abut::test

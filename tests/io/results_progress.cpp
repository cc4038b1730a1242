#include "io/results/progress.h"
#include "io/results/si_prefix.h"
#include "results_support.h"

#include <gmock/gmock.h>
#include <thread>

namespace abut::test {
namespace {

using testing::HasSubstr;

TEST(SiPrefix, BringsMagnitudesBetweenOneAndThousand) {
    EXPECT_EQ(si_prefix(78.09e9).symbol, "G");
    EXPECT_EQ(si_prefix(-3e-6).symbol, "u");
    EXPECT_EQ(si_prefix(0.999999999999e-6).symbol, "u");
    EXPECT_EQ(si_prefix(0).symbol, "");
    EXPECT_EQ(si_prefix(999).factor, 1);
    EXPECT_EQ(format_time(3.42e-6), "3.42 us");
    EXPECT_EQ(format_time(0), "0 s");
    EXPECT_EQ(format_time(4000), "4000 s");
    EXPECT_EQ(format_time_of(3.42e-6, 15e-6), "3.42 us of 15 us");
    EXPECT_EQ(format_time_of(0, 15e-6), "0.00 us of 15 us");
}

/// What a progress of `steps` steps of a microsecond prints.
std::string printed(ProgressMode mode, int steps, int pause_ms) {
    TemporaryFolder folder;
    std::FILE* out = std::fopen((folder / "out").c_str(), "w");
    {
        Progress progress(mode, 15e-6, out);
        for (int i = 0; i <= steps; ++i) {
            progress.update(i, i * 1e-6);
            if (i == 5) progress.note("wrote 3 files");
            std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
        }
        if (steps == 15) progress.finish();
    }
    std::fclose(out);
    return read_text(folder / "out");
}

TEST(Progress, QuietSaysNothing) {
    EXPECT_EQ(printed(ProgressMode::quiet, 15, 0), "");
}

TEST(Progress, LinesWhereThereIsNoTerminal) {
    const std::string text = printed(ProgressMode::automatic, 15, 0);
    EXPECT_THAT(text, HasSubstr(" 33 %  5.00 us of 15 us  step 5  wrote 3 files\n"));
    EXPECT_THAT(text, HasSubstr("15 steps in "));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

TEST(Progress, BarIsRedrawnAtMostTenTimesASecond) {
    const std::string text = printed(ProgressMode::bar, 15, 20); // 0.3 s
    const auto redraws = std::count(text.begin(), text.end(), '\r');
    EXPECT_GE(redraws, 3);
    EXPECT_LE(redraws, 8);
    EXPECT_THAT(text, HasSubstr("100 %  15.00 us of 15 us"));
    EXPECT_THAT(text, HasSubstr("\n15 steps in "));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3); // note, bar, summary
}

TEST(Progress, UnfinishedBarEndsItsLine) {
    const std::string text = printed(ProgressMode::bar, 8, 0);
    EXPECT_EQ(text.back(), '\n');
}

} // namespace
} // namespace abut::test

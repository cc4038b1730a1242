#pragma once
/// Time and memory that reading a file takes.

#include "sanitizer_memory.h"
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

namespace test {

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

/// How much more memory this process has had since the object was made than it had then. What earlier tests needed at
/// most doesn't hide it: Linux forgets the peak when asked to.
class MemoryGrowth {
public:
    MemoryGrowth() {
        std::ofstream("/proc/self/clear_refs") << "5";
        start_ = peak();
    }
    long mebibytes() const { return peak() - start_; }

private:
    long start_ = 0;
    static long peak() {
        std::ifstream status("/proc/self/status");
        for (std::string line; std::getline(status, line);)
            if (line.starts_with("VmHWM:")) return std::stol(line.substr(6)) / 1024;
        throw std::runtime_error("no VmHWM");
    }
};

constexpr long most_growth = 100 + sanitizer_keeps; ///< [MiB] over thousands of files

/// Reads a file that lies about itself; it must be refused without work or memory.
inline void expect_refused_at_once(const std::filesystem::path& file, const std::string& reason) {
    const MemoryGrowth growth;
    const Stopwatch watch;
    testing::internal::CaptureStderr();
    EXPECT_THAT(message_of([&] {
                    const int slices = abut::read_stack_info(file).slices;
                    abut::read_stack(file, 0, std::min(slices - 1, 3), [](int, const abut::Image&) {});
                }),
                testing::HasSubstr(reason))
        << file;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_LT(watch.seconds(), 0.5) << file;
    EXPECT_LT(growth.mebibytes(), 20) << file;
}

} // namespace test

// Work that is shared among processes.
#include "io/render/workers.h"
#include "results_support.h"

#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <unistd.h>

namespace abut::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(RenderWorkers, EachCallIsMadeOnce) {
    for (const int jobs : {1, 2, 5, 40}) {
        TemporaryFolder folder;
        std::vector<int> told;
        share_work(
            23, jobs,
            [&](int i) { // appends: a second call would show
                std::ofstream(folder / std::to_string(i), std::ios::app) << getpid() << '\n';
            },
            [&](int n) { told.push_back(n); });
        int files = 0;
        for (const auto& entry : fs::directory_iterator(folder.path)) {
            std::ifstream file(entry.path());
            int process = 0, lines = 0;
            for (; file >> process; ++lines) EXPECT_EQ(process == getpid(), jobs == 1);
            EXPECT_EQ(lines, 1) << entry.path();
            ++files;
        }
        EXPECT_EQ(files, 23);
        ASSERT_EQ(told.size(), 23u);
        for (int i = 0; i < 23; ++i) EXPECT_EQ(told[static_cast<std::size_t>(i)], i + 1);
    }
}

TEST(RenderWorkers, WhatAWorkerThrowsArrives) {
    for (const int jobs : {1, 3}) {
        const auto work = [](int i) {
            if (i == 4) throw std::runtime_error("particles_00004.vtu: broken");
        };
        EXPECT_EQ(error_of([&] { share_work(9, jobs, work, [](int) {}); }), "particles_00004.vtu: broken");
    }
    EXPECT_THAT(error_of([&] {
                    share_work(
                        9, 3, [](int) { throw std::runtime_error(std::string(100000, 'x')); }, [](int) {});
                }),
                HasSubstr("xxxx"));
}

TEST(RenderWorkers, AWorkerThatDiesIsReported) {
    const auto die = [](int i) {
        if (i == 2) raise(SIGKILL);
    };
    EXPECT_THAT(error_of([&] { share_work(6, 2, die, [](int) {}); }), HasSubstr("signal 9"));
}

TEST(RenderWorkers, NothingToDoIsDone) {
    int calls = 0;
    share_work(
        0, 4, [&](int) { ++calls; }, [&](int) { ++calls; });
    EXPECT_EQ(calls, 0);
}

} // namespace
} // namespace abut::test

#pragma once
/// \file results_support.h
/// A folder of its own for each test, and small frames.

#include "results/frame.h"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace abut::test {

/// An empty folder that is removed with the test.
struct TemporaryFolder {
    std::filesystem::path path;

    TemporaryFolder() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        path = std::filesystem::temp_directory_path() /
               ("abut-" + std::to_string(::getpid()) + "-" + info->test_suite_name() + "-" + info->name());
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path); }

    std::filesystem::path operator/(const std::string& name) const { return path / name; }
    /// Everything in the folder, also hidden.
    std::size_t count() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path), {}));
    }
};

/// While it lives, no file of this process can grow beyond `bytes`: a disk that is full, for tests.
struct DiskLimit {
    rlimit before{};
    explicit DiskLimit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN); // write() then fails with EFBIG
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit limit{bytes, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~DiskLimit() { setrlimit(RLIMIT_FSIZE, &before); }
};

inline std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The message of the std::runtime_error that `call` throws; a failure of the test if it throws none.
template <class Call>
std::string error_of(Call&& call) {
    try {
        call();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no exception";
    return {};
}

/// A frame of `count` points with a real vector, an integer array, a number and names.
inline PointFrame sample_frame(int count) {
    PointFrame frame;
    frame.time = 3.42e-6;
    std::vector<double> velocity;
    std::vector<std::int32_t> body;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < 3; ++k) {
            frame.points.push_back(1e-3 / (1 + i + 7 * k)); // all bits of the mantissa in use
            velocity.push_back(-1e2 / (3 + i + k));
        }
        body.push_back(i % 5 - 1);
    }
    frame.arrays = {{"velocity", 3, velocity}, {"body", 1, body}};
    frame.globals = {{"grid_spacing", 3, std::vector<double>{1e-5, 2e-5, 3e-5}}};
    frame.words = {{"body_names", {"block", "grain \"1\" & <more>", "Körner"}}};
    return frame;
}

} // namespace abut::test

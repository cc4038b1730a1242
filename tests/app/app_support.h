#pragma once
/// \file app_support.h
/// Runs the real program in a folder of its own, and looks at what it leaves there.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace abut::app_test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/// How the program ended and what it said.
struct Outcome {
    int exit_code = -1; ///< 128 + the signal's number for a program that a signal ended
    std::string out, err;
};

/// An empty folder that is removed with the test; the program is run in it.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    /// All files and folders below, hidden ones too, with the size of each.
    std::map<std::string, std::uintmax_t> content() const;

    /// Runs `abut ARGUMENTS` and waits for its end. \param largest_file bytes that a file may have; 0: no limit
    Outcome abut(const Arguments& arguments, std::size_t largest_file = 0) const;
    /// Starts `abut ARGUMENTS`; end_of() waits for its end.
    pid_t start(const Arguments& arguments, std::size_t largest_file = 0) const;
    Outcome end_of(pid_t process) const;

private:
    std::filesystem::path path_;
    std::filesystem::path said_; ///< where the program's output goes: beside the folder, not in it
};

/// A scene that runs in a tenth of a second: a disk hits a block on the floor, with friction.
Json small_scene();

/// small_scene() with RFC 7396 merge patches applied in their order.
Json small_scene(const std::vector<std::string>& patches);

/// The lines of a text.
std::vector<std::string> lines(const std::string& text);

/// The cells of a CSV file without quoted cells, its header first.
std::vector<std::vector<std::string>> table(const std::string& csv);

/// All result files with their bytes, the checkpoint too, but those that tell of the run and not of its results.
std::map<std::string, std::string> results_in(const Folder& folder, const std::string& results);

/// Expects the same of two result folders, `what` being said otherwise.
void expect_same_results(const Folder& folder, const std::string& a, const std::string& b, const std::string& what);

} // namespace abut::app_test

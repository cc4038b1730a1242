#include "io/results/result_folder.h"

#include "io/results/output_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace abut {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> series{"particles", "grid", "contact"};
constexpr std::array<std::string_view, 10> single_files{"history.csv",      "bodies.csv", "pairs.csv",
                                                        "timing.json",      "scene.json", "checkpoint.h5",
                                                        "all.pvd",          "live.png",   "checkpoint-previous.h5",
                                                        "checkpoint-new.h5"};

/// particles_00012.vtu of "particles", or what a killed run left of writing it (.particles_00012.vtu.tmp); also the
/// states that a run which went wrong leaves, failed.vtu and last_good.vtu
bool is_frame(std::string name, std::string_view series_name) {
    if (name.starts_with('.') && name.ends_with(".tmp")) name = name.substr(1, name.size() - 5);
    if (name == "failed.vtu" || name == "last_good.vtu") return true;
    if (!name.starts_with(series_name) || name.size() <= series_name.size() || name[series_name.size()] != '_')
        return false;
    const std::string_view rest = std::string_view(name).substr(series_name.size() + 1);
    const auto digits = static_cast<std::size_t>(
        std::find_if_not(rest.begin(), rest.end(), [](unsigned char c) { return std::isdigit(c); }) - rest.begin());
    const std::string_view extension = rest.substr(digits);
    return digits > 0 && (extension == ".vtu" || extension == ".vti" || extension == ".vtp");
}

/// Whether a text is groups of digits with "_" between, a minus before any: "00012_7_-1".
bool is_numbers(std::string_view text) {
    bool digit = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool starts = i == 0 || text[i - 1] == '_';
        if (std::isdigit(static_cast<unsigned char>(text[i])))
            digit = true;
        else if ((text[i] == '_' && digit) || (text[i] == '-' && starts))
            digit = false;
        else
            return false;
    }
    return digit;
}

/// cloud_00012_7_3.vtu and the like, the series of them, or what a killed run left of writing one
/// (write_contact_clouds.h).
bool is_cloud_file(std::string name) {
    if (name.starts_with('.') && name.ends_with(".tmp")) name = name.substr(1, name.size() - 5);
    for (const auto& [kind, extension] : {std::pair<std::string_view, std::string_view>{"cloud_", ".vtu"},
                                          {"plane_", ".vtp"},
                                          {"node_", ".csv"},
                                          {"cloud_", ".pvd"},
                                          {"plane_", ".pvd"}}) {
        if (!name.starts_with(kind) || !name.ends_with(extension) || name.size() <= kind.size() + extension.size())
            continue;
        std::string_view rest(name);
        rest = rest.substr(kind.size(), name.size() - kind.size() - extension.size());
        if (extension == ".pvd" && rest == "disagreement") return true;
        if (extension == ".pvd" && rest.starts_with("near_")) rest.remove_prefix(5);
        if (is_numbers(rest)) return true;
    }
    return false;
}

std::vector<fs::path> own_files(const fs::path& folder) {
    std::vector<fs::path> found;
    const auto add_with_leftover = [&](const std::string& name) {
        for (const fs::path& path : {folder / name, folder / ("." + name + ".tmp")})
            if (fs::is_regular_file(path)) found.push_back(path);
    };
    for (const std::string_view name : single_files) add_with_leftover(std::string(name));
    for (const std::string_view name : series) {
        add_with_leftover(std::string(name) + ".pvd");
        if (!fs::is_directory(folder / name)) continue;
        for (const auto& entry : fs::directory_iterator(folder / name))
            if (entry.is_regular_file() && is_frame(entry.path().filename().string(), name))
                found.push_back(entry.path());
    }
    if (fs::is_directory(folder / "frames")) // pictures of these results, by `abut render`
        for (const auto& entry : fs::recursive_directory_iterator(folder / "frames"))
            if (const std::string name = entry.path().filename().string();
                entry.is_regular_file() && name.starts_with("frame_") && name.ends_with(".png"))
                found.push_back(entry.path());
    if (fs::is_directory(folder / "clouds"))
        for (const auto& entry : fs::directory_iterator(folder / "clouds"))
            if (entry.is_regular_file() && is_cloud_file(entry.path().filename().string()))
                found.push_back(entry.path());
    return found;
}

bool is_result_folder(const fs::path& folder) {
    if (fs::exists(folder / "history.csv") || fs::exists(folder / "scene.json")) return true;
    return std::any_of(fs::directory_iterator(folder), {},
                       [](const auto& entry) { return entry.path().extension() == ".pvd"; });
}

void remove_own_files(const fs::path& folder, const std::vector<fs::path>& inputs) {
    const auto files = own_files(folder);
    for (const fs::path& file : files)
        for (const fs::path& input : inputs)
            if (fs::exists(input) && fs::equivalent(file, input))
                throw std::runtime_error(
                    fmt::format("{}: this run reads {} and would replace it; choose another folder "
                                "for the results",
                                folder.string(), input.string()));
    for (const fs::path& file : files) fs::remove(file);
    for (const std::string_view name : {series[0], series[1], series[2], std::string_view("clouds")}) {
        const fs::path sub = folder / name;
        if (fs::is_directory(sub) && fs::is_empty(sub)) fs::remove(sub);
    }
}

} // namespace

FolderLock::FolderLock(const fs::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    // Some network file systems have no locks for folders: there runs are not kept apart.
    if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(std::exchange(descriptor_, -1));
    throw std::runtime_error(folder.string() +
                             ": another run writes to this folder (or was stopped by Ctrl-Z); wait for "
                             "its end, or name another folder");
}

FolderLock::FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

FolderLock prepare_result_folder(const fs::path& folder, bool overwrite, const std::vector<fs::path>& inputs) {
    try {
        if (fs::exists(folder) && !fs::is_directory(folder))
            throw std::runtime_error(folder.string() + ": is a file; name a folder for the results");
        fs::create_directories(folder);
        FolderLock lock(folder);
        if (!fs::is_empty(folder) && !overwrite)
            throw std::runtime_error(
                folder.string() +
                (is_result_folder(folder)
                     ? ": holds results already; use --overwrite to replace them"
                     : ": is not empty; name another folder, or use --overwrite to write beside its files"));
        // A folder that cannot be written to is found out now, not after the first hour.
        const fs::path probe = folder / ".abut-write-test";
        OutputFile(probe, folder).close();
        fs::remove(probe);
        if (!fs::is_empty(folder)) remove_own_files(folder, inputs);
        return lock;
    } catch (const fs::filesystem_error& error) {
        throw std::runtime_error(fmt::format("{}: {}", error.path1().string(), error.code().message()));
    }
}

} // namespace abut

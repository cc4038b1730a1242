#include "geometry/images/numbered_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace abut {

namespace {

struct Numbered {
    std::uint64_t number = 0;
    std::filesystem::path file;
    std::string name() const { return file.filename().string(); }
};

bool all_digits(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::uint64_t number_of(std::string_view digits, const std::string& name) {
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    if (digits.size() > 18)
        throw std::runtime_error(fmt::format("matches \"{}\", whose number is too large; rename the files", name));
    return digits.empty() ? 0 : std::stoull(std::string(digits));
}

std::vector<Numbered> matching(const std::filesystem::path& folder, std::string_view before, std::string_view after) {
    std::vector<Numbered> found;
    std::error_code error;
    std::filesystem::directory_iterator entries(folder.empty() ? "." : folder, error);
    if (error) throw std::runtime_error("is in a folder that does not exist or cannot be read");
    for (const std::filesystem::directory_entry& entry : entries) {
        const std::string name = entry.path().filename().string();
        const std::string_view text = name;
        if (text.size() <= before.size() + after.size() || !text.starts_with(before) || !text.ends_with(after))
            continue;
        const std::string_view digits = text.substr(before.size(), text.size() - before.size() - after.size());
        if (all_digits(digits)) found.push_back({number_of(digits, name), folder / name});
    }
    std::sort(found.begin(), found.end(), [](const Numbered& a, const Numbered& b) {
        return a.number != b.number ? a.number < b.number : a.file < b.file;
    });
    return found;
}

/// Names of the folder that come near to a pattern which matches none, to show the slip: another extension, capitals.
std::string near_matches(const std::filesystem::path& folder, const std::string& before, const std::string& after) {
    const auto lower = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
        return text;
    };
    const std::string start = lower(before), end = lower(after);
    std::array<std::vector<std::string>, 3> names; // nearest first
    std::error_code error;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::directory_iterator(folder.empty() ? "." : folder, error)) {
        const std::string name = entry.path().filename().string(), text = lower(name);
        const bool starts = text.starts_with(start), ends = text.ends_with(end);
        if (starts && ends)
            names[0].push_back(name);
        else if (starts && !start.empty())
            names[1].push_back(name);
        else if (ends && !end.empty())
            names[2].push_back(name);
    }
    constexpr std::size_t most_shown = 3;
    for (std::vector<std::string>& near : names) {
        if (near.empty()) continue;
        std::sort(near.begin(), near.end());
        const std::size_t shown = std::min(near.size(), most_shown);
        const std::string more = near.size() > shown ? fmt::format(" and {} more", near.size() - shown) : "";
        near.resize(shown);
        return fmt::format("; the folder has {}{}", fmt::join(near, ", "), more);
    }
    return "; the folder has none that comes near";
}

} // namespace

bool has_star(const std::filesystem::path& file) {
    return file.string().find('*') != std::string::npos;
}

std::vector<std::filesystem::path> numbered_files(const std::filesystem::path& pattern) {
    const std::string name = pattern.filename().string();
    const std::size_t star = name.find('*');
    if (star == std::string::npos || has_star(pattern.parent_path()) || name.find('*', star + 1) != std::string::npos)
        throw std::runtime_error("must have a single \"*\", in the name of the file and not in its folder");
    const std::string before = name.substr(0, star), after = name.substr(star + 1);
    const std::vector<Numbered> found = matching(pattern.parent_path(), before, after);
    if (found.empty())
        throw std::runtime_error("matches no file (\"*\" stands for digits only)" +
                                 near_matches(pattern.parent_path(), before, after));
    std::vector<std::filesystem::path> files;
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (k > 0 && found[k].number == found[k - 1].number)
            throw std::runtime_error(fmt::format("matches two files with the number {}: {} and {}", found[k].number,
                                                 found[k - 1].name(), found[k].name()));
        if (k > 0 && found[k].number != found[k - 1].number + 1)
            throw std::runtime_error(fmt::format("lacks files: slice {} is missing between {} and {}",
                                                 found[k - 1].number + 1, found[k - 1].name(), found[k].name()));
        files.push_back(found[k].file);
    }
    return files;
}

} // namespace abut

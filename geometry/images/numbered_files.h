#pragma once
/// \file numbered_files.h
/// Files of a folder that are the slices of a stack: "ct_*.png" is ct_0001.png, ct_0002.png, …

#include <filesystem>
#include <vector>

namespace abut {

/// Whether a name stands for numbered files.
bool has_star(const std::filesystem::path& file);

/// The files in the order of their numbers, which follow each other without gaps.
/// \param pattern with one "*" in the file's name, which stands for one digit or more
/// \throws std::runtime_error whose message continues `image "PATTERN" ...`: no file matches (names those that come
/// near), a number is missing (names it), two files have the same number
std::vector<std::filesystem::path> numbered_files(const std::filesystem::path& pattern);

} // namespace abut

#pragma once
/// \file checksum.h
/// Checksums that tell whether something has changed.

#include <filesystem>
#include <string>
#include <string_view>

namespace abut {

/// 16 hexadecimal digits of the bytes (FNV-1a, 64 bits; no protection against intent).
std::string checksum_of(std::string_view bytes);

/// The same of a file's content. Throws std::runtime_error naming the file if it can't be read.
std::string checksum_of_file(const std::filesystem::path& file);

} // namespace abut

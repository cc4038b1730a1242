#pragma once
/// \file write_text.h
/// Small files in one go: JSON, PNG, .pvd.

#include <filesystem>
#include <string_view>

namespace abut {

/// Writes `text` (any bytes) to `path`, replacing the whole file at once: it appears complete or not at all. A device
/// or a pipe (/dev/stdout) is written to directly. Throws std::runtime_error naming the file and the cause.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

} // namespace abut

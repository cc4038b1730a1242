#pragma once
/// \file output_file.h
/// Files that are written completely or reported: an unbuffered output file, and the replacement of a whole file.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace abut {

/// A file open for writing, from its beginning. Nothing is buffered here: what `write` accepted survives a killed
/// program. Every failure throws std::runtime_error "FILE: cannot write: CAUSE".
class OutputFile {
public:
    /// Creates or empties `path`. Messages name `shown` instead, if given.
    explicit OutputFile(const std::filesystem::path& path, const std::filesystem::path& shown = {});
    /// Opens a file that is there to go on after its first `bytes`; the rest is cut off. A file that is missing or
    /// shorter is reported.
    static OutputFile continued(const std::filesystem::path& path, std::uintmax_t bytes);
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&& other) noexcept;
    ~OutputFile();

    /// Writes all of the bytes or none: a file on a full disk ends where the last whole write did.
    void write(std::string_view bytes);
    void sync();  ///< waits until the bytes are on the disk
    void close(); ///< reports what the destructor would swallow

private:
    OutputFile() = default;
    std::filesystem::path shown_;
    int descriptor_ = -1;
    std::size_t size_ = 0; ///< written so far [bytes]
};

/// Replaces `path` as a whole: `write` gets the name of an empty temporary file in the same folder and fills it; the
/// file is then synced to the disk and renamed. Whoever reads `path` at any moment sees the old file or the new one,
/// complete. On failure (also when `write` throws) the temporary file is removed and the old file stays.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& temporary)>& write);

} // namespace abut

#pragma once
/// \file one_file.h
/// The input of a fuzz target as a file in memory (/dev/shm), since readers take file names.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace fuzz {

/// A file of this process, replaced by each input.
class OneFile {
public:
    explicit OneFile(const std::string& extension)
        : path_("/dev/shm/abut-fuzz-" + std::to_string(getpid()) + extension) {}
    OneFile(const OneFile&) = delete;
    OneFile& operator=(const OneFile&) = delete;
    ~OneFile() {
        std::error_code gone;
        std::filesystem::remove(path_, gone);
    }

    const std::filesystem::path& holds(const std::uint8_t* data, std::size_t size) const {
        std::FILE* file = std::fopen(path_.c_str(), "wb");
        if (file == nullptr || std::fwrite(data, 1, size, file) != size) std::perror(path_.c_str());
        if (file != nullptr) std::fclose(file);
        return path_;
    }

private:
    std::filesystem::path path_;
};

/// Whether a message could help: it says something, and names the file.
inline void require_helpful(const std::string& message, const std::filesystem::path& file) {
    if (message.find(file.filename().string()) != std::string::npos) return;
    std::fprintf(stderr, "the message does not name the file: \"%s\"\n", message.c_str());
    __builtin_trap();
}

} // namespace fuzz

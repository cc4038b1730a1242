#pragma once
/// \file checksum.h
/// Checksums that tell whether something has changed; no protection against intent.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace abut {

/// FNV-1a, 64 bits (http://www.isthe.com/chongo/tech/comp/fnv).
class Checksum {
public:
    void add(std::string_view bytes) {
        for (const char byte : bytes) sum_ = (sum_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    std::uint64_t value() const { return sum_; }
    std::string text() const; ///< 16 hexadecimal digits

private:
    std::uint64_t sum_ = 0xcbf29ce484222325U;
};

/// The text of the bytes' checksum.
std::string checksum_of(std::string_view bytes);

/// The same of a file's content. Throws std::runtime_error naming the file if it can't be read.
std::string checksum_of_file(const std::filesystem::path& file);

} // namespace abut

#include "io/study/checksum.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace abut {

namespace {

/// http://www.isthe.com/chongo/tech/comp/fnv: the 64-bit variant 1a.
class Fnv {
public:
    void add(std::string_view bytes) {
        for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    std::string text() const { return fmt::format("{:016x}", hash_); }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325U;
};

} // namespace

std::string checksum_of(std::string_view bytes) {
    Fnv fnv;
    fnv.add(bytes);
    return fnv.text();
}

std::string checksum_of_file(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    Fnv fnv;
    std::vector<char> buffer(1 << 16);
    while (stream) {
        stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        fnv.add({buffer.data(), static_cast<std::size_t>(stream.gcount())});
    }
    if (!stream.eof())
        throw std::runtime_error(fmt::format("{}: cannot read: {}", file.string(), std::strerror(errno)));
    return fnv.text();
}

} // namespace abut

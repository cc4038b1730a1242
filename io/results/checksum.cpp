#include "io/results/checksum.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace abut {

std::string Checksum::text() const {
    return fmt::format("{:016x}", sum_);
}

std::string checksum_of(std::string_view bytes) {
    Checksum sum;
    sum.add(bytes);
    return sum.text();
}

std::string checksum_of_file(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    Checksum sum;
    std::vector<char> buffer(1 << 16);
    while (stream) {
        stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        sum.add({buffer.data(), static_cast<std::size_t>(stream.gcount())});
    }
    if (!stream.eof())
        throw std::runtime_error(fmt::format("{}: cannot read: {}", file.string(), std::strerror(errno)));
    return sum.text();
}

} // namespace abut

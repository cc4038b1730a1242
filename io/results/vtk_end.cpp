#include "io/results/vtk_end.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

namespace abut {

bool has_vtk_end(const std::filesystem::path& path) {
    constexpr std::string_view end = "</VTKFile>";
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto length = std::min<std::streamoff>(file.tellg(), 100);
    if (length < 0) return false;
    std::string tail(static_cast<std::size_t>(length), ' ');
    file.seekg(-length, std::ios::end);
    if (!file.read(tail.data(), length)) return false;
    tail.erase(tail.find_last_not_of(" \t\r\n") + 1);
    return std::string_view(tail).ends_with(end);
}

} // namespace abut

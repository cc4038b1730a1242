#include "io/study/variant_names.h"

#include "io/results/checksum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace abut {

std::string VariantNames::name(const std::vector<std::size_t>& levels) const {
    std::string text;
    for (std::size_t a = 0; a < levels.size(); ++a) {
        const Axis& axis = study_.axes[a];
        const std::string& level = axis.levels[levels[a]].name;
        // A bare number tells nothing.
        const bool bare = !level.empty() && std::all_of(level.begin(), level.end(), [](unsigned char c) {
            return std::isdigit(c) || c == '.' || c == '-' || c == '+' || c == 'e';
        });
        text += (a == 0 ? "" : ", ") + (bare ? axis.name + " " + level : level);
    }
    return text;
}

std::string VariantNames::folder(const std::string& name) {
    std::string file;
    for (const char c : name) {
        if (c == ',') continue;
        const bool plain =
            std::isalnum(static_cast<unsigned char>(c)) || std::string("._-+()").find(c) != std::string::npos;
        file += plain ? c : '_';
    }
    constexpr std::size_t longest = 100;
    if (file.size() > longest) file = file.substr(0, longest) + "-" + checksum_of(name).substr(0, 8);
    if (file.empty() || file[0] == '.' || file[0] == '-') file.insert(0, "_");
    std::string result = file;
    const auto lower = [](std::string text) { // two names that differ in case only share a file on some systems
        std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
        return text;
    };
    for (int i = 2; !taken_.insert(lower(result)).second; ++i) result = fmt::format("{}-{}", file, i);
    return result;
}

} // namespace abut

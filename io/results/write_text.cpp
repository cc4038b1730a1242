#include "io/results/write_text.h"

#include "io/results/output_file.h"

namespace abut {
namespace {

void write_whole(const std::filesystem::path& path, const std::filesystem::path& shown, std::string_view text) {
    OutputFile file(path, shown);
    file.write(text);
    file.close();
}

} // namespace

void write_text_atomically(const std::filesystem::path& path, std::string_view text) {
    std::error_code ignored;
    if (std::filesystem::is_other(path, ignored)) return write_whole(path, path, text);
    replace_file(path, [&](const auto& temporary) { write_whole(temporary, path, text); });
}

} // namespace abut

#include "geometry/shapes/path_file.h"

#include "geometry/shapes/svg.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace abut {

namespace {

constexpr std::uintmax_t largest_file = 64u << 20;

std::string text_of(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) throw std::runtime_error(error.message());
    if (size > largest_file) throw std::runtime_error("is larger than 64 MiB");
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) throw std::runtime_error("cannot be read");
    return text.str();
}

/// The numbers of a line; nothing if something in it is none.
std::vector<double> numbers_in(const std::string& line, bool& good) {
    std::vector<double> numbers;
    const char* at = line.data();
    const char* const end = at + line.size();
    good = true;
    while (true) {
        while (at != end && (std::isspace(static_cast<unsigned char>(*at)) || *at == ',' || *at == ';')) ++at;
        if (at == end) return numbers;
        if (*at == '+') ++at;
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        good = error == std::errc() &&
               (next == end || std::isspace(static_cast<unsigned char>(*next)) || *next == ',' || *next == ';');
        if (!good) return numbers;
        numbers.push_back(value);
        at = next;
    }
}

/// Whether a line may hold names of columns: a number with a slip of the pen is none.
bool is_header(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first != std::string::npos && (std::isalpha(static_cast<unsigned char>(line[first])) || line[first] == '"');
}

std::vector<Outline2D> read_csv(const std::string& text) {
    std::vector<Outline2D> outlines(1);
    std::istringstream lines(text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text); // byte order mark
    std::string line;
    bool any = false;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (const std::size_t comment = line.find('#'); comment != std::string::npos) {
            line.erase(comment);
            if (line.find_first_not_of(" \t\r") == std::string::npos) continue; // a comment ends no outline
        }
        bool good = false;
        const std::vector<double> numbers = numbers_in(line, good);
        if (good && numbers.empty()) { // a blank line
            if (!outlines.back().empty()) outlines.emplace_back();
            continue;
        }
        if (!good && !any && numbers.empty() && is_header(line)) {
            any = true;
            continue;
        }
        any = true;
        if (!good || numbers.size() != 2 || !std::isfinite(numbers[0]) || !std::isfinite(numbers[1]))
            throw std::runtime_error(
                fmt::format("line {}: two numbers are needed, not \"{}\"", number, line.substr(0, 40)));
        outlines.back().push_back({numbers[0], numbers[1]});
    }
    if (outlines.back().empty()) outlines.pop_back();
    return outlines;
}

} // namespace

std::vector<Outline2D> read_path_file(const std::filesystem::path& file) {
    try {
        const std::string text = text_of(file);
        const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
        const bool svg = first != std::string::npos && text[first] == '<';
        std::vector<Outline2D> outlines;
        for (const Outline2D& outline : svg ? svg_outlines(text) : read_csv(text))
            if (Outline2D clean = without_repeats(outline); !svg || clean.size() > 2)
                outlines.push_back(std::move(clean));
        if (outlines.empty()) throw std::runtime_error("has no outlines");
        return outlines;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("path \"{}\": {}", file.string(), error.what()));
    }
}

} // namespace abut

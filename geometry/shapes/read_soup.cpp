// STL, OFF and OBJ files, and which of the formats a file has. CGAL's own readers were not used: they allocate what a
// header claims, look up NaN in ordered maps, take indices beyond the points (OBJ), and can't say where a file is
// wrong.
#include "geometry/shapes/polygon_soup.h"
#include "geometry/shapes/text_scanner.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace abut {

namespace {

static_assert(std::endian::native == std::endian::little);

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

/// Bytes of a binary STL file by the count in its header.
std::uint64_t stl_size(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    return 84 + std::uint64_t{50} * count;
}

void add_corner(PolygonSoup& soup, long long index, const TextScanner& scanner) {
    if (index < 0 || index >= static_cast<long long>(soup.points.size()))
        scanner.fail(fmt::format("a face names point {} (from 0), but there are {} points", index, soup.points.size()));
    soup.corners.push_back(static_cast<int>(index));
}

void check_text_count(const TextScanner& scanner, long long count, std::size_t bytes_each, const std::string& noun) {
    if (count < 0 || static_cast<unsigned long long>(count) > scanner.left() / bytes_each ||
        count > std::numeric_limits<int>::max())
        scanner.fail(fmt::format("the file is said to have {} {}, but only {} bytes follow: it is cut off or damaged",
                                 count, noun, scanner.left()));
}

std::string read_bytes(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw std::runtime_error("there is no such file");
    if (!std::filesystem::is_regular_file(file, error)) throw std::runtime_error("is no file that can be read");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) throw std::runtime_error("can't be opened for reading");
    std::string bytes(size, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size) throw std::runtime_error("can't be read to its end");
    return bytes;
}

bool is_off_keyword(std::string_view word) {
    return word.size() >= 3 && word.size() <= 9 && word.substr(word.size() - 3) == "OFF" &&
           word.find_first_not_of("STCN4n") >= word.size() - 3;
}

PolygonSoup read_by_format(std::string_view bytes, const std::string& extension) {
    if (bytes.empty()) throw std::runtime_error("the file is empty");
    if (bytes.substr(0, 3) == "\xef\xbb\xbf") bytes.remove_prefix(3); // mark of UTF-8
    const std::string first_word(TextScanner(bytes, '#').word());
    const bool is_text = bytes.substr(0, 1024).find('\0') == std::string_view::npos;
    // Text never has the size of a binary file: four letters as its count would make that gigabytes.
    if (bytes.size() >= 84 && stl_size(bytes) == bytes.size()) return read_stl_binary(bytes);
    if (bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r") return read_ply(bytes);
    if (is_off_keyword(first_word)) return read_off(bytes);
    if (is_text && extension != ".obj" && lower_case(first_word) == "solid") return read_stl_text(bytes);
    if (extension == ".obj" && is_text) return read_obj(bytes);
    if (extension == ".off" && is_text) return read_off(bytes);
    if (extension == ".stl" && !is_text) return read_stl_binary(bytes); // says what is wrong with its size
    throw std::runtime_error("is no STL, OFF, PLY or OBJ file: its contents don't begin like one (OBJ files need .obj "
                             "as the end of their name)");
}

} // namespace

PolygonSoup read_stl_binary(std::string_view bytes) {
    if (bytes.size() < 84)
        throw std::runtime_error(fmt::format("a binary STL file has at least 84 bytes, this one has {}", bytes.size()));
    if (stl_size(bytes) != bytes.size())
        throw std::runtime_error(fmt::format(
            "the header says that there are {} triangles, which take {} bytes, but the file has {}: it is cut "
            "off or damaged",
            (stl_size(bytes) - 84) / 50, stl_size(bytes), bytes.size()));
    const std::size_t count = (bytes.size() - 84) / 50;
    if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 3)
        throw std::runtime_error("has too many triangles");
    PolygonSoup soup;
    soup.points.reserve(3 * count);
    soup.corners.reserve(3 * count);
    soup.ends.reserve(count);
    for (std::size_t face = 0; face < count; ++face) {
        std::array<float, 9> x{};
        std::memcpy(x.data(), bytes.data() + 84 + 50 * face + 12, sizeof x);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            soup.corners.push_back(static_cast<int>(soup.points.size()));
            soup.points.push_back({x[3 * corner], x[3 * corner + 1], x[3 * corner + 2]});
        }
        soup.ends.push_back(soup.corners.size());
    }
    return soup;
}

PolygonSoup read_stl_text(std::string_view bytes) {
    PolygonSoup soup;
    TextScanner scanner(bytes);
    bool in_solid = false;
    const auto cut_off = [&] { scanner.fail("the file ends before \"endsolid\": it seems to be cut off"); };
    for (;;) {
        const std::string word = lower_case(scanner.word());
        if (word.empty()) break;
        if (word == "solid" || word == "endsolid") {
            in_solid = word == "solid";
            scanner.next_line(); // the rest of the line is its name
            continue;
        }
        if (word != "facet")
            scanner.fail(fmt::format("\"facet\" or \"endsolid\" expected, not \"{}\"", TextScanner::shown(word)));
        scanner.next_line(); // normals are what the corners say
        if (lower_case(scanner.word()) != "outer" || lower_case(scanner.word()) != "loop")
            scanner.left() == 0 ? cut_off() : scanner.fail("\"outer loop\" expected");
        for (;;) {
            const std::string item = lower_case(scanner.word());
            if (item == "endloop") break;
            if (item.empty()) cut_off();
            if (item != "vertex")
                scanner.fail(fmt::format("\"vertex\" expected, not \"{}\"", TextScanner::shown(item)));
            Vector x{};
            for (double& coordinate : x) coordinate = scanner.number();
            soup.corners.push_back(static_cast<int>(soup.points.size()));
            soup.points.push_back(x);
        }
        soup.ends.push_back(soup.corners.size());
        const std::string end = lower_case(scanner.word());
        if (end != "endfacet") end.empty() ? cut_off() : scanner.fail("\"endfacet\" expected");
    }
    if (in_solid) cut_off();
    return soup;
}

PolygonSoup read_off(std::string_view bytes) {
    PolygonSoup soup;
    TextScanner scanner(bytes, '#');
    std::string_view word = scanner.word();
    if (is_off_keyword(word)) {
        if (word.find('4') < word.size() - 3 || word.find('n') < word.size() - 3)
            scanner.fail(fmt::format("\"{}\": points of other than three coordinates are not read", word));
        word = scanner.word();
        if (word == "BINARY") scanner.fail("binary OFF files are not read: write it as text");
    }
    if (word.empty()) scanner.fail("the file ends before its counts");
    const long long points = scanner.to_integer(word);
    const long long faces = scanner.integer();
    check_text_count(scanner, points, 5, "points"); // "0 0 0", the line's end too but for the last
    check_text_count(scanner, faces, 3, "faces");   // "2 0 0" at least, but some write "0"
    soup.points.reserve(static_cast<std::size_t>(points));
    soup.ends.reserve(static_cast<std::size_t>(faces));
    scanner.next_line(); // the count of edges is not needed and often missing
    for (long long i = 0; i < points; ++i) {
        Vector x{scanner.number()};
        for (std::size_t axis = 1; axis < 3; ++axis) x[axis] = scanner.number_of_line();
        soup.points.push_back(x);
        scanner.next_line(); // normals and colours may follow
    }
    for (long long i = 0; i < faces; ++i) {
        const long long corners = scanner.integer();
        check_text_count(scanner, corners, 2, "corners of a face");
        for (long long k = 0; k < corners; ++k) add_corner(soup, scanner.integer(), scanner);
        soup.ends.push_back(soup.corners.size());
        scanner.next_line(); // a colour may follow
    }
    return soup;
}

PolygonSoup read_obj(std::string_view bytes) {
    PolygonSoup soup;
    std::vector<int> line_of_face;
    TextScanner scanner(bytes, '#');
    bool more = true;
    while (more) {
        const std::string_view keyword = scanner.word_of_line();
        if (keyword == "v") {
            Vector x{};
            for (double& coordinate : x) coordinate = scanner.number_of_line();
            soup.points.push_back(x);
        } else if (keyword == "f") {
            for (std::string_view word = scanner.word_of_line(); !word.empty(); word = scanner.word_of_line()) {
                if (word == "\\") { // goes on in the next line
                    scanner.next_line();
                    continue;
                }
                const long long index = scanner.to_integer(word.substr(0, word.find('/')));
                if (index == 0) scanner.fail("a face names point 0, but points count from 1");
                const auto points = static_cast<long long>(soup.points.size());
                const long long from_zero = index > 0 ? index - 1 : points + index;
                if (from_zero < 0 || from_zero >= std::numeric_limits<int>::max())
                    scanner.fail(fmt::format("a face names point {}, but there are {} so far", index, points));
                soup.corners.push_back(static_cast<int>(from_zero));
            }
            soup.ends.push_back(soup.corners.size());
            line_of_face.push_back(scanner.line());
        }
        more = scanner.next_line();
    }
    // Faces may come before their points.
    for (std::size_t face = 0; face < soup.faces(); ++face)
        for (std::size_t k = soup.begin(face); k < soup.ends[face]; ++k)
            if (static_cast<std::size_t>(soup.corners[k]) >= soup.points.size())
                throw std::runtime_error(fmt::format("line {}: a face names point {}, but there are {}",
                                                     line_of_face[face], soup.corners[k] + 1LL, soup.points.size()));
    return soup;
}

PolygonSoup read_polygon_soup(const std::filesystem::path& file) {
    try {
        PolygonSoup soup = read_by_format(read_bytes(file), lower_case(file.extension().string()));
        if (soup.faces() == 0) throw std::runtime_error("has no faces");
        return soup;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("surface \"{}\": {}", file.string(), error.what()));
    }
}

} // namespace abut

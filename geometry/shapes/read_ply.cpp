// PLY files, text and binary of both byte orders.
#include "geometry/shapes/polygon_soup.h"
#include "geometry/shapes/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

namespace abut {

namespace {

enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
    std::string name;
    std::optional<Number> count; ///< of lists: type of their length
    Number type{};
};
struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};
enum class Encoding { text, little, big };
struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
};

Number number_type(const TextScanner& scanner, std::string_view word) {
    static const std::array<std::array<const char*, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i][0] || word == names[i][1]) return static_cast<Number>(i);
    scanner.fail(fmt::format("\"{}\" is no type of numbers", TextScanner::shown(word)));
}

std::size_t size_of(Number type) {
    static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

Header read_header(TextScanner& scanner) {
    Header header;
    bool has_format = false;
    while (scanner.next_line()) {
        const std::string_view keyword = scanner.word_of_line();
        if (keyword == "end_header") {
            if (!has_format) scanner.fail("the header has no line \"format\"");
            scanner.next_line();
            return header;
        }
        if (keyword == "format") {
            const std::string_view name = scanner.word_of_line();
            if (name == "ascii")
                header.encoding = Encoding::text;
            else if (name == "binary_little_endian")
                header.encoding = Encoding::little;
            else if (name == "binary_big_endian")
                header.encoding = Encoding::big;
            else
                scanner.fail(fmt::format("\"{}\" is no format of PLY", TextScanner::shown(name)));
            has_format = true;
        } else if (keyword == "element") {
            Element& element = header.elements.emplace_back();
            element.name = scanner.word_of_line();
            const long long count = scanner.integer_of_line();
            if (count < 0 || count > std::numeric_limits<int>::max())
                scanner.fail(fmt::format("{} is no possible count", count));
            element.count = static_cast<std::size_t>(count);
        } else if (keyword == "property") {
            if (header.elements.empty()) scanner.fail("a property before the first element");
            Property& property = header.elements.back().properties.emplace_back();
            std::string_view type = scanner.word_of_line();
            if (type == "list") {
                property.count = number_type(scanner, scanner.word_of_line());
                type = scanner.word_of_line();
            }
            property.type = number_type(scanner, type);
            property.name = scanner.word_of_line();
        } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
            scanner.fail(fmt::format("\"{}\" has no meaning in the header", TextScanner::shown(keyword)));
        }
    }
    scanner.fail("the file ends before \"end_header\": it seems to be cut off");
}

/// The numbers after the header, one by one.
class Body {
public:
    Body(std::string_view bytes, Encoding encoding) : scanner_(bytes), bytes_(bytes), encoding_(encoding) {}

    std::size_t left() const { return encoding_ == Encoding::text ? scanner_.left() : bytes_.size() - position_; }
    std::size_t least_size(Number type) const { return encoding_ == Encoding::text ? 1 : size_of(type); }

    double next(Number type) {
        if (encoding_ == Encoding::text) return scanner_.number();
        const std::size_t size = size_of(type);
        if (left() < size) throw std::runtime_error("the file ends in the middle: it is cut off");
        std::array<char, 8> raw{};
        for (std::size_t i = 0; i < size; ++i)
            raw[i] = bytes_[position_ + (encoding_ == Encoding::big ? size - 1 - i : i)];
        position_ += size;
        switch (type) {
        case Number::int8:
            return as<std::int8_t>(raw);
        case Number::uint8:
            return as<std::uint8_t>(raw);
        case Number::int16:
            return as<std::int16_t>(raw);
        case Number::uint16:
            return as<std::uint16_t>(raw);
        case Number::int32:
            return as<std::int32_t>(raw);
        case Number::uint32:
            return as<std::uint32_t>(raw);
        case Number::float32:
            return as<float>(raw);
        case Number::float64:
            return as<double>(raw);
        }
        return 0;
    }

private:
    template <class T>
    static double as(const std::array<char, 8>& raw) {
        T value{};
        std::memcpy(&value, raw.data(), sizeof value);
        return static_cast<double>(value);
    }

    TextScanner scanner_;
    std::string_view bytes_;
    std::size_t position_ = 0;
    Encoding encoding_;
};

/// What a number may be that counts or names something.
std::size_t whole(double value, std::size_t limit, const std::string& what) {
    if (!(value >= 0) || value >= static_cast<double>(limit) || value != std::floor(value))
        throw std::runtime_error(what);
    return static_cast<std::size_t>(value);
}

void read_element(Body& body, const Element& element, PolygonSoup& soup, std::size_t points) {
    std::size_t least = 0;
    for (const Property& property : element.properties)
        least += body.least_size(property.count ? *property.count : property.type);
    if (element.count > 0 && (least == 0 || element.count > body.left() / least))
        throw std::runtime_error(fmt::format(
            "the header says that there are {} of \"{}\", but only {} bytes follow: it is cut off or damaged",
            element.count, TextScanner::shown(element.name), body.left()));
    const bool is_vertex = element.name == "vertex";
    const bool is_face = element.name == "face";
    if (is_vertex) soup.points.reserve(element.count);
    if (is_face) soup.ends.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
        Vector x{};
        for (const Property& property : element.properties) {
            if (!property.count) {
                const double value = body.next(property.type);
                if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
                    x[static_cast<std::size_t>(property.name[0] - 'x')] = value;
                continue;
            }
            const std::size_t length = whole(
                body.next(*property.count), body.left() / body.least_size(property.type) + 1,
                fmt::format("{} {} has a list that is longer than the file", TextScanner::shown(element.name), i));
            const bool corners = is_face && (property.name == "vertex_indices" || property.name == "vertex_index");
            for (std::size_t k = 0; k < length; ++k) {
                const double value = body.next(property.type);
                if (corners)
                    soup.corners.push_back(static_cast<int>(whole(
                        value, points,
                        fmt::format("face {} names point {} (from 0), but there are {} points", i, value, points))));
            }
        }
        if (is_vertex) soup.points.push_back(x);
        if (is_face) soup.ends.push_back(soup.corners.size());
    }
}

bool has_property(const Element& element, std::string_view name, bool list) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const Property& p) { return p.name == name && p.count.has_value() == list; });
}

} // namespace

PolygonSoup read_ply(std::string_view bytes) {
    TextScanner scanner(bytes);
    const Header header = read_header(scanner);
    std::size_t points = 0;
    int vertex_elements = 0, face_elements = 0;
    for (const Element& element : header.elements) {
        if (element.name == "vertex") {
            points = element.count;
            ++vertex_elements;
            for (const char* axis : {"x", "y", "z"})
                if (!has_property(element, axis, false))
                    throw std::runtime_error(fmt::format("its points have no property \"{}\"", axis));
        } else if (element.name == "face") {
            ++face_elements;
            if (!has_property(element, "vertex_indices", true) && !has_property(element, "vertex_index", true))
                throw std::runtime_error("its faces have no list \"vertex_indices\"");
        }
    }
    if (vertex_elements != 1 || face_elements != 1)
        throw std::runtime_error("a surface needs one element \"vertex\" and one element \"face\" in its header");
    Body body(bytes.substr(scanner.position()), header.encoding);
    PolygonSoup soup;
    for (const Element& element : header.elements) read_element(body, element, soup, points);
    return soup;
}

} // namespace abut

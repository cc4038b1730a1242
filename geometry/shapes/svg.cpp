#include "geometry/shapes/svg.h"

#include "geometry/shapes/path_file.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace abut {

namespace {

/// x' = a x + c y + e, y' = b x + d y + f.
struct Matrix {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
    PlanePoint operator()(const PlanePoint& p) const { return {a * p[0] + c * p[1] + e, b * p[0] + d * p[1] + f}; }
    Matrix operator*(const Matrix& m) const {
        return {a * m.a + c * m.b, b * m.a + d * m.b,     a * m.c + c * m.d,
                b * m.c + d * m.d, a * m.e + c * m.f + e, b * m.e + d * m.f + f};
    }
};

/// The numbers of a text, separated by white space and commas or by their signs.
std::vector<double> numbers_of(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        while (at != end && (std::isspace(static_cast<unsigned char>(*at)) || *at == ',')) ++at;
        if (at == end) return numbers;
        const char* const first = *at == '+' ? at + 1 : at;
        double value = 0;
        const auto [next, error] = std::from_chars(first, end, value);
        if (error != std::errc() || !std::isfinite(value))
            throw std::runtime_error(fmt::format("\"{}\" is no number", std::string(at, end).substr(0, 20)));
        numbers.push_back(value);
        at = next;
    }
}

Matrix transform_of(const std::string& text) {
    Matrix matrix;
    for (std::size_t at = 0; (at = text.find_first_not_of(" \t\r\n,", at)) != std::string::npos;) {
        const std::size_t open = text.find('(', at);
        const std::size_t close = text.find(')', at);
        std::string name = text.substr(at, open == std::string::npos ? open : open - at);
        name.erase(name.find_last_not_of(" \t\r\n") + 1);
        if (open == std::string::npos || close == std::string::npos || close < open)
            throw std::runtime_error(fmt::format("transform \"{}\" can't be understood", text.substr(0, 40)));
        const std::vector<double> n = numbers_of(text.substr(open + 1, close - open - 1));
        const auto has = [&](std::size_t least, std::size_t most) { return n.size() >= least && n.size() <= most; };
        const double turn = n.empty() ? 0 : n[0] * std::numbers::pi / 180;
        if (name == "matrix" && has(6, 6)) {
            matrix = matrix * Matrix{n[0], n[1], n[2], n[3], n[4], n[5]};
        } else if (name == "translate" && has(1, 2)) {
            matrix = matrix * Matrix{1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0};
        } else if (name == "scale" && has(1, 2)) {
            matrix = matrix * Matrix{n[0], 0, 0, n.size() > 1 ? n[1] : n[0], 0, 0};
        } else if (name == "rotate" && (n.size() == 1 || n.size() == 3)) {
            const PlanePoint about = n.size() == 3 ? PlanePoint{n[1], n[2]} : PlanePoint{0, 0};
            matrix = matrix * Matrix{1, 0, 0, 1, about[0], about[1]} *
                     Matrix{std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn), 0, 0} *
                     Matrix{1, 0, 0, 1, -about[0], -about[1]};
        } else if (name == "skewX" && has(1, 1)) {
            matrix = matrix * Matrix{1, 0, std::tan(turn), 1, 0, 0};
        } else if (name == "skewY" && has(1, 1)) {
            matrix = matrix * Matrix{1, std::tan(turn), 0, 1, 0, 0};
        } else {
            throw std::runtime_error(fmt::format("transform \"{}\" can't be understood", text.substr(0, 40)));
        }
        at = close + 1;
    }
    return matrix;
}

std::string attribute(vtkXMLDataElement* element, const char* name) {
    const char* value = element->GetAttribute(name);
    return value ? value : "";
}

/// A property from `style`, else from the attribute of that name.
std::string property(vtkXMLDataElement* element, const std::string& name) {
    const std::string style = attribute(element, "style");
    const auto trimmed = [](const std::string& text) {
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
    };
    for (std::size_t begin = 0; begin < style.size();) {
        const std::size_t end = std::min(style.find(';', begin), style.size());
        const std::string entry = style.substr(begin, end - begin);
        if (const std::size_t colon = entry.find(':');
            colon != std::string::npos && trimmed(entry.substr(0, colon)) == name)
            return trimmed(entry.substr(colon + 1));
        begin = end + 1;
    }
    return attribute(element, name.c_str());
}

/// A length without unit or in pixels; `missing` if it is not there.
double length(vtkXMLDataElement* element, const char* name, double missing) {
    const std::string text = attribute(element, name);
    if (text.empty()) return missing;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string unit(end, text.data() + text.size());
    if (error != std::errc() || !std::isfinite(value) || !(unit.empty() || unit == "px"))
        throw std::runtime_error(fmt::format("<{}> has {}=\"{}\"; only numbers without unit are understood there",
                                             element->GetName(), name, text.substr(0, 40)));
    return value;
}

/// \param tolerance of chords, see svg_path_outlines(); \param filled whether a viewer fills it
std::vector<Outline2D> outlines_of(vtkXMLDataElement* element, const std::string& name, double tolerance, bool filled) {
    const auto at = [&](const char* key) { return length(element, key, 0); };
    const auto size = [&](const char* key) {
        if (at(key) < 0) throw std::runtime_error(fmt::format("<{}> has a negative {}", name, key));
        return at(key);
    };
    const auto refuse_open = [&](bool open) {
        if (open && !filled)
            throw std::runtime_error(fmt::format("<{}> is open and not filled: a line, no outline; close it", name));
    };
    if (name == "path") {
        bool open = false;
        std::vector<Outline2D> outlines = svg_path_outlines(attribute(element, "d"), tolerance, &open);
        refuse_open(open);
        return outlines;
    }
    if (name == "polygon" || name == "polyline") {
        const std::vector<double> n = numbers_of(attribute(element, "points"));
        if (n.size() % 2 != 0) throw std::runtime_error(fmt::format("<{}> has an odd number of coordinates", name));
        Outline2D outline;
        for (std::size_t k = 0; k + 1 < n.size(); k += 2) outline.push_back({n[k], n[k + 1]});
        refuse_open(name == "polyline" && !outline.empty() && outline.front() != outline.back());
        return {outline};
    }
    if (name == "rect") {
        if (!attribute(element, "rx").empty() || !attribute(element, "ry").empty())
            throw std::runtime_error("<rect> has round corners; convert it to a path");
        const double x = at("x"), y = at("y"), w = size("width"), h = size("height");
        return {{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}};
    }
    const double rx = size(name == "circle" ? "r" : "rx"), ry = name == "circle" ? rx : size("ry");
    const double x = at("cx"), y = at("cy");
    return svg_path_outlines(fmt::format("M {} {} A {} {} 0 0 1 {} {} A {} {} 0 0 1 {} {} Z", x - rx, y, rx, ry, x + rx,
                                         y, rx, ry, x - rx, y),
                             tolerance);
}

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// What elements hand down to those in them.
struct Inherited {
    Matrix matrix;
    bool visible = true, filled = true;
};

/// Longest over shortest axis of the ellipse that a circle becomes; at most 1e4.
double unevenness(const Matrix& m) {
    const double sum = std::hypot(m.a + m.d, m.b - m.c), gap = std::hypot(m.a - m.d, m.b + m.c);
    const double longest = sum + gap, shortest = std::abs(sum - gap);
    return shortest * 1e4 > longest ? longest / shortest : 1e4;
}

constexpr std::size_t most_points = 10'000'000;

void collect(vtkXMLDataElement* element, const Inherited& outer, bool is_root, std::vector<Outline2D>& outlines,
             std::size_t& points) {
    std::string name = element->GetName() ? element->GetName() : "";
    if (const std::size_t colon = name.rfind(':'); colon != std::string::npos) name.erase(0, colon + 1);
    if (is_one_of(name, {"defs", "clipPath", "mask", "symbol", "pattern", "marker", "linearGradient", "radialGradient",
                         "title", "desc", "metadata", "style", "namedview", "filter"}))
        return; // these draw nothing where they stand
    if (is_one_of(name, {"text", "image", "use", "line", "foreignObject"}))
        throw std::runtime_error(
            fmt::format("has a <{}>, which bounds nothing that abut understands; convert it to a path "
                        "or remove it",
                        name));
    if (property(element, "display") == "none") return;
    if (!is_root && (name == "svg" || name == "switch"))
        throw std::runtime_error(fmt::format("has a <{}> inside, which is not supported; ungroup it", name));
    for (const char* cut : {"clip-path", "mask"})
        if (const std::string by = property(element, cut); !by.empty() && by != "none")
            throw std::runtime_error(fmt::format("has a <{}> with a {}, which is not supported", name, cut));
    Inherited own = outer;
    own.matrix = outer.matrix * transform_of(attribute(element, "transform"));
    if (const std::string visible = property(element, "visibility"); !visible.empty() && visible != "inherit")
        own.visible = visible == "visible";
    if (const std::string fill = property(element, "fill"); !fill.empty() && fill != "inherit")
        own.filled = fill != "none" && fill != "transparent";
    if (own.visible && is_one_of(name, {"path", "polygon", "polyline", "rect", "circle", "ellipse"}))
        for (Outline2D& outline : outlines_of(element, name, 1e-5 / unevenness(own.matrix), own.filled)) {
            if ((points += outline.size()) > most_points) throw std::runtime_error("has more than ten million points");
            for (PlanePoint& point : outline) point = own.matrix(point);
            outlines.push_back(std::move(outline));
        }
    for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
        collect(element->GetNestedElement(k), own, false, outlines, points);
}

constexpr std::size_t deepest = 100;

/// Builds the tree of a document's elements, down to the deepest that are allowed: trees are destroyed recursively, and
/// a hostile one would exhaust the stack. (VTK's own function reads a stream in small blocks, and expat then begins a
/// long attribute, as paths have, anew with every block.)
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): as VTK wants it
class TreeParser : public vtkXMLParser {
public:
    static TreeParser* New();
    vtkTypeMacro(TreeParser, vtkXMLParser) TreeParser(const TreeParser&) = delete;
    TreeParser& operator=(const TreeParser&) = delete;
    vtkSmartPointer<vtkXMLDataElement> root;
    bool too_deep = false;

protected:
    TreeParser() = default;
    ~TreeParser() override = default;
    void StartElement(const char* name, const char** attributes) override {
        if (++depth_ > deepest) {
            too_deep = true;
            return;
        }
        const vtkNew<vtkXMLDataElement> element;
        element->SetName(name);
        for (; attributes[0]; attributes += 2) element->SetAttribute(attributes[0], attributes[1]);
        if (open_.empty())
            root = element;
        else
            open_.back()->AddNestedElement(element);
        open_.push_back(element);
    }
    void EndElement(const char* /*name*/) override {
        if (depth_-- <= deepest) open_.pop_back();
    }
    void ReportXmlParseError() override {}

private:
    std::size_t depth_ = 0;
    std::vector<vtkXMLDataElement*> open_; ///< from the root to the present one, which owns the next
};
vtkStandardNewMacro(TreeParser);

/// Height of the drawing in pixels of 1/96 inch; nothing if it is not given, or relative to a window.
std::optional<double> height_of(vtkXMLDataElement* root) {
    const std::string text = attribute(root, "height");
    if (text.empty() || text == "auto" || text.ends_with('%')) return {};
    static constexpr std::array<std::pair<const char*, double>, 6> units{
        {{"px", 1}, {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"in", 96}, {"pt", 96.0 / 72}, {"pc", 16}}};
    for (const auto& [unit, pixels] : units)
        if (text.ends_with(unit)) {
            const std::vector<double> number = numbers_of(text.substr(0, text.size() - 2));
            if (number.size() == 1) return number[0] * pixels;
        }
    const std::vector<double> number = numbers_of(text);
    return number.size() == 1 ? std::optional(number[0]) : std::nullopt;
}

} // namespace

std::vector<Outline2D> svg_outlines(const std::string& document) {
    const vtkTypeBool shown = vtkObject::GetGlobalWarningDisplay(); // VTK would print what it does not understand
    vtkObject::GlobalWarningDisplayOff();
    const vtkNew<TreeParser> parser;
    parser->SetIgnoreCharacterData(1);
    const bool complete = parser->Parse(document.c_str()) != 0;
    vtkObject::SetGlobalWarningDisplay(shown);
    if (parser->too_deep) throw std::runtime_error(fmt::format("has more than {} groups within each other", deepest));
    if (!complete || !parser->root) throw std::runtime_error("is no valid XML");
    vtkXMLDataElement* const root = parser->root;
    const std::string name = root->GetName();
    if (name != "svg" && !name.ends_with(":svg"))
        throw std::runtime_error(fmt::format("is XML, but a <{}>, not an <svg>", name));
    const std::vector<double> box = numbers_of(attribute(root, "viewBox"));
    // SVG's y points down: the lower left corner of the drawing becomes the origin.
    Matrix upright{1, 0, 0, -1, 0, 0};
    if (box.size() != 4) upright.f = height_of(root).value_or(0);
    if (box.size() == 4) upright = {1, 0, 0, -1, -box[0], box[1] + box[3]};
    std::vector<Outline2D> outlines;
    std::size_t points = 0;
    collect(root, {upright}, true, outlines, points);
    return outlines;
}

} // namespace abut

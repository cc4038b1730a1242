#include "geometry/shapes/svg.h"

#include "geometry/shapes/path_file.h"

#include <fmt/format.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <array>
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

/// All numbers of a text; what stands between them does not matter.
std::vector<double> numbers_of(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error == std::errc() && std::isfinite(value)) {
            numbers.push_back(value);
            at = next;
        } else {
            ++at;
        }
    }
    return numbers;
}

Matrix transform_of(const std::string& text) {
    Matrix matrix;
    for (std::size_t at = 0; (at = text.find_first_not_of(" \t\r\n,", at)) != std::string::npos;) {
        const std::size_t open = text.find('(', at);
        const std::size_t close = text.find(')', at);
        const std::string name = text.substr(at, open == std::string::npos ? open : open - at);
        if (open == std::string::npos || close == std::string::npos || close < open)
            throw std::runtime_error(fmt::format("transform \"{}\" can't be understood", text.substr(0, 40)));
        const std::vector<double> n = numbers_of(text.substr(open + 1, close - open - 1));
        const auto has = [&](std::size_t least, std::size_t most) { return n.size() >= least && n.size() <= most; };
        const double turn = n.empty() ? 0 : n[0] * std::numbers::pi / 180;
        if (name.starts_with("matrix") && has(6, 6)) {
            matrix = matrix * Matrix{n[0], n[1], n[2], n[3], n[4], n[5]};
        } else if (name.starts_with("translate") && has(1, 2)) {
            matrix = matrix * Matrix{1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0};
        } else if (name.starts_with("scale") && has(1, 2)) {
            matrix = matrix * Matrix{n[0], 0, 0, n.size() > 1 ? n[1] : n[0], 0, 0};
        } else if (name.starts_with("rotate") && (n.size() == 1 || n.size() == 3)) {
            const PlanePoint about = n.size() == 3 ? PlanePoint{n[1], n[2]} : PlanePoint{0, 0};
            matrix = matrix * Matrix{1, 0, 0, 1, about[0], about[1]} *
                     Matrix{std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn), 0, 0} *
                     Matrix{1, 0, 0, 1, -about[0], -about[1]};
        } else if (name.starts_with("skewX") && has(1, 1)) {
            matrix = matrix * Matrix{1, 0, std::tan(turn), 1, 0, 0};
        } else if (name.starts_with("skewY") && has(1, 1)) {
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

std::vector<Outline2D> outlines_of(vtkXMLDataElement* element, const std::string& name) {
    const auto at = [&](const char* key) { return length(element, key, 0); };
    if (name == "path") return svg_path_outlines(attribute(element, "d"));
    if (name == "polygon" || name == "polyline") {
        const std::vector<double> n = numbers_of(attribute(element, "points"));
        if (n.size() % 2 != 0) throw std::runtime_error(fmt::format("<{}> has an odd number of coordinates", name));
        Outline2D outline;
        for (std::size_t k = 0; k + 1 < n.size(); k += 2) outline.push_back({n[k], n[k + 1]});
        return {outline};
    }
    if (name == "rect") {
        if (!attribute(element, "rx").empty() || !attribute(element, "ry").empty())
            throw std::runtime_error("<rect> has round corners; convert it to a path");
        const double x = at("x"), y = at("y"), w = at("width"), h = at("height");
        return {{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}};
    }
    const double rx = name == "circle" ? at("r") : at("rx"), ry = name == "circle" ? rx : at("ry");
    const double x = at("cx"), y = at("cy");
    return svg_path_outlines(fmt::format("M {} {} A {} {} 0 0 1 {} {} A {} {} 0 0 1 {} {} Z", x - rx, y, rx, ry, x + rx,
                                         y, rx, ry, x - rx, y));
}

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void collect(vtkXMLDataElement* element, const Matrix& outer, int depth, std::vector<Outline2D>& outlines) {
    if (depth > 100) throw std::runtime_error("has more than 100 groups within each other");
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
    const Matrix matrix = outer * transform_of(attribute(element, "transform"));
    if (is_one_of(name, {"path", "polygon", "polyline", "rect", "circle", "ellipse"}))
        for (Outline2D& outline : outlines_of(element, name)) {
            for (PlanePoint& point : outline) point = matrix(point);
            outlines.push_back(std::move(outline));
        }
    for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
        collect(element->GetNestedElement(k), matrix, depth + 1, outlines);
}

} // namespace

std::vector<Outline2D> svg_outlines(const std::string& document) {
    const vtkTypeBool shown = vtkObject::GetGlobalWarningDisplay(); // VTK would print what it does not understand
    vtkObject::GlobalWarningDisplayOff();
    const auto root =
        vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(document.c_str()));
    vtkObject::SetGlobalWarningDisplay(shown);
    if (!root) throw std::runtime_error("is no valid XML");
    const std::string name = root->GetName();
    if (name != "svg" && !name.ends_with(":svg"))
        throw std::runtime_error(fmt::format("is XML, but a <{}>, not an <svg>", name));
    const std::vector<double> box = numbers_of(attribute(root, "viewBox"));
    const std::vector<double> height = numbers_of(attribute(root, "height"));
    // SVG's y points down: the lower left corner of the drawing becomes the origin.
    Matrix upright{1, 0, 0, -1, 0, height.empty() ? 0 : height[0]};
    if (box.size() == 4) upright = {1, 0, 0, -1, -box[0], box[1] + box[3]};
    std::vector<Outline2D> outlines;
    collect(root, upright, 0, outlines);
    return outlines;
}

} // namespace abut

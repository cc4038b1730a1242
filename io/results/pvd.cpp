#include "io/results/pvd.h"

#include "io/results/vtk_messages.h"
#include "io/results/write_text.h"

#include <fmt/format.h>
#include <iterator>
#include <stdexcept>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

namespace abut {
namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    return result;
}

} // namespace

void PvdSeries::append(double time, const std::string& file) {
    while (!entries.empty() && entries.back().time >= time) entries.pop_back();
    entries.push_back({time, file});
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n");
    for (const PvdEntry& entry : entries)
        fmt::format_to(out, "    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time,
                       escaped(entry.file));
    fmt::format_to(out, "  </Collection>\n</VTKFile>\n");
    write_text_atomically(path, {text.data(), text.size()});
}

PvdSeries read_pvd(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) throw std::runtime_error(path.string() + ": no such file");
    VtkMessages silent;
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
    vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
    if (!collection) throw std::runtime_error(path.string() + ": cannot read: no .pvd collection");
    PvdSeries series{path, {}};
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* element = collection->GetNestedElement(i);
        const char* file = element->GetAttribute("file");
        PvdEntry entry;
        if (!file || !element->GetScalarAttribute("timestep", entry.time))
            throw std::runtime_error(fmt::format("{}: cannot read: entry {} has no file or time", path.string(), i));
        entry.file = file;
        const std::filesystem::path place = std::filesystem::path(file).lexically_normal();
        if (place.is_absolute() || place.begin() == place.end() || *place.begin() == "..")
            throw std::runtime_error(
                fmt::format("{}: cannot read: entry {} is no file of its folder: \"{}\"", path.string(), i, file));
        series.entries.push_back(entry);
    }
    return series;
}

} // namespace abut

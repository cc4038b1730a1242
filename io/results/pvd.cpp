#include "io/results/pvd.h"

#include "io/results/vtk_messages.h"
#include "io/results/write_text.h"

#include <fmt/format.h>
#include <iterator>
#include <set>
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

/// The text of a .pvd file.
class Collection {
public:
    void add(double time, const std::string& name, std::size_t part, const std::string& file) {
        const std::string label = name.empty() ? "" : fmt::format(" name=\"{}\"", escaped(name));
        fmt::format_to(std::back_inserter(text_),
                       "    <DataSet timestep=\"{}\" group=\"\" part=\"{}\"{} file=\"{}\"/>\n", time, part, label,
                       escaped(file));
    }
    void write(const std::filesystem::path& path) const {
        write_text_atomically(path, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                                    "  <Collection>\n" +
                                        fmt::to_string(text_) + "  </Collection>\n</VTKFile>\n");
    }

private:
    fmt::memory_buffer text_;
};

} // namespace

void PvdSeries::append(double time, const std::string& file) {
    while (!entries.empty() && entries.back().time >= time) entries.pop_back();
    entries.push_back({time, file});
    write();
}

void PvdSeries::write() const {
    Collection collection;
    for (const PvdEntry& entry : entries) collection.add(entry.time, "", 0, entry.file);
    collection.write(path);
}

void write_parts(const std::filesystem::path& path, const std::vector<PvdPart>& parts) {
    std::set<double> times;
    for (const PvdPart& part : parts)
        for (const PvdEntry& entry : part.series->entries) times.insert(entry.time);
    Collection collection;
    std::vector<std::size_t> next(parts.size(), 0);
    for (const double time : times)
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::vector<PvdEntry>& entries = parts[i].series->entries;
            while (next[i] < entries.size() && entries[next[i]].time <= time) ++next[i];
            if (next[i] > 0) collection.add(time, parts[i].name, i, entries[next[i] - 1].file);
        }
    collection.write(path);
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

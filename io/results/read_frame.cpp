#include "io/results/read_frame.h"

#include "io/results/vtk_end.h"
#include "io/results/vtk_messages.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace abut {
namespace {

template <class Value, class VtkArray>
bool copy_if(vtkDataArray& array, Array& result) {
    auto* typed = VtkArray::SafeDownCast(&array);
    if (typed) result.values = std::vector<Value>(typed->GetPointer(0), typed->GetPointer(typed->GetNumberOfValues()));
    return typed != nullptr;
}

/// Of other types, which foreign files may have.
template <class Value>
std::vector<Value> copy(vtkDataArray& array) {
    std::vector<Value> values(static_cast<std::size_t>(array.GetNumberOfValues()));
    std::vector<double> tuple(static_cast<std::size_t>(array.GetNumberOfComponents()));
    auto out = values.begin();
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) {
        array.GetTuple(i, tuple.data());
        out = std::transform(tuple.begin(), tuple.end(), out, [](double v) { return static_cast<Value>(v); });
    }
    return values;
}

Array copy_array(vtkDataArray& array) {
    Array result{array.GetName() ? array.GetName() : "", array.GetNumberOfComponents(), {}};
    if (!copy_if<double, vtkDoubleArray>(array, result) && !copy_if<double, vtkFloatArray>(array, result) &&
        !copy_if<std::int32_t, vtkIntArray>(array, result))
        result.values = copy<std::int32_t>(array);
    if (array.HasInformation() && array.GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
        result.unit = array.GetInformation()->Get(vtkDataArray::UNITS_LABEL());
    return result;
}

void read_fields(vtkDataSet& data, double& time, std::vector<Array>& arrays, std::vector<Array>& globals,
                 std::vector<Words>& words) {
    for (int i = 0; i < data.GetPointData()->GetNumberOfArrays(); ++i)
        if (vtkDataArray* array = data.GetPointData()->GetArray(i)) arrays.push_back(copy_array(*array));
    for (int i = 0; i < data.GetFieldData()->GetNumberOfArrays(); ++i) {
        vtkAbstractArray* field = data.GetFieldData()->GetAbstractArray(i);
        const std::string name = field->GetName() ? field->GetName() : "";
        if (name == "units") continue; // the arrays have them
        if (auto* strings = vtkStringArray::SafeDownCast(field)) {
            Words list{name, {}};
            for (vtkIdType k = 0; k < strings->GetNumberOfValues(); ++k) list.values.push_back(strings->GetValue(k));
            words.push_back(std::move(list));
        } else if (auto* numbers = vtkDataArray::SafeDownCast(field)) {
            if (name == "TimeValue" && numbers->GetNumberOfTuples() > 0)
                time = numbers->GetComponent(0, 0);
            else
                globals.push_back(copy_array(*numbers));
        }
    }
}

/// Runs a reader and throws unless all of the file was understood.
void update(vtkXMLReader& reader, const std::filesystem::path& path, const std::vector<std::string>& wanted) {
    if (!std::filesystem::is_regular_file(path)) throw std::runtime_error(path.string() + ": no such file");
    if (std::ifstream(path) && !has_vtk_end(path)) // if it can't be opened, VTK says why
        throw std::runtime_error(path.string() + ": cannot read: its end is missing");
    VtkMessages messages;
    reader.SetFileName(path.c_str());
    reader.UpdateInformation();
    if (!wanted.empty()) {
        vtkDataArraySelection* selection = reader.GetPointDataArraySelection();
        for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
            selection->SetArraySetting(selection->GetArrayName(i),
                                       std::count(wanted.begin(), wanted.end(), selection->GetArrayName(i)) > 0);
    }
    reader.Update();
    const std::string cause = messages.first_error();
    if (!cause.empty() || reader.GetErrorCode() != 0)
        throw std::runtime_error(
            fmt::format("{}: cannot read: {}", path.string(), cause.empty() ? "broken file" : cause));
}

template <class Reader>
PointFrame read_point_set(const std::filesystem::path& path, const std::vector<std::string>& wanted) {
    vtkNew<Reader> reader;
    update(*reader, path, wanted);
    auto* data = reader->GetOutput();
    PointFrame frame;
    if (data->GetPoints()) frame.points = copy<double>(*data->GetPoints()->GetData());
    read_fields(*data, frame.time, frame.arrays, frame.globals, frame.words);
    return frame;
}

} // namespace

PointFrame read_points(const std::filesystem::path& path, const std::vector<std::string>& wanted) {
    if (path.extension() == ".vtp") return read_point_set<vtkXMLPolyDataReader>(path, wanted);
    return read_point_set<vtkXMLUnstructuredGridReader>(path, wanted);
}

GridFrame read_grid(const std::filesystem::path& path, const std::vector<std::string>& wanted) {
    vtkNew<vtkXMLImageDataReader> reader;
    update(*reader, path, wanted);
    vtkImageData* data = reader->GetOutput();
    GridFrame frame;
    data->GetDimensions(frame.nodes.data());
    data->GetOrigin(frame.origin.data());
    data->GetSpacing(frame.spacing.data());
    read_fields(*data, frame.time, frame.arrays, frame.globals, frame.words);
    return frame;
}

} // namespace abut

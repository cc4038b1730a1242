#include "io/results/write_frame.h"

#include "io/results/output_file.h"
#include "io/results/vtk_end.h"
#include "io/results/vtk_messages.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <numeric>
#include <stdexcept>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace abut {
namespace {

// === Frames as VTK data; VTK borrows the frame's memory and never writes to it

template <class VtkArray, class Value>
vtkSmartPointer<VtkArray> borrow(const std::vector<Value>& values, int components) {
    auto array = vtkSmartPointer<VtkArray>::New();
    array->SetNumberOfComponents(components);
    array->SetArray(const_cast<Value*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
    return array;
}

vtkSmartPointer<vtkDataArray> real_array(const std::vector<double>& values, int components, Reals reals) {
    if (reals == Reals::float64) return borrow<vtkDoubleArray>(values, components);
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(components);
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::transform(values.begin(), values.end(), array->GetPointer(0), [](double v) { return static_cast<float>(v); });
    return array;
}

vtkSmartPointer<vtkDataArray> data_array(const Array& array, Reals reals) {
    vtkSmartPointer<vtkDataArray> result;
    if (const auto* values = std::get_if<std::vector<double>>(&array.values))
        result = real_array(*values, array.components, reals);
    else
        result = borrow<vtkIntArray>(std::get<std::vector<std::int32_t>>(array.values), array.components);
    result->SetName(array.name.c_str());
    if (!array.unit.empty()) result->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), array.unit.c_str());
    return result;
}

/// \param what the array's tuples belong to: "points" or "cells"
void add_arrays(vtkDataSetAttributes& data, const std::vector<Array>& arrays, std::size_t count, const char* what,
                Reals reals) {
    for (const Array& array : arrays) {
        const std::size_t length = std::visit([](const auto& values) { return values.size(); }, array.values);
        if (array.components < 1 || length != count * static_cast<std::size_t>(array.components))
            throw std::invalid_argument(fmt::format("array \"{}\": {} values for {} {} of {} components", array.name,
                                                    length, count, what, array.components));
        data.AddArray(data_array(array, reals));
    }
}

void add_words(vtkDataSet& data, const Words& list) {
    vtkNew<vtkStringArray> strings;
    strings->SetName(list.name.c_str());
    for (const std::string& word : list.values) strings->InsertNextValue(word);
    data.GetFieldData()->AddArray(strings);
}

/// `units`: "velocity [m/s]" and so on, since not all programs show the units that VTK's arrays carry.
Words units_of(const std::vector<Array>& arrays) {
    Words units{"units", {"TimeValue [s]"}};
    for (const Array& array : arrays)
        if (!array.unit.empty()) units.values.push_back(fmt::format("{} [{}]", array.name, array.unit));
    return units;
}

/// The field data.
template <class Frame>
void add_globals(vtkDataSet& data, const Frame& frame) {
    vtkNew<vtkDoubleArray> time_value; // the name that ParaView looks for
    time_value->SetName("TimeValue");
    time_value->InsertNextValue(frame.time);
    data.GetFieldData()->AddArray(time_value);
    for (const Array& array : frame.globals) data.GetFieldData()->AddArray(data_array(array, Reals::float64));
    for (const Words& list : frame.words) add_words(data, list);
    if (!frame.arrays.empty()) add_words(data, units_of(frame.arrays));
}

/// One cell of one point for each point.
vtkSmartPointer<vtkCellArray> vertices(std::size_t count) {
    vtkNew<vtkTypeInt32Array> offsets, points;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(count) + 1);
    points->SetNumberOfValues(static_cast<vtkIdType>(count));
    std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + count + 1, 0);
    std::iota(points->GetPointer(0), points->GetPointer(0) + count, 0);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, points);
    return cells;
}

void insert(vtkCellArray& cells, const std::vector<std::int32_t>& corners) {
    cells.InsertNextCell(static_cast<int>(corners.size()));
    for (const std::int32_t point : corners) cells.InsertCellPoint(point);
}

void set_points(vtkPointSet& data, const std::vector<double>& coordinates, Reals reals) {
    if (coordinates.size() % 3 != 0) throw std::invalid_argument("points need 3 coordinates each");
    vtkNew<vtkPoints> points;
    points->SetData(real_array(coordinates, 3, reals));
    data.SetPoints(points);
}

void fill(vtkPointSet& data, const PointFrame& frame, Reals points, Reals reals) {
    set_points(data, frame.points, points);
    add_arrays(*data.GetPointData(), frame.arrays, frame.points.size() / 3, "points", reals);
    add_globals(data, frame);
}

void fill(vtkPointSet& data, const CellFrame& frame) {
    set_points(data, frame.points, Reals::float64);
    add_arrays(*data.GetCellData(), frame.arrays, frame.cells.size(), "cells", Reals::float64);
    add_globals(data, frame);
}

vtkSmartPointer<vtkPolyData> surface(const CellFrame& frame) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkCellArray> lines, polygons;
    lines->Use32BitStorage();
    polygons->Use32BitStorage();
    for (const std::vector<std::int32_t>& corners : frame.cells) {
        if (corners.size() < 2) throw std::invalid_argument("cells of a .vtp file need two corners or more");
        const bool line = corners.size() == 2;
        if (line && polygons->GetNumberOfCells() > 0) throw std::invalid_argument("lines come before polygons");
        insert(line ? *lines : *polygons, corners);
    }
    data->SetLines(lines);
    data->SetPolys(polygons);
    return data;
}

vtkSmartPointer<vtkUnstructuredGrid> unstructured(const CellFrame& frame) {
    auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkCellArray> cells;
    cells->Use32BitStorage();
    vtkNew<vtkUnsignedCharArray> kinds;
    for (const std::vector<std::int32_t>& corners : frame.cells) {
        const std::size_t count = corners.size();
        if (count != 2 && count != 4 && count != 8)
            throw std::invalid_argument(fmt::format("a cell of {} corners in a .vtu file", count));
        kinds->InsertNextValue(count == 2 ? VTK_LINE : count == 4 ? VTK_QUAD : VTK_HEXAHEDRON);
        insert(*cells, corners);
    }
    data->SetCells(kinds, cells);
    return data;
}

// === Writing

template <class Writer>
void write(const std::filesystem::path& path, vtkDataSet& data) {
    replace_file(path, [&](const std::filesystem::path& temporary) {
        VtkMessages messages;
        vtkNew<Writer> writer;
        writer->SetInputData(&data);
        writer->SetFileName(temporary.c_str());
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
        writer->SetCompressorTypeToLZ4();
        writer->SetHeaderTypeToUInt64();
        errno = 0;
        const bool accepted = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
        const int cause = errno; // VTK calls every failure "out of disk space"; the system knows better
        if (accepted && has_vtk_end(temporary)) return; // the last buffer may never have reached the disk
        const std::string vtk_cause = messages.first_error();
        throw std::runtime_error(fmt::format("{}: cannot write: {}", path.string(),
                                             cause != 0           ? std::strerror(cause)
                                             : !vtk_cause.empty() ? vtk_cause
                                                                  : "the file is incomplete"));
    });
}

} // namespace

void write_particles(const std::filesystem::path& path, const PointFrame& frame, Reals reals) {
    vtkNew<vtkUnstructuredGrid> data;
    fill(*data, frame, reals, reals);
    data->SetCells(VTK_VERTEX, vertices(frame.points.size() / 3));
    write<vtkXMLUnstructuredGridWriter>(path, *data);
}

void write_contact(const std::filesystem::path& path, const PointFrame& frame, Reals reals) {
    vtkNew<vtkPolyData> data;
    fill(*data, frame, Reals::float64, reals);
    data->SetVerts(vertices(frame.points.size() / 3));
    write<vtkXMLPolyDataWriter>(path, *data);
}

void write_cells(const std::filesystem::path& path, const CellFrame& frame) {
    if (path.extension() == ".vtp") {
        const auto data = surface(frame);
        fill(*data, frame);
        write<vtkXMLPolyDataWriter>(path, *data);
    } else {
        const auto data = unstructured(frame);
        fill(*data, frame);
        write<vtkXMLUnstructuredGridWriter>(path, *data);
    }
}

void write_grid(const std::filesystem::path& path, const GridFrame& frame, Reals reals) {
    vtkNew<vtkImageData> data;
    data->SetDimensions(frame.nodes.data());
    data->SetOrigin(frame.origin.data());
    data->SetSpacing(frame.spacing.data());
    add_arrays(*data->GetPointData(), frame.arrays, static_cast<std::size_t>(data->GetNumberOfPoints()), "points",
               reals);
    add_globals(*data, frame);
    write<vtkXMLImageDataWriter>(path, *data);
}

} // namespace abut

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

/// Cells of equally many corners, by the numbers of their points.
vtkSmartPointer<vtkCellArray> cells_of(int corners, const std::vector<std::int32_t>& corner_points) {
    vtkNew<vtkTypeInt32Array> offsets, points;
    const auto count = static_cast<vtkIdType>(corner_points.size()) / corners;
    offsets->SetNumberOfValues(count + 1);
    for (vtkIdType i = 0; i <= count; ++i) offsets->SetValue(i, static_cast<vtkTypeInt32>(i * corners));
    points->SetNumberOfValues(static_cast<vtkIdType>(corner_points.size()));
    std::copy(corner_points.begin(), corner_points.end(), points->GetPointer(0));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, points);
    return cells;
}

/// One cell of one point for each point.
vtkSmartPointer<vtkCellArray> vertices(std::size_t count) {
    std::vector<std::int32_t> points(count);
    std::iota(points.begin(), points.end(), 0);
    return cells_of(1, points);
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

/// \param cells their number
template <class Frame>
void fill_cells(vtkPointSet& data, const Frame& frame, std::size_t cells) {
    set_points(data, frame.points, Reals::float64);
    add_arrays(*data.GetCellData(), frame.arrays, cells, "cells", Reals::float64);
    add_globals(data, frame);
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
    const auto cells = cells_of(frame.corners, frame.corner_points);
    const auto count = static_cast<std::size_t>(cells->GetNumberOfCells());
    if (path.extension() == ".vtp") {
        vtkNew<vtkPolyData> data;
        frame.corners == 2 ? data->SetLines(cells) : data->SetPolys(cells);
        fill_cells(*data, frame, count);
        write<vtkXMLPolyDataWriter>(path, *data);
    } else {
        vtkNew<vtkUnstructuredGrid> data;
        data->SetCells(frame.corners == 2 ? VTK_LINE : frame.corners == 4 ? VTK_QUAD : VTK_HEXAHEDRON, cells);
        fill_cells(*data, frame, count);
        write<vtkXMLUnstructuredGridWriter>(path, *data);
    }
}

void write_surface(const std::filesystem::path& path, const SurfaceFrame& frame) {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkCellArray> lines, polygons;
    for (const std::vector<std::int32_t>& cell : frame.cells) {
        const bool line = cell.size() == 2;
        if (line && polygons->GetNumberOfCells() > 0) throw std::invalid_argument("lines come before polygons");
        const std::vector<vtkIdType> points(cell.begin(), cell.end());
        (line ? lines : polygons)->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
    }
    data->SetLines(lines);
    data->SetPolys(polygons);
    fill_cells(*data, frame, frame.cells.size());
    write<vtkXMLPolyDataWriter>(path, *data);
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

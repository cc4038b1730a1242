// Frames are read back with VTK's own readers, as ParaView does, and compared bit for bit.
#include "io/results/read_frame.h"
#include "io/results/write_frame.h"
#include "results_support.h"

#include <gmock/gmock.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace abut::test {
namespace {

using testing::HasSubstr;

template <class Reader>
auto read(const std::filesystem::path& path) {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0u);
    return vtkSmartPointer<std::remove_pointer_t<decltype(reader->GetOutput())>>(reader->GetOutput());
}

template <class Value>
void expect_values(vtkDataArray* array, const std::vector<Value>& expected, int components, int type) {
    ASSERT_NE(array, nullptr);
    EXPECT_EQ(array->GetDataType(), type);
    ASSERT_EQ(array->GetNumberOfComponents(), components);
    ASSERT_EQ(static_cast<std::size_t>(array->GetNumberOfValues()), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_EQ(array->GetVariantValue(static_cast<vtkIdType>(i)).ToDouble(), static_cast<double>(expected[i])) << i;
}

void expect_frame(vtkPointSet& data, const PointFrame& frame) {
    if (!frame.points.empty()) expect_values(data.GetPoints()->GetData(), frame.points, 3, VTK_DOUBLE);
    EXPECT_EQ(static_cast<std::size_t>(data.GetNumberOfPoints()), frame.points.size() / 3);
    EXPECT_EQ(data.GetNumberOfCells(), data.GetNumberOfPoints());
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        EXPECT_EQ(data.GetCellType(i), VTK_VERTEX);
        vtkNew<vtkIdList> ids;
        data.GetCellPoints(i, ids);
        ASSERT_EQ(ids->GetNumberOfIds(), 1);
        EXPECT_EQ(ids->GetId(0), i);
    }
    ASSERT_EQ(data.GetPointData()->GetNumberOfArrays(), 2);
    expect_values(data.GetPointData()->GetArray("velocity"), std::get<0>(frame.arrays[0].values), 3, VTK_DOUBLE);
    expect_values(data.GetPointData()->GetArray("body"), std::get<1>(frame.arrays[1].values), 1, VTK_INT);
    EXPECT_EQ(data.GetPointData()->GetScalars(), nullptr);
    EXPECT_EQ(data.GetPointData()->GetVectors(), nullptr);

    expect_values(data.GetFieldData()->GetArray("TimeValue"), std::vector<double>{frame.time}, 1, VTK_DOUBLE);
    expect_values(data.GetFieldData()->GetArray("grid_spacing"), std::get<0>(frame.globals[0].values), 3, VTK_DOUBLE);
    auto* names = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("body_names"));
    ASSERT_NE(names, nullptr);
    ASSERT_EQ(names->GetNumberOfValues(), 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(names->GetValue(i), frame.words[0].values[static_cast<std::size_t>(i)]);
}

TEST(WriteFrame, ParticlesReadBackExactly) {
    TemporaryFolder folder;
    const PointFrame frame = sample_frame(1000);
    write_particles(folder / "p.vtu", frame);
    expect_frame(*read<vtkXMLUnstructuredGridReader>(folder / "p.vtu"), frame);
    EXPECT_EQ(folder.count(), 1u); // no temporary file is left
}

TEST(WriteFrame, SurfaceReadsBackExactly) {
    TemporaryFolder folder;
    CellFrame frame;
    frame.time = 0.25;
    frame.points = {0, 0, 0, 1, 0, 0, 1, 2, 0, 0.1, 2, 3};
    frame.cells = {{0, 2}, {3, 1}, {0, 1, 2, 3}};
    frame.arrays = {{"velocity", 3, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}},
                    {"boundary", 1, std::vector<std::int32_t>{5, 4, 3}}};
    frame.words = {{"boundary_names", {"floor", "piston"}}};
    write_cells(folder / "s.vtp", frame);
    const auto data = read<vtkXMLPolyDataReader>(folder / "s.vtp");
    expect_values(data->GetPoints()->GetData(), frame.points, 3, VTK_DOUBLE);
    ASSERT_EQ(data->GetNumberOfCells(), 3);
    for (vtkIdType cell = 0; cell < 3; ++cell) {
        vtkNew<vtkIdList> ids;
        data->GetCellPoints(cell, ids);
        const auto& expected = frame.cells[static_cast<std::size_t>(cell)];
        ASSERT_EQ(static_cast<std::size_t>(ids->GetNumberOfIds()), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(ids->GetId(static_cast<vtkIdType>(i)), expected[i]);
    }
    expect_values(data->GetCellData()->GetArray("velocity"), std::get<0>(frame.arrays[0].values), 3, VTK_DOUBLE);
    expect_values(data->GetCellData()->GetArray("boundary"), std::get<1>(frame.arrays[1].values), 1, VTK_INT);
    expect_values(data->GetFieldData()->GetArray("TimeValue"), std::vector<double>{0.25}, 1, VTK_DOUBLE);
    EXPECT_NE(data->GetFieldData()->GetAbstractArray("boundary_names"), nullptr);
    EXPECT_EQ(folder.count(), 1u);

    std::swap(frame.cells[0], frame.cells[2]); // VTK would number the cells anew, and arrays would be mixed up
    EXPECT_THROW(write_cells(folder / "t.vtp", frame), std::invalid_argument);
    frame.cells[0] = {1};
    EXPECT_THROW(write_cells(folder / "t.vtp", frame), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(folder / "t.vtp"));
    frame = {};
    write_cells(folder / "e.vtp", frame);
    EXPECT_EQ(read<vtkXMLPolyDataReader>(folder / "e.vtp")->GetNumberOfCells(), 0);
}

TEST(WriteFrame, CellsOfSeveralKindsReadBackExactly) {
    TemporaryFolder folder;
    CellFrame frame;
    for (const double z : {0.0, 2.0})
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}})
            frame.points.insert(frame.points.end(), {x, y, z});
    frame.cells = {{4, 5, 6, 7}, {0, 6}, {0, 1, 2, 3, 4, 5, 6, 7}};
    frame.arrays = {{"boundary", 1, std::vector<std::int32_t>{5, 4, 3}}};
    write_cells(folder / "c.vtu", frame);
    const auto data = read<vtkXMLUnstructuredGridReader>(folder / "c.vtu");
    ASSERT_EQ(data->GetNumberOfCells(), 3);
    const int kinds[] = {VTK_QUAD, VTK_LINE, VTK_HEXAHEDRON};
    for (vtkIdType cell = 0; cell < 3; ++cell) {
        EXPECT_EQ(data->GetCellType(cell), kinds[cell]);
        const auto& expected = frame.cells[static_cast<std::size_t>(cell)];
        vtkIdList* ids = data->GetCell(cell)->GetPointIds();
        ASSERT_EQ(static_cast<std::size_t>(ids->GetNumberOfIds()), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(ids->GetId(static_cast<vtkIdType>(i)), expected[i]);
    }
    expect_values(data->GetCellData()->GetArray("boundary"), std::get<1>(frame.arrays[0].values), 1, VTK_INT);
    frame.cells[1] = {0, 1, 6};
    EXPECT_THROW(write_cells(folder / "t.vtu", frame), std::invalid_argument);
    frame = {};
    write_cells(folder / "e.vtu", frame);
    EXPECT_EQ(read<vtkXMLUnstructuredGridReader>(folder / "e.vtu")->GetNumberOfCells(), 0);
}

TEST(WriteFrame, ContactReadsBackExactly) {
    TemporaryFolder folder;
    const PointFrame frame = sample_frame(77);
    write_contact(folder / "c.vtp", frame);
    expect_frame(*read<vtkXMLPolyDataReader>(folder / "c.vtp"), frame);
}

TEST(WriteFrame, FilesAreBinaryAndCompressed) {
    TemporaryFolder folder;
    write_particles(folder / "p.vtu", sample_frame(1000));
    const std::string text = read_text(folder / "p.vtu");
    EXPECT_THAT(text, HasSubstr("<AppendedData encoding=\"raw\">"));
    EXPECT_THAT(text, HasSubstr("compressor=\"vtkLZ4DataCompressor\""));
    EXPECT_THAT(text, HasSubstr("header_type=\"UInt64\""));
}

TEST(WriteFrame, NoPointsStillOpen) {
    TemporaryFolder folder;
    const PointFrame frame = sample_frame(0);
    write_particles(folder / "p.vtu", frame);
    write_contact(folder / "c.vtp", frame);
    expect_frame(*read<vtkXMLUnstructuredGridReader>(folder / "p.vtu"), frame);
    expect_frame(*read<vtkXMLPolyDataReader>(folder / "c.vtp"), frame);
    EXPECT_EQ(read_points(folder / "c.vtp").time, frame.time);
    EXPECT_EQ(read_points(folder / "c.vtp").points.size(), 0u);
}

TEST(WriteFrame, FrameWithoutArraysOrNames) {
    TemporaryFolder folder;
    PointFrame frame;
    frame.points = {1, 2, 3};
    frame.words = {{"body_names", {}}};
    write_particles(folder / "p.vtu", frame);
    EXPECT_EQ(read<vtkXMLUnstructuredGridReader>(folder / "p.vtu")->GetNumberOfPoints(), 1);
}

TEST(WriteFrame, GridReadsBackExactly) {
    TemporaryFolder folder;
    GridFrame frame;
    frame.time = 1.0 / 3;
    frame.nodes = {4, 3, 1};
    frame.origin = {-1e-3, 2e-3, 0};
    frame.spacing = {0.1e-3, 0.3e-3, 1};
    std::vector<double> mass(12), velocity(36);
    for (std::size_t i = 0; i < 36; ++i) velocity[i] = 1.0 / (1.0 + static_cast<double>(i));
    for (std::size_t i = 0; i < 12; ++i) mass[i] = static_cast<double>(i);
    frame.arrays = {{"mass", 1, mass},
                    {"velocity", 3, velocity},
                    {"body_count", 1, std::vector<std::int32_t>{0, 1, 2, 0, 1, 2, 0, 1, 2, 3, 3, 3}}};
    write_grid(folder / "g.vti", frame);

    const auto data = read<vtkXMLImageDataReader>(folder / "g.vti");
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        EXPECT_EQ(data->GetDimensions()[axis], frame.nodes[a]);
        EXPECT_EQ(data->GetOrigin()[axis], frame.origin[a]);
        EXPECT_EQ(data->GetSpacing()[axis], frame.spacing[a]);
    }
    expect_values(data->GetPointData()->GetArray("mass"), mass, 1, VTK_DOUBLE);
    expect_values(data->GetPointData()->GetArray("velocity"), velocity, 3, VTK_DOUBLE);
    expect_values(data->GetPointData()->GetArray("body_count"), std::get<1>(frame.arrays[2].values), 1, VTK_INT);
    expect_values(data->GetFieldData()->GetArray("TimeValue"), std::vector<double>{frame.time}, 1, VTK_DOUBLE);
    EXPECT_EQ(data->GetPointData()->GetScalars(), nullptr);

    const GridFrame back = read_grid(folder / "g.vti");
    EXPECT_EQ(back.nodes, frame.nodes);
    EXPECT_EQ(back.spacing, frame.spacing);
    EXPECT_EQ(std::get<0>(back.arrays[1].values), velocity);
}

TEST(WriteFrame, SpaceReadsBackExactly) {
    TemporaryFolder folder;
    GridFrame grid;
    grid.nodes = {2, 3, 4};
    grid.origin = {-1, 2, 0.25};
    grid.spacing = {0.1, 0.2, 0.3};
    std::vector<double> velocity(3 * 24);
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = 1.0 / (1.0 + static_cast<double>(i));
    grid.arrays = {{"velocity", 3, velocity}};
    write_grid(folder / "g.vti", grid);
    const auto data = read<vtkXMLImageDataReader>(folder / "g.vti");
    EXPECT_EQ(data->GetDataDimension(), 3);
    EXPECT_EQ(data->GetNumberOfCells(), 1 * 2 * 3);
    expect_values(data->GetPointData()->GetArray("velocity"), velocity, 3, VTK_DOUBLE);
    const vtkIdType node = data->FindPoint(-0.9, 2.4, 0.25 + 0.9); // the last one: x runs fastest
    EXPECT_EQ(node, 23);
    const GridFrame back = read_grid(folder / "g.vti");
    EXPECT_EQ(back.nodes, grid.nodes);
    EXPECT_EQ(back.origin, grid.origin);
    EXPECT_EQ(back.arrays[0].values, grid.arrays[0].values);

    PointFrame frame = sample_frame(2);
    const std::vector<double> stress{1, 2, 3, 4, 5, 6, -1, -2, -3, -4, -5, -6}; // xx yy zz xy yz xz
    frame.arrays = {{"stress", 6, stress}};
    write_particles(folder / "p.vtu", frame);
    const auto points = read<vtkXMLUnstructuredGridReader>(folder / "p.vtu");
    expect_values(points->GetPointData()->GetArray("stress"), stress, 6, VTK_DOUBLE);
    EXPECT_EQ(read_points(folder / "p.vtu").arrays.at(0).values, frame.arrays[0].values);
}

TEST(WriteFrame, ReadPointsInvertsWriting) {
    TemporaryFolder folder;
    const PointFrame frame = sample_frame(50);
    write_particles(folder / "p.vtu", frame);
    const PointFrame back = read_points(folder / "p.vtu");
    EXPECT_EQ(back.time, frame.time);
    EXPECT_EQ(back.points, frame.points);
    ASSERT_EQ(back.arrays.size(), 2u);
    EXPECT_EQ(back.arrays[0].values, frame.arrays[0].values);
    EXPECT_EQ(back.arrays[1].values, frame.arrays[1].values);
    EXPECT_EQ(back.words[0].values, frame.words[0].values);
    const PointFrame some = read_points(folder / "p.vtu", {"body", "nonsense"});
    ASSERT_EQ(some.arrays.size(), 1u);
    EXPECT_EQ(some.arrays[0].name, "body");
}

TEST(WriteFrame, ArrayOfWrongLengthIsRefused) {
    TemporaryFolder folder;
    PointFrame frame = sample_frame(3);
    std::get<0>(frame.arrays[0].values).pop_back();
    EXPECT_THROW(write_particles(folder / "p.vtu", frame), std::invalid_argument);
    EXPECT_EQ(folder.count(), 0u);
}

TEST(WriteFrame, MissingFolderIsReported) {
    TemporaryFolder folder;
    const std::string error = error_of([&] { write_particles(folder / "none/p.vtu", sample_frame(3)); });
    EXPECT_THAT(error, HasSubstr("none/p.vtu: cannot write: No such file or directory"));
    EXPECT_EQ(folder.count(), 0u);
}

TEST(WriteFrame, FullDiskIsReportedAndTheOldFileStays) {
    TemporaryFolder folder;
    write_particles(folder / "p.vtu", sample_frame(10));
    const std::string before = read_text(folder / "p.vtu");
    // Limits that hit the header, the appended data, and the last bytes of the file in VTK's buffer.
    write_particles(folder / "whole.vtu", sample_frame(1000));
    const auto size = std::filesystem::file_size(folder / "whole.vtu");
    std::filesystem::remove(folder / "whole.vtu");
    testing::internal::CaptureStderr();
    for (const std::uintmax_t limit : {std::uintmax_t{100}, size / 2, size - 1}) {
        std::string error;
        {
            DiskLimit full(limit);
            error = error_of([&] { write_particles(folder / "p.vtu", sample_frame(1000)); });
        }
        EXPECT_THAT(error, HasSubstr("p.vtu: cannot write: File too large")) << limit;
        EXPECT_EQ(read_text(folder / "p.vtu"), before);
        EXPECT_EQ(folder.count(), 1u);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), ""); // VTK keeps quiet
}

TEST(ReadFrame, BrokenFilesAreReported) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { read_points(folder / "none.vtu"); }), HasSubstr("none.vtu: no such file"));
    write_particles(folder / "p.vtu", sample_frame(1000));
    const std::string whole = read_text(folder / "p.vtu");
    testing::internal::CaptureStderr();
    for (const std::size_t size : {std::size_t{0}, std::size_t{300}, whole.size() / 2}) {
        std::ofstream(folder / "half.vtu", std::ios::binary) << whole.substr(0, size);
        EXPECT_THAT(error_of([&] { read_points(folder / "half.vtu"); }), HasSubstr("half.vtu: cannot read")) << size;
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(WriteFrame, SinglePrecisionRoundsTheRealsToTheNearestFloat) {
    TemporaryFolder folder;
    PointFrame frame = sample_frame(100);
    frame.time = 1.0 / 3;
    write_particles(folder / "p.vtu", frame, Reals::float32);
    const auto data = read<vtkXMLUnstructuredGridReader>(folder / "p.vtu");
    auto rounded = [](std::vector<double> values) {
        for (double& v : values) v = static_cast<float>(v);
        return values;
    };
    expect_values(data->GetPoints()->GetData(), rounded(frame.points), 3, VTK_FLOAT);
    expect_values(data->GetPointData()->GetArray("velocity"), rounded(std::get<0>(frame.arrays[0].values)), 3,
                  VTK_FLOAT);
    expect_values(data->GetPointData()->GetArray("body"), std::get<1>(frame.arrays[1].values), 1, VTK_INT);
    expect_values(data->GetFieldData()->GetArray("TimeValue"), std::vector<double>{frame.time}, 1, VTK_DOUBLE);
    write_contact(folder / "c.vtp", frame, Reals::float32);
    EXPECT_EQ(read<vtkXMLPolyDataReader>(folder / "c.vtp")->GetPoints()->GetDataType(), VTK_DOUBLE) << "nodes";
    write_particles(folder / "q.vtu", frame);
    EXPECT_LT(std::filesystem::file_size(folder / "p.vtu"), std::filesystem::file_size(folder / "q.vtu"));
}

TEST(WriteFrame, ArraysCarryTheirUnits) {
    TemporaryFolder folder;
    PointFrame frame = sample_frame(10);
    frame.arrays[0].unit = "m/s";
    write_contact(folder / "c.vtp", frame);
    const auto data = read<vtkXMLPolyDataReader>(folder / "c.vtp");
    const auto unit = [&](const char* name) {
        vtkInformation* information = data->GetPointData()->GetArray(name)->GetInformation();
        return information->Has(vtkDataArray::UNITS_LABEL()) ? information->Get(vtkDataArray::UNITS_LABEL()) : "none";
    };
    EXPECT_STREQ(unit("velocity"), "m/s");
    EXPECT_STREQ(unit("body"), "none");
    auto* units = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("units"));
    ASSERT_NE(units, nullptr);
    ASSERT_EQ(units->GetNumberOfValues(), 2);
    EXPECT_EQ(units->GetValue(0), "TimeValue [s]");
    EXPECT_EQ(units->GetValue(1), "velocity [m/s]");
}

} // namespace
} // namespace abut::test

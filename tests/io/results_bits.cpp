// What is written is what VTK reads, bit for bit: values and words at the edges of what there is.
#include "io/results/pvd.h"
#include "io/results/read_frame.h"
#include "io/results/write_frame.h"
#include "results_support.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <gmock/gmock.h>
#include <limits>
#include <random>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace abut::test {
namespace {

/// `count` doubles, all kinds of special ones among them; any bits, so also NaNs with a payload.
std::vector<double> all_kinds(std::size_t count, std::uint64_t seed) {
    using Limits = std::numeric_limits<double>;
    std::vector<double> values{0.0,
                               -0.0,
                               5e-324,
                               -5e-324,
                               2.2250738585072009e-308, // the largest denormal
                               Limits::min(),
                               Limits::max(),
                               Limits::lowest(),
                               Limits::infinity(),
                               -Limits::infinity(),
                               Limits::quiet_NaN(),
                               -Limits::quiet_NaN(),
                               std::bit_cast<double>(0x7ff8dead0000beefULL),
                               0.1,
                               1.0 / 3};
    values.resize(std::min(count, values.size()));
    std::mt19937_64 random(seed);
    while (values.size() < count) {
        const std::uint64_t bits = random();
        // Quiet NaNs only: copying a signalling one may set a bit.
        const auto value = std::bit_cast<double>(bits);
        values.push_back(value != value ? std::bit_cast<double>(bits | 0x0008000000000000ULL) : value);
    }
    return values;
}

std::vector<std::int32_t> all_integers(std::size_t count) {
    std::vector<std::int32_t> values{0, -1, 1, std::numeric_limits<std::int32_t>::min(),
                                     std::numeric_limits<std::int32_t>::max()};
    values.resize(std::min(count, values.size()));
    std::mt19937 random(7);
    while (values.size() < count) values.push_back(static_cast<std::int32_t>(random()));
    return values;
}

const std::vector<std::string> words{
    "block", "",          "a & b",         "<more>", "\"quoted\" 'too'", "Körner 粒 🪨", " ",
    "&lt;",  "a\tb\nc\\", "]]></VTKFile>", ""};

template <class Value>
void expect_bits(vtkDataArray* array, const std::vector<Value>& expected, int type) {
    ASSERT_NE(array, nullptr);
    ASSERT_EQ(array->GetDataType(), type);
    ASSERT_EQ(static_cast<std::size_t>(array->GetNumberOfValues()), expected.size());
    if (expected.empty()) return;
    EXPECT_EQ(std::memcmp(array->GetVoidPointer(0), expected.data(), expected.size() * sizeof(Value)), 0);
}

template <class Value>
void expect_bits(const std::vector<Value>& found, const std::vector<Value>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    if (!expected.empty()) {
        EXPECT_EQ(std::memcmp(found.data(), expected.data(), expected.size() * sizeof(Value)), 0);
    }
}

PointFrame hard_frame(std::size_t points) {
    PointFrame frame;
    frame.time = 5e-324;
    frame.points = all_kinds(3 * points, 1);
    frame.arrays = {{"stress", 6, all_kinds(6 * points, 2)},
                    {"gradient", 9, all_kinds(9 * points, 3)},
                    {"number", 1, all_kinds(points, 4)},
                    {"body", 1, all_integers(points)}};
    frame.globals = {{"spacing", 3, all_kinds(3, 5)}};
    frame.words = {{"body_names", words}};
    return frame;
}

/// What a VTK reader finds in the file.
template <class Reader>
vtkSmartPointer<vtkDataSet> read(const std::filesystem::path& path) {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0U);
    return reader->GetOutput();
}

void expect_arrays(vtkDataSet& data, const std::vector<Array>& arrays) {
    for (const Array& array : arrays) {
        SCOPED_TRACE(array.name);
        vtkDataArray* found = data.GetPointData()->GetArray(array.name.c_str());
        if (const auto* reals = std::get_if<std::vector<double>>(&array.values))
            expect_bits(found, *reals, VTK_DOUBLE);
        else
            expect_bits(found, std::get<std::vector<std::int32_t>>(array.values), VTK_INT);
        if (found) {
            EXPECT_EQ(found->GetNumberOfComponents(), array.components);
        }
    }
}

void expect_fields(vtkDataSet& data, double time) {
    expect_bits(data.GetFieldData()->GetArray("TimeValue"), std::vector<double>{time}, VTK_DOUBLE);
    auto* names = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("body_names"));
    ASSERT_NE(names, nullptr);
    ASSERT_EQ(static_cast<std::size_t>(names->GetNumberOfValues()), words.size());
    for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(names->GetValue(static_cast<vtkIdType>(i)), words[i]);
}

void expect_frame(vtkDataSet& data, const PointFrame& frame) {
    auto& points = dynamic_cast<vtkPointSet&>(data);
    if (!frame.points.empty()) expect_bits(points.GetPoints()->GetData(), frame.points, VTK_DOUBLE);
    expect_arrays(data, frame.arrays);
    expect_fields(data, frame.time);
    expect_bits(data.GetFieldData()->GetArray("spacing"), std::get<0>(frame.globals[0].values), VTK_DOUBLE);
}

/// What we read back ourselves.
void expect_frame(const PointFrame& found, const PointFrame& frame) {
    EXPECT_EQ(found.time, frame.time);
    expect_bits(found.points, frame.points);
    ASSERT_EQ(found.arrays.size(), frame.arrays.size());
    for (std::size_t i = 0; i < frame.arrays.size(); ++i) {
        EXPECT_EQ(found.arrays[i].name, frame.arrays[i].name);
        ASSERT_EQ(found.arrays[i].values.index(), frame.arrays[i].values.index());
        std::visit(
            [&](const auto& values) {
                expect_bits(std::get<std::decay_t<decltype(values)>>(found.arrays[i].values), values);
            },
            frame.arrays[i].values);
    }
    ASSERT_EQ(found.words.size(), 1U);
    EXPECT_EQ(found.words[0].values, words);
}

// The compressor works in blocks of 32768 bytes: sizes at their ends.
constexpr std::size_t sizes[] = {0, 1, 15, 4095, 4096, 4097, 8192, 20000};

TEST(Bits, ParticlesAreReadAsWritten) {
    const TemporaryFolder folder;
    for (const std::size_t size : sizes) {
        SCOPED_TRACE(size);
        const PointFrame frame = hard_frame(size);
        write_particles(folder / "p.vtu", frame);
        expect_frame(*read<vtkXMLUnstructuredGridReader>(folder / "p.vtu"), frame);
        expect_frame(read_points(folder / "p.vtu"), frame);
    }
}

TEST(Bits, SinglePrecisionIsTheNearestFloat) {
    const TemporaryFolder folder;
    const PointFrame frame = hard_frame(4097);
    const auto floats = [](const std::vector<double>& values) {
        return std::vector<float>(values.begin(), values.end());
    };
    write_particles(folder / "p.vtu", frame, Reals::float32);
    const auto data = read<vtkXMLUnstructuredGridReader>(folder / "p.vtu");
    expect_bits(dynamic_cast<vtkPointSet&>(*data).GetPoints()->GetData(), floats(frame.points), VTK_FLOAT);
    for (std::size_t i = 0; i < 3; ++i)
        expect_bits(data->GetPointData()->GetArray(frame.arrays[i].name.c_str()),
                    floats(std::get<0>(frame.arrays[i].values)), VTK_FLOAT);
    expect_bits(data->GetPointData()->GetArray("body"), std::get<1>(frame.arrays[3].values), VTK_INT);
    expect_fields(*data, frame.time); // in full
}

TEST(Bits, ContactIsReadAsWritten) {
    const TemporaryFolder folder;
    for (const std::size_t size : sizes) {
        SCOPED_TRACE(size);
        const PointFrame frame = hard_frame(size);
        write_contact(folder / "c.vtp", frame);
        expect_frame(*read<vtkXMLPolyDataReader>(folder / "c.vtp"), frame);
        expect_frame(read_points(folder / "c.vtp"), frame);
    }
}

TEST(Bits, GridIsReadAsWritten) {
    const TemporaryFolder folder;
    for (const std::array<int, 3>& nodes :
         {std::array{1, 1, 1}, {2, 3, 1}, {4096, 1, 1}, {17, 241, 1}, {16, 16, 16}, {21, 22, 23}}) {
        GridFrame frame;
        frame.time = -0.0;
        frame.nodes = nodes;
        frame.origin = {-1e-3 / 3, 2e-300, -0.0};
        frame.spacing = {1e-6 / 7, 0.1, 1e5 / 3};
        const auto count = static_cast<std::size_t>(nodes[0]) * nodes[1] * nodes[2];
        frame.arrays = {{"velocity", 3, all_kinds(3 * count, 1)},
                        {"mass", 1, all_kinds(count, 2)},
                        {"count", 1, all_integers(count)}};
        frame.words = {{"body_names", words}};
        write_grid(folder / "g.vti", frame);
        const auto data = read<vtkXMLImageDataReader>(folder / "g.vti");
        expect_arrays(*data, frame.arrays);
        expect_fields(*data, frame.time);
        auto& image = dynamic_cast<vtkImageData&>(*data);
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            EXPECT_EQ(image.GetDimensions()[axis], nodes[a]);
            EXPECT_EQ(image.GetOrigin()[axis], frame.origin[a]);
            EXPECT_EQ(image.GetSpacing()[axis], frame.spacing[a]);
        }
        const GridFrame back = read_grid(folder / "g.vti");
        ASSERT_EQ(back.arrays.size(), 3U);
        expect_bits(std::get<0>(back.arrays[0].values), std::get<0>(frame.arrays[0].values));
        expect_bits(std::get<1>(back.arrays[2].values), std::get<1>(frame.arrays[2].values));
        EXPECT_EQ(back.origin, frame.origin);
        EXPECT_EQ(back.words.at(0).values, words);
    }
}

TEST(Bits, SeriesAreReadAsWritten) {
    const TemporaryFolder folder;
    PvdSeries series{folder / "p.pvd", {}};
    const std::vector<double> times{-0.0, 2.3e-308, 1e-300, 1e-15 / 3,
                                    0.1,  1.0 / 3,  1e22,   std::numeric_limits<double>::max()};
    const std::vector<std::string> files{"a & b", "<c>", "\"d\" 'e'", "Körner 粒", "&amp;", "f  g", "#%20", "h"};
    for (std::size_t i = 0; i < times.size(); ++i) series.append(times[i], files[i]);
    const PvdSeries back = read_pvd(folder / "p.pvd");
    ASSERT_EQ(back.entries.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back.entries[i].time), std::bit_cast<std::uint64_t>(times[i])) << i;
        EXPECT_EQ(back.entries[i].file, files[i]);
    }
}

} // namespace
} // namespace abut::test

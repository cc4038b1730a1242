// Stacks: pages of a TIFF, slices of a VTI volume, numbered files.
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>
#include <vtkXMLImageDataWriter.h>

#include <array>
#include <memory>

using namespace test; // NOLINT(google-build-using-namespace)
using abut::Image;
using abut::read_image;
using abut::read_stack;
using abut::read_stack_info;
using abut::StackInfo;
using testing::HasSubstr;
using Values = std::vector<std::uint16_t>;

namespace {

/// Slice z of a stack of 3 x 2 pixels.
Image slice(int z, int bits = 8) {
    Image image{3, 2, 1, {}, bits};
    for (int k = 0; k < 6; ++k) image.pixels.push_back(static_cast<std::uint16_t>(10 * z + k + (bits == 16 ? 300 : 0)));
    return image;
}

std::vector<Values> all_of(const std::filesystem::path& file, int first, int last) {
    std::vector<Values> slices;
    read_stack(file, first, last, [&](int z, const Image& image) {
        EXPECT_EQ(z, first + static_cast<int>(slices.size()));
        slices.push_back(image.pixels);
    });
    return slices;
}

std::string stack_error(const std::filesystem::path& file) {
    return message_of([&] { read_stack_info(file); });
}

/// A volume of nx x ny x nz numbers x + 10 y + 100 z (x, y, z from 0), on points or cells.
template <class ArrayType>
void write_vti(const std::filesystem::path& file, bool on_cells, int mode, bool compressed, int nz = 4,
               int components = 1) {
    vtkNew<vtkImageData> data;
    const int more = on_cells ? 1 : 0;
    data->SetExtent(5, 5 + 2 + more, -2, -2 + 1 + more, 7, 7 + nz - 1 + more);
    data->SetSpacing(0.5, 0.25, 2);
    vtkNew<ArrayType> array;
    array->SetName("material");
    array->SetNumberOfComponents(components);
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x)
                for (int c = 0; c < components; ++c) array->InsertNextValue(x + 10 * y + 50 * z + c);
    if (on_cells)
        data->GetCellData()->AddArray(array);
    else
        data->GetPointData()->SetScalars(array);
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(data);
    writer->SetDataMode(mode);
    if (!compressed) writer->SetCompressor(nullptr);
    writer->Write();
}

} // namespace

TEST(ImageStack, SinglePictureIsAStackOfOne) {
    const Folder folder;
    for (const char* name : {"a.png", "a.bmp", "a.tif"}) {
        abut::write_image(slice(2), folder.path / name);
        const StackInfo info = read_stack_info(folder.path / name);
        EXPECT_EQ(info.width, 3);
        EXPECT_EQ(info.height, 2);
        EXPECT_EQ(info.slices, 1);
        EXPECT_EQ(info.bits, 8);
        EXPECT_FALSE(info.spacing);
        EXPECT_EQ(all_of(folder.path / name, 0, 0).size(), 1U);
    }
    EXPECT_EQ(all_of(folder.path / "a.png", 0, 0)[0], slice(2).pixels);
}

TEST(ImageStack, PagesOfATiff) {
    const Folder folder;
    for (const int bits : {8, 16}) {
        abut::write_stack(
            7, [&](int z) { return slice(z, bits); }, folder.path / "a.tif");
        const StackInfo info = read_stack_info(folder.path / "a.tif");
        EXPECT_EQ(info.slices, 7);
        EXPECT_EQ(info.bits, bits);
        const std::vector<Values> slices = all_of(folder.path / "a.tif", 2, 5);
        ASSERT_EQ(slices.size(), 4U);
        for (int z = 2; z <= 5; ++z) EXPECT_EQ(slices[static_cast<std::size_t>(z - 2)], slice(z, bits).pixels);
        EXPECT_THAT(message_of([&] { read_image(folder.path / "a.tif"); }),
                    HasSubstr("is a stack of 7 slices; for a plane scene, choose one by \"slice\""));
        EXPECT_THAT(message_of([&] { all_of(folder.path / "a.tif", 0, 7); }), HasSubstr("has the slices 0 to 6"));
        EXPECT_THAT(message_of([&] { all_of(folder.path / "a.tif", -1, 2); }), HasSubstr("has the slices 0 to 6"));
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1) << "no temporary file stays";
}

TEST(ImageStack, PagesMustAgree) {
    const Folder folder;
    Bytes file = test::tiff(2, 1, 8, 1, 1, {5, 6});
    const auto second = static_cast<std::uint32_t>(file.size());
    file = test::tiff(2, 1, 8, 1, 1, {5, 6}, 0, {}, -1, second);
    const Bytes other = test::tiff(1, 1, 8, 1, 1, {5, 6});
    append(file, Bytes(other.begin() + other[4], other.end()));
    EXPECT_THAT(stack_error(folder.write("a.tif", file)),
                HasSubstr("unequal slices: page 2 has 1 x 1 pixels of 8 bits, the first has 2 x 1 pixels of 8 bits"));
}

TEST(ImageStack, ErrorsOfTheVisitorStayAsTheyAre) {
    const Folder folder;
    abut::write_stack(
        2, [](int z) { return slice(z); }, folder.path / "a.tif");
    EXPECT_EQ(message_of([&] {
                  read_stack(folder.path / "a.tif", 0, 1, [](int, const Image&) { throw std::runtime_error("mine"); });
              }),
              "mine");
}

TEST(ImageStack, WritingFailsWithoutAFile) {
    const Folder folder;
    const auto unequal = [](int z) { return z == 1 ? Image{1, 1, 1, {0}} : slice(z); };
    EXPECT_THAT(message_of([&] { abut::write_stack(2, unequal, folder.path / "a.tif"); }),
                HasSubstr("slice 1 differs in size or depth from slice 0"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path));
    EXPECT_THAT(message_of([&] { abut::write_stack(2, unequal, folder.path / "a.png"); }),
                HasSubstr("must end in .tif"));
}

TEST(ImageStack, VtiVolume) {
    const Folder folder;
    for (const bool on_cells : {false, true})
        for (const bool compressed : {false, true})
            for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
                SCOPED_TRACE(testing::Message() << on_cells << compressed << mode);
                write_vti<vtkUnsignedShortArray>(folder.path / "a.vti", on_cells, mode, compressed);
                const StackInfo info = read_stack_info(folder.path / "a.vti");
                EXPECT_EQ(info.width, 3);
                EXPECT_EQ(info.height, 2);
                EXPECT_EQ(info.slices, 4);
                EXPECT_EQ(info.bits, 16);
                ASSERT_TRUE(info.spacing);
                EXPECT_EQ(*info.spacing, (std::array<double, 3>{0.5, 0.25, 2}));
                const std::vector<Values> slices = all_of(folder.path / "a.vti", 1, 3);
                ASSERT_EQ(slices.size(), 3U);
                EXPECT_EQ(slices[0], (Values{60, 61, 62, 50, 51, 52})); // largest y on top
                EXPECT_EQ(slices[2], (Values{160, 161, 162, 150, 151, 152}));
            }
}

TEST(ImageStack, VtiPlaneOfBytesIsAPicture) {
    const Folder folder;
    write_vti<vtkUnsignedCharArray>(folder.path / "a.vti", false, vtkXMLWriter::Appended, true, 1, 3);
    const Image image = read_image(folder.path / "a.vti");
    EXPECT_EQ(image.bits, 8);
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.pixels, (Values{10, 11, 12, 11, 12, 13, 12, 13, 14, 0, 1, 2, 1, 2, 3, 2, 3, 4}));
}

TEST(ImageStack, VtiKindsRefusedByName) {
    const Folder folder;
    write_vti<vtkFloatArray>(folder.path / "a.vti", false, vtkXMLWriter::Appended, true);
    EXPECT_THAT(stack_error(folder.path / "a.vti"), HasSubstr("has floating point numbers in its array \"material\""));
    write_vti<vtkUnsignedCharArray>(folder.path / "a.vti", false, vtkXMLWriter::Appended, true, 2, 2);
    EXPECT_THAT(stack_error(folder.path / "a.vti"), HasSubstr("has 2 components in its array"));
}

TEST(ImageStack, NumberedFilesInTheOrderOfTheirNumbers) {
    const Folder folder;
    for (int z = 8; z <= 11; ++z) abut::write_image(slice(z), folder.path / ("ct_" + std::to_string(z) + ".png"));
    folder.write("ct_x.png", {1});
    folder.write("ct_.png", {1});
    folder.write("ct_9.png.bak", {1});
    const std::filesystem::path pattern = folder.path / "ct_*.png";
    EXPECT_EQ(read_stack_info(pattern).slices, 4);
    const std::vector<Values> slices = all_of(pattern, 1, 3);
    ASSERT_EQ(slices.size(), 3U);
    for (int z = 9; z <= 11; ++z) EXPECT_EQ(slices[static_cast<std::size_t>(z - 9)], slice(z).pixels);
    EXPECT_THAT(message_of([&] { read_image(pattern); }), HasSubstr("is a stack of 4 slices"));
}

TEST(ImageStack, NoMatchNamesWhatComesNear) {
    const Folder folder;
    const auto error = [&](const std::string& pattern) { return stack_error(folder.path / pattern); };
    EXPECT_THAT(error("ct_*.png"), HasSubstr("matches no file (\"*\" stands for digits only); the folder has none"));
    for (const char* name : {"b.png", "ct_1.tif", "ct_4.tif", "ct_2.tif", "ct_3.tif", "other.txt"})
        folder.write(name, {1});
    EXPECT_THAT(error("ct_*.png"), testing::EndsWith("; the folder has ct_1.tif, ct_2.tif, ct_3.tif and 1 more"));
    EXPECT_THAT(error("slice*.png"), testing::EndsWith("; the folder has b.png"));
    EXPECT_THAT(error("*.bmp"), testing::EndsWith("; the folder has none that comes near"));
    folder.write("CT_0007.PNG", {1}); // capitals
    EXPECT_THAT(error("ct_*.png"), testing::EndsWith("; the folder has CT_0007.PNG"));
    EXPECT_THAT(error("none/ct_*.png"), HasSubstr("is in a folder that does not exist"));
}

TEST(ImageStack, ImageJBeyondFourGigabytes) {
    const Folder folder;
    const auto with_description = [&](const std::string& text) {
        const std::filesystem::path file = folder.path / "a.tif";
        const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(file.c_str(), "w"), TIFFClose);
        TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, 2);
        TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, 1);
        TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 8);
        TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, text.c_str());
        std::array<std::uint8_t, 2> row{5, 6};
        TIFFWriteScanline(tiff.get(), row.data(), 0, 0);
        return file;
    };
    EXPECT_THAT(stack_error(with_description("ImageJ=1.53t\nimages=600\nslices=600\nloop=false\n")),
                HasSubstr("is a stack of 600 slices of which only the first is a TIFF page, as ImageJ writes"));
    EXPECT_EQ(read_stack_info(with_description("ImageJ=1.53t\nunit=um\n")).slices, 1);
    EXPECT_EQ(read_stack_info(with_description("ImageJ=1.53t\nimages=1\n")).slices, 1);
    EXPECT_EQ(read_stack_info(with_description("mine\nimages=7\n")).slices, 1);
}

TEST(ImageStack, NumberedFilesThatDoNotFit) {
    const Folder folder;
    const std::filesystem::path pattern = folder.path / "ct_*.png";
    for (const int z : {15, 16, 18}) abut::write_image(slice(1), folder.path / ("ct_00" + std::to_string(z) + ".png"));
    EXPECT_THAT(stack_error(pattern), HasSubstr("slice 17 is missing between ct_0016.png and ct_0018.png"));
    abut::write_image({1, 1, 1, {7}}, folder.path / "ct_17.png");
    EXPECT_THAT(stack_error(pattern),
                HasSubstr("ct_17.png has 1 x 1 pixels of 8 bits, ct_0015.png has 3 x 2 of 8 bits"));
    abut::write_image(slice(1), folder.path / "ct_0017.png");
    EXPECT_THAT(stack_error(pattern), HasSubstr("two files with the number 17: ct_0017.png and ct_17.png"));
    EXPECT_THAT(stack_error(folder.path / "*_*.png"), HasSubstr("must have a single \"*\""));
}

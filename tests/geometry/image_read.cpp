// Reading pictures: every format, which way is up, and everything that can be wrong with a file.
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkBMPWriter.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTIFFWriter.h>

using namespace test; // NOLINT(google-build-using-namespace)
using abut::Image;
using abut::read_image;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// 3 × 2 grey pixels 1 2 3 / 4 5 6, encoded by Pillow 9.4 (libjpeg, quality 100).
const char* const jpeg_hex = "ffd8ffe000104a46494600010100000100010000ffdb004300010101010101010101010101010101010101010"
                             "1010101010101010101010101010101"
                             "0101010101010101010101010101010101010101010101010101010101ffc0000b080002000301011100ffc40"
                             "01f0000010501010101010100000000"
                             "000000000102030405060708090a0bffc400b5100002010303020403050504040000017d01020300041105122"
                             "131410613516107227114328191a108"
                             "2342b1c11552d1f02433627282090a161718191a25262728292a3435363738393a434445464748494a5354555"
                             "65758595a636465666768696a737475"
                             "767778797a838485868788898a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5c"
                             "6c7c8c9cad2d3d4d5d6d7d8d9dae1e2"
                             "e3e4e5e6e7e8e9eaf1f2f3f4f5f6f7f8f9faffda0008010100003f00fe0a638e3d8bfbb4e9fdd5ff000affd9";

Bytes from_hex(const std::string& text) {
    Bytes bytes;
    for (std::size_t i = 0; i < text.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
    return bytes;
}

/// 3 × 2 pixels, grey or RGB. VTK's first row is the lowest, so this picture shows 1 2 3 above 4 5 6.
template <class Writer>
void write_with_vtk(const std::filesystem::path& file, int channels) {
    vtkNew<vtkImageData> data;
    data->SetDimensions(3, 2, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
    const int rows_from_below[2][3] = {{4, 5, 6}, {1, 2, 3}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            for (int c = 0; c < channels; ++c)
                data->SetScalarComponentFromDouble(x, y, 0, c, rows_from_below[y][x] * (channels == 1 ? 1 : c + 1));
    vtkNew<Writer> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(data);
    writer->Write();
}

std::string error_for(const std::string& name, const Bytes& bytes) {
    const Folder folder;
    const std::filesystem::path file = folder.write(name, bytes);
    testing::internal::CaptureStderr();
    std::string message = message_of([&] { read_image(file); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "libraries must not print";
    EXPECT_THAT(message, HasSubstr("image \"" + file.string() + "\" "));
    return message;
}

Bytes first_half(Bytes bytes) {
    bytes.resize(bytes.size() / 2);
    return bytes;
}

Image read(const Bytes& bytes) {
    const Folder folder;
    return read_image(folder.write("picture", bytes)); // the name doesn't matter
}

using Values = std::vector<std::uint16_t>;
const Values grey_rows{1, 2, 3, 4, 5, 6};
const Values rgb_rows{10, 20, 30, 11, 21, 31, 12, 22, 32, 13, 23, 33, 14, 24, 34, 15, 25, 35};
const Bytes grey_bytes(grey_rows.begin(), grey_rows.end());
const Bytes rgb_bytes(rgb_rows.begin(), rgb_rows.end());
const std::vector<Bytes> rgb_lines{{10, 20, 30, 11, 21, 31, 12, 22, 32}, {13, 23, 33, 14, 24, 34, 15, 25, 35}};

} // namespace

// === Which way is up: bytes made by hand

TEST(ReadImage, PngGreyIsTopRowFirst) {
    const Image image = read(png(3, 8, 0, {{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(image.channels, 1);
    EXPECT_EQ(image.pixels, grey_rows);
    EXPECT_THAT(image.rgb(0, 1), ElementsAre(4, 4, 4));
}

TEST(ReadImage, PngRgbIsTopRowFirst) {
    const Image image = read(png(3, 8, 2, rgb_lines));
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.pixels, rgb_rows);
    EXPECT_THAT(image.rgb(1, 1), ElementsAre(14, 24, 34));
}

TEST(ReadImage, PngPaletteBecomesRgb) {
    const Bytes palette = png_chunk("PLTE", {10, 20, 30, 40, 50, 60, 70, 80, 90});
    const Values expected{40, 50, 60, 70, 80, 90, 10, 20, 30, 10, 20, 30, 40, 50, 60, 70, 80, 90};
    EXPECT_EQ(read(png(3, 8, 3, {{1, 2, 0}, {0, 1, 2}}, palette)).pixels, expected);
    const Bytes two_bits = png(3, 2, 3, {{0b01100000}, {0b00011000}}, palette);
    EXPECT_EQ(read(two_bits).pixels, expected);
}

TEST(ReadImage, PngOfOneBitIsBlackAndWhite) {
    EXPECT_EQ(read(png(3, 1, 0, {{0b10100000}, {0b01000000}})).pixels, (Values{255, 0, 255, 0, 255, 0}));
}

TEST(ReadImage, BmpRowsComeFromBelowUnlessTheHeightIsNegative) {
    const Bytes up = bmp(3, 2, 24, {{33, 23, 13, 34, 24, 14, 35, 25, 15}, {30, 20, 10, 31, 21, 11, 32, 22, 12}});
    const Bytes down = bmp(3, -2, 24, {{30, 20, 10, 31, 21, 11, 32, 22, 12}, {33, 23, 13, 34, 24, 14, 35, 25, 15}});
    EXPECT_EQ(read(up).pixels, rgb_rows);
    EXPECT_EQ(read(down).pixels, rgb_rows);
}

TEST(ReadImage, BmpPaletteOfEveryDepthAndHeaderVersion) {
    const Bytes palette{30, 20, 10, 0, 60, 50, 40, 0}; // blue, green, red, unused
    const Values expected{40, 50, 60, 10, 20, 30, 40, 50, 60, 10, 20, 30, 40, 50, 60, 10, 20, 30};
    for (const std::uint32_t header : {40u, 108u, 124u}) {
        EXPECT_EQ(read(bmp(3, 2, 8, {{0, 1, 0}, {1, 0, 1}}, palette, 0, header)).pixels, expected);
        EXPECT_EQ(read(bmp(3, 2, 4, {{0x01, 0x00}, {0x10, 0x10}}, palette, 0, header)).pixels, expected);
        EXPECT_EQ(read(bmp(3, 2, 1, {{0b01000000}, {0b10100000}}, palette, 0, header)).pixels, expected);
    }
}

TEST(ReadImage, BmpOf32BitsWithAndWithoutAlpha) {
    Bytes masks;
    for (const std::uint32_t mask : {0xff0000u, 0xff00u, 0xffu, 0xff000000u}) append(masks, little(mask, 4));
    EXPECT_EQ(read(bmp(1, 1, 32, {{30, 20, 10, 0}})).pixels, (Values{10, 20, 30}));
    EXPECT_EQ(read(bmp(1, 1, 32, {{30, 20, 10, 255}}, {}, 3, 124, masks)).pixels, (Values{10, 20, 30}));
    EXPECT_THAT(error_for("a.bmp", bmp(1, 1, 32, {{30, 20, 10, 7}}, {}, 3, 124, masks)),
                HasSubstr("has transparency at 1 pixel; flatten it"));
}

TEST(ReadImage, TiffGreyRgbPaletteAndBilevelAreTopRowFirst) {
    EXPECT_EQ(read(tiff(3, 2, 8, 1, 1, grey_bytes)).pixels, grey_rows);
    EXPECT_EQ(read(tiff(3, 2, 8, 1, 1, grey_bytes)).channels, 1);
    EXPECT_EQ(read(tiff(3, 2, 8, 3, 2, rgb_bytes)).pixels, rgb_rows);
    std::vector<std::uint16_t> palette(768, 0);
    for (std::size_t index = 0; index < 3; ++index)
        for (std::size_t c = 0; c < 3; ++c)
            palette[256 * c + index] = static_cast<std::uint16_t>((30 * index + 10 * (c + 1)) * 257);
    EXPECT_EQ(read(tiff(3, 1, 8, 1, 3, {1, 2, 0}, 0, palette)).pixels, (Values{40, 50, 60, 70, 80, 90, 10, 20, 30}));
    EXPECT_EQ(read(tiff(3, 2, 1, 1, 1, {0b10100000, 0b01000000})).pixels, (Values{255, 0, 255, 0, 255, 0}));
    EXPECT_EQ(read(tiff(3, 2, 8, 1, 0, {254, 253, 252, 251, 250, 249})).pixels, grey_rows); // white is 0
}

TEST(ReadImage, TiffOrientationIsFollowed) {
    constexpr int bottom_left = 4;
    EXPECT_EQ(read(tiff(3, 2, 8, 1, 1, {4, 5, 6, 1, 2, 3}, bottom_left)).pixels, grey_rows);
    EXPECT_EQ(read(tiff(3, 2, 8, 3, 2, rgb_bytes, 1)).pixels, rgb_rows);
}

TEST(ReadImage, JpegIsTopRowFirst) {
    const Image image = read(from_hex(jpeg_hex));
    EXPECT_EQ(image.channels, 1);
    EXPECT_EQ(image.pixels, grey_rows);
}

// === The same, written by VTK

TEST(ReadImage, WhatVtkWrites) {
    const Folder folder;
    write_with_vtk<vtkPNGWriter>(folder.path / "a.png", 1);
    EXPECT_EQ(read_image(folder.path / "a.png").pixels, grey_rows);
    write_with_vtk<vtkTIFFWriter>(folder.path / "a.tif", 1);
    EXPECT_EQ(read_image(folder.path / "a.tif").pixels, grey_rows);
    write_with_vtk<vtkJPEGWriter>(folder.path / "a.jpg", 1);
    const Image jpeg = read_image(folder.path / "a.jpg");
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(jpeg.pixels[k], grey_rows[k], 2);

    const Values rgb{1, 2, 3, 2, 4, 6, 3, 6, 9, 4, 8, 12, 5, 10, 15, 6, 12, 18};
    write_with_vtk<vtkPNGWriter>(folder.path / "c.png", 3);
    EXPECT_EQ(read_image(folder.path / "c.png").pixels, rgb);
    write_with_vtk<vtkBMPWriter>(folder.path / "c.bmp", 3);
    EXPECT_EQ(read_image(folder.path / "c.bmp").pixels, rgb);
    write_with_vtk<vtkTIFFWriter>(folder.path / "c.tif", 3);
    EXPECT_EQ(read_image(folder.path / "c.tif").pixels, rgb);
}

// === Alpha

TEST(ReadImage, OpaqueAlphaIsDropped) {
    EXPECT_EQ(read(png(2, 8, 4, {{7, 255, 8, 255}})).pixels, (Values{7, 8}));
    EXPECT_EQ(read(png(1, 8, 6, {{1, 2, 3, 255}})).pixels, (Values{1, 2, 3}));
    EXPECT_EQ(read(tiff(1, 1, 8, 4, 2, {1, 2, 3, 255}, 0, {}, 2)).pixels, (Values{1, 2, 3}));
    EXPECT_EQ(read(tiff(2, 1, 8, 2, 1, {7, 255, 8, 255}, 0, {}, 2)).pixels, (Values{7, 8}));
}

TEST(ReadImage, TransparencyIsAnErrorWithItsPixels) {
    const std::string expected = "has transparency at 2 pixels; flatten it (remove its alpha channel)";
    EXPECT_THAT(error_for("a.png", png(3, 8, 4, {{7, 255, 8, 0, 9, 254}})), HasSubstr(expected));
    EXPECT_THAT(error_for("a.tif", tiff(2, 1, 8, 4, 2, {1, 2, 3, 0, 4, 5, 6, 9}, 0, {}, 2)), HasSubstr(expected));
    const Bytes palette_with_alpha = [] {
        Bytes chunks = png_chunk("PLTE", {10, 20, 30, 40, 50, 60});
        append(chunks, png_chunk("tRNS", {0}));
        return chunks;
    }();
    EXPECT_THAT(error_for("a.png", png(3, 8, 3, {{0, 1, 0}}, palette_with_alpha)), HasSubstr(expected));
}

// === Files that cannot be read

TEST(ReadImage, MissingFileFolderAndEmptyFile) {
    const Folder folder;
    const auto error = [](const std::filesystem::path& file) { return message_of([&] { read_image(file); }); };
    EXPECT_EQ(error(folder.path / "bed.png"), "image \"" + (folder.path / "bed.png").string() + "\" does not exist");
    EXPECT_THAT(error(folder.path), HasSubstr("is a folder, not a file"));
    EXPECT_THAT(error_for("a.png", {}), HasSubstr("is empty (0 bytes)"));
}

TEST(ReadImage, OtherFormats) {
    const std::string text = "this is no picture at all, whatever its name says";
    EXPECT_THAT(error_for("a.png", Bytes(text.begin(), text.end())),
                HasSubstr("is not a PNG, BMP, TIFF, JPEG or VTI picture"));
    EXPECT_THAT(error_for("a.gif", {'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0, 0, 0, 0}),
                HasSubstr("is a GIF picture; save it as PNG"));
    EXPECT_THAT(error_for("a.png", {'%', 'P', 'D', 'F', '-', '1'}), HasSubstr("is a PDF document"));
    const std::string svg = "<?xml version='1.0'?><svg width='3'/>";
    EXPECT_THAT(error_for("a.svg", Bytes(svg.begin(), svg.end())), HasSubstr("is an SVG drawing; save it as PNG"));
    const std::string webp("RIFF\x10\0\0\0WEBPVP8 ", 16);
    EXPECT_THAT(error_for("a.png", Bytes(webp.begin(), webp.end())), HasSubstr("is a WebP picture"));
    Bytes dicom(128, 0);
    append(dicom, {'D', 'I', 'C', 'M', 2, 0});
    EXPECT_THAT(error_for("a.dcm", dicom), HasSubstr("is a DICOM file"));
}

TEST(ReadImage, DamagedPng) {
    Bytes file = png(3, 8, 0, {{1, 2, 3}, {4, 5, 6}});
    EXPECT_THAT(error_for("a.png", first_half(file)), HasSubstr("is incomplete: the PNG file ends too early"));
    EXPECT_THAT(error_for("a.png", Bytes(file.begin(), file.begin() + 8)), HasSubstr("ends too early"));
    EXPECT_THAT(error_for("a.png", Bytes(file.begin(), file.end() - 12)), HasSubstr("ends too early"));
    file[50] ^= 1;
    EXPECT_THAT(error_for("a.png", file), HasSubstr("is damaged: a PNG check sum is wrong"));
    EXPECT_THAT(error_for("a.png", png(3, 8, 3, {{1, 2, 0}})), HasSubstr("lacks its palette"));
    EXPECT_THAT(error_for("a.png", png(0, 8, 0, {{}})), HasSubstr("has no pixels (its width or height is 0)"));
}

TEST(ReadImage, DamagedOrUnsupportedBmp) {
    const Bytes file = bmp(3, 2, 24, {Bytes(9, 1), Bytes(9, 2)});
    EXPECT_THAT(error_for("a.bmp", Bytes(file.begin(), file.end() - 1)), HasSubstr("the BMP file ends too early"));
    EXPECT_THAT(error_for("a.bmp", Bytes(file.begin(), file.begin() + 20)), HasSubstr("the BMP file ends too early"));
    const Bytes run_length = bmp(3, 2, 8, {{3, 1, 0, 0, 3, 2, 0, 1}}, Bytes(16, 0), 1);
    EXPECT_THAT(error_for("a.bmp", run_length),
                HasSubstr("is a run-length compressed (RLE) BMP; save it uncompressed"));
    EXPECT_THAT(error_for("a.bmp", bmp(1, 1, 16, {{1, 2}})), HasSubstr("is a BMP of 16 bits per pixel"));
    EXPECT_THAT(error_for("a.bmp", bmp(0, 1, 24, {})), HasSubstr("has no pixels"));
    EXPECT_THAT(error_for("a.bmp", bmp(2, 1, 8, {{0, 9}}, Bytes(8, 0))), HasSubstr("not in the palette"));
}

TEST(ReadImage, DamagedJpegAndTiff) {
    EXPECT_THAT(error_for("a.jpg", first_half(from_hex(jpeg_hex))), HasSubstr("is damaged or incomplete"));
    const Bytes file = tiff(3, 2, 8, 1, 1, grey_bytes);
    EXPECT_THAT(error_for("a.tif", first_half(file)), HasSubstr("is damaged or incomplete"));
    Bytes cut = tiff(3, 200, 8, 1, 1, grey_bytes); // claims more rows than there are
    EXPECT_THAT(error_for("a.tif", cut), HasSubstr("is damaged or incomplete"));
}

TEST(ReadImage, TiffStack) {
    Bytes two = tiff(1, 1, 8, 1, 1, {5});
    const auto second = static_cast<std::uint32_t>(two.size());
    two = tiff(1, 1, 8, 1, 1, {5}, 0, {}, -1, second);
    const Bytes again = tiff(1, 1, 8, 1, 1, {5});
    const std::size_t directory = again[4];
    append(two, Bytes(again.begin() + static_cast<std::ptrdiff_t>(directory), again.end()));
    EXPECT_THAT(error_for("a.tif", two),
                HasSubstr("is a stack of 2 slices; for a plane scene, choose one by \"slice\""));
}

// === Writing

TEST(WriteImage, ComesBackAsItWas) {
    const Folder folder;
    const Image grey{3, 2, 1, grey_rows};
    abut::write_image(grey, folder.path / "a.png");
    EXPECT_EQ(read_image(folder.path / "a.png").pixels, grey_rows);
    const Image rgb{3, 2, 3, rgb_rows};
    abut::write_image(rgb, folder.path / "a.BMP");
    EXPECT_EQ(read_image(folder.path / "a.BMP").pixels, rgb_rows);
    abut::write_image(rgb, folder.path / "a.tiff");
    EXPECT_EQ(read_image(folder.path / "a.tiff").pixels, rgb_rows);
    const Image deep{2, 1, 1, {300, 65535}, 16};
    for (const char* name : {"deep.png", "deep.tif"}) {
        abut::write_image(deep, folder.path / name);
        const Image back = read_image(folder.path / name);
        EXPECT_EQ(back.bits, 16);
        EXPECT_EQ(back.pixels, deep.pixels);
    }
    EXPECT_THAT(message_of([&] { abut::write_image(deep, folder.path / "deep.bmp"); }),
                HasSubstr("BMP holds 8 bits, the picture has 16"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 5) << "no temporary file stays";
}

TEST(WriteImage, RefusesOtherExtensionsAndMissingFolders) {
    const Folder folder;
    const Image image{1, 1, 1, {7}};
    const auto error = [&](const std::filesystem::path& file) {
        return message_of([&] { abut::write_image(image, file); });
    };
    EXPECT_THAT(error(folder.path / "a.gif"), HasSubstr("must end in .png, .bmp or .tif"));
    testing::internal::CaptureStderr();
    EXPECT_THAT(error(folder.path / "none" / "a.png"), HasSubstr("cannot write"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

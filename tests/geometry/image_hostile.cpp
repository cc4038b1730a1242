// Damaged and lying files: seeds of every format, mutated at random (seeded). Each must give a picture or a
// std::runtime_error, in bounded time and memory, with nothing printed.
#include "image_hostile_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkXMLImageDataWriter.h>

#include <cstring>
#include <memory>
#include <random>

using namespace test; // NOLINT(google-build-using-namespace)
using abut::Image;
using testing::HasSubstr;

namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t count) {
    return random() % count;
}

Bytes contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// 24 x 20 pixels that do not repeat.
Image pattern(int channels, int bits, int slice = 0) {
    Image image{24, 20, channels, {}, bits};
    for (int k = 0; k < 24 * 20 * channels; ++k)
        image.pixels.push_back(static_cast<std::uint16_t>((k * 37 + k * k * 11 + slice * 5) & ((1 << bits) - 1)));
    return image;
}

void write_tiled(const std::filesystem::path& file, int compression, int photometric) {
    const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(file.c_str(), "w"), TIFFClose);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, 40);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, 24);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, photometric == PHOTOMETRIC_MINISBLACK ? 1 : 3);
    TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, photometric);
    TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, compression);
    if (compression == COMPRESSION_JPEG) TIFFSetField(tiff.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    TIFFSetField(tiff.get(), TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(tiff.get(), TIFFTAG_TILELENGTH, 16);
    Bytes tile(16 * 16 * 3);
    for (std::size_t k = 0; k < tile.size(); ++k) tile[k] = static_cast<std::uint8_t>(k * k);
    for (std::uint32_t y = 0; y < 24; y += 16)
        for (std::uint32_t x = 0; x < 40; x += 16) TIFFWriteTile(tiff.get(), tile.data(), x, y, 0, 0);
}

/// 40 x 24 pixels of 1 bit in one strip.
void write_bilevel(const std::filesystem::path& file, int compression) {
    const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(file.c_str(), "w"), TIFFClose);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, 40);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, 24);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 1);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE);
    TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, compression);
    TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, 24);
    Bytes rows(24 * 5);
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = static_cast<std::uint8_t>(k * k);
    TIFFWriteEncodedStrip(tiff.get(), 0, rows.data(), static_cast<tmsize_t>(rows.size()));
}

void write_vti(const std::filesystem::path& file, int mode, bool compressed) {
    vtkNew<vtkImageData> data;
    data->SetDimensions(12, 10, 3);
    data->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
    for (int k = 0; k < 360; ++k)
        static_cast<std::uint16_t*>(data->GetScalarPointer())[k] = static_cast<std::uint16_t>(k);
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(data);
    writer->SetDataMode(mode);
    if (!compressed) writer->SetCompressor(nullptr);
    writer->Write();
}

std::vector<Bytes> seeds_of(const std::string& format, const Folder& folder) {
    const std::filesystem::path file = folder.path / ("seed." + format);
    std::vector<Bytes> seeds;
    const auto keep = [&] { seeds.push_back(contents(file)); };
    if (format == "png" || format == "bmp" || format == "tif")
        for (const int channels : {1, 3})
            for (const int bits : {8, 16})
                if (bits == 8 || format != "bmp") {
                    abut::write_image(pattern(channels, bits), file);
                    keep();
                }
    if (format == "png") {
        const Bytes palette = png_chunk("PLTE", {10, 20, 30, 40, 50, 60, 70, 80, 90});
        seeds.push_back(png(3, 2, 3, {{0b01100000}, {0b00011000}}, palette));
        seeds.push_back(png(3, 8, 4, {{1, 255, 2, 255, 3, 255}}));
    }
    if (format == "bmp") seeds.push_back(bmp(3, 2, 4, {{0x01, 0x00}, {0x10, 0x10}}, Bytes(64, 77)));
    if (format == "tif") {
        abut::write_stack(
            3, [](int slice) { return pattern(1, 8, slice); }, file);
        keep();
        for (const int compression : {COMPRESSION_NONE, COMPRESSION_PACKBITS, COMPRESSION_ADOBE_DEFLATE,
                                      COMPRESSION_LZMA, COMPRESSION_ZSTD, COMPRESSION_LERC}) {
            write_tiled(file, compression, PHOTOMETRIC_MINISBLACK);
            keep();
        }
        write_tiled(file, COMPRESSION_JPEG, PHOTOMETRIC_YCBCR);
        keep();
        write_tiled(file, COMPRESSION_WEBP, PHOTOMETRIC_RGB);
        keep();
        for (const int compression : {COMPRESSION_CCITTRLE, COMPRESSION_CCITTFAX3, COMPRESSION_CCITTFAX4}) {
            write_bilevel(file, compression);
            keep();
        }
        seeds.push_back(test::tiff(4, 2, 2, 1, 1, {0, 0x1b, 0, 0xe4}, 0, {}, -1, 0, COMPRESSION_NEXT));
        seeds.push_back(test::tiff(2, 2, 4, 1, 1, {0xc1, 0xcf, 0xc7, 0x01}, 0, {}, -1, 0, COMPRESSION_THUNDERSCAN));
        seeds.push_back(test::tiff(3, 2, 8, 1, 3, {1, 2, 0, 0, 1, 2}, 0, std::vector<std::uint16_t>(768, 257)));
    }
    if (format == "jpg") {
        vtkNew<vtkImageData> data;
        data->SetDimensions(40, 30, 1);
        data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
        for (int k = 0; k < 3600; ++k)
            static_cast<std::uint8_t*>(data->GetScalarPointer())[k] = static_cast<std::uint8_t>(k * 7);
        for (const int progressive : {0, 1}) {
            vtkNew<vtkJPEGWriter> writer;
            writer->SetProgressive(static_cast<vtkTypeUBool>(progressive));
            writer->SetFileName(file.c_str());
            writer->SetInputData(data);
            writer->Write();
            keep();
        }
    }
    if (format == "vti")
        for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
            for (const bool compressed : {false, true}) {
                write_vti(file, mode, compressed);
                keep();
            }
    return seeds;
}

/// Writes an extreme number of 1, 2 or 4 bytes somewhere.
void set_extreme(Bytes& bytes, std::size_t at, Random& random) {
    constexpr std::uint32_t extremes[] = {0,      1,       0x7f,       0xff,       0x7fff,
                                          0xffff, 0x10000, 0x7fffffff, 0x80000000, 0xffffffff};
    const std::uint32_t value = extremes[below(random, std::size(extremes))];
    const int count = 1 << below(random, 3);
    const bool big_endian = random() % 2 == 0;
    for (int k = 0; k < count && at + static_cast<std::size_t>(k) < bytes.size(); ++k)
        bytes[at + static_cast<std::size_t>(k)] =
            static_cast<std::uint8_t>(value >> (8 * (big_endian ? count - 1 - k : k)));
}

/// Makes the check sums of all chunks right again, so that the damage gets past them.
Bytes with_check_sums(const Bytes& png) {
    Bytes result(png.begin(), png.begin() + std::min<std::ptrdiff_t>(8, static_cast<std::ptrdiff_t>(png.size())));
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t length =
            (std::size_t{png[at]} << 24) | (png[at + 1] << 16) | (png[at + 2] << 8) | png[at + 3];
        if (length > png.size() - at - 12) break;
        const auto data = png.begin() + static_cast<std::ptrdiff_t>(at) + 8;
        append(result, png_chunk({data - 4, data}, {data, data + static_cast<std::ptrdiff_t>(length)}));
        at += 12 + length;
    }
    return result;
}

/// Changes a field of an entry of the first directory of a little-endian TIFF.
void change_tag(Bytes& tiff, Random& random) {
    std::uint32_t directory = 0;
    std::memcpy(&directory, &tiff[4], 4);
    if (std::size_t{directory} + 2 > tiff.size()) return;
    const std::size_t entries = tiff[directory] | (tiff[directory + 1] << 8);
    const std::size_t at = directory + 2 + 12 * below(random, std::max<std::size_t>(entries, 1));
    if (at + 12 > tiff.size()) return;
    constexpr std::size_t fields[] = {0, 2, 4, 8, 8, 8};
    set_extreme(tiff, at + fields[below(random, 6)], random);
}

/// Gives an attribute of a VTI file's markup another value.
void change_attribute(Bytes& vti, Random& random) {
    constexpr const char* values[] = {"",
                                      "0",
                                      "-1",
                                      "1",
                                      "2147483647",
                                      "-2147483648",
                                      "99999999999999999999",
                                      "1e9",
                                      "nan",
                                      "UInt8",
                                      "UInt64",
                                      "Float64",
                                      "String",
                                      "Int8",
                                      "ascii",
                                      "raw",
                                      "binary",
                                      "base64",
                                      "appended",
                                      "ImageData",
                                      "0 1 0 1 0 1",
                                      "0 11 0 9 0 2147483647",
                                      "BigEndian",
                                      "vtkLZ4DataCompressor",
                                      "vtkLZMADataCompressor"};
    const std::string text(vti.begin(), vti.end());
    const std::string_view markup = std::string_view(text).substr(0, text.find("<AppendedData"));
    std::vector<std::size_t> starts;
    for (std::size_t at = markup.find("=\""); at != markup.npos; at = markup.find("=\"", at + 1))
        starts.push_back(at + 2);
    if (starts.empty()) return;
    const std::size_t start = starts[below(random, starts.size())], end = text.find('"', start);
    if (end == text.npos) return;
    const std::string changed = text.substr(0, start) + values[below(random, std::size(values))] + text.substr(end);
    vti.assign(changed.begin(), changed.end());
}

Bytes mutated(Bytes bytes, const std::string& format, Random& random) {
    const std::size_t kind = below(random, 5);
    std::size_t size = bytes.size();
    if (kind == 0) bytes.resize(1 + below(random, size - 1));
    const std::size_t changes = 1 + below(random, 4);
    for (std::size_t k = 0; k < changes && kind != 0; ++k) {
        size = bytes.size();
        if (kind == 1) bytes[below(random, size)] = static_cast<std::uint8_t>(random());
        if (kind == 2) bytes[below(random, size)] ^= static_cast<std::uint8_t>(1U << below(random, 8));
        if (kind == 3)
            set_extreme(bytes, below(random, format == "vti" ? size : std::min<std::size_t>(size, 200)), random);
        if (kind == 4 && format == "tif") change_tag(bytes, random);
        if (kind == 4 && format == "vti" && k % 2 == 0) change_attribute(bytes, random);
        if (kind == 4 && format == "vti" && k % 2 == 1) { // another digit somewhere
            for (std::size_t tries = 0; tries < 50; ++tries) {
                std::uint8_t& byte = bytes[below(random, size)];
                if (byte < '0' || byte > '9') continue;
                byte = static_cast<std::uint8_t>('0' + below(random, 10));
                break;
            }
        }
        if (kind == 4 && format != "tif" && format != "vti") set_extreme(bytes, below(random, size), random);
    }
    if (format == "png" && random() % 4 != 0) return with_check_sums(bytes);
    return bytes;
}

/// Reads a file as a picture and as a stack. \return whether there was a picture
bool read_all(const std::filesystem::path& file) {
    bool good = false;
    const auto check = [&](const Image& image) {
        ASSERT_EQ(image.pixels.size(), static_cast<std::size_t>(image.width) * image.height * image.channels);
        ASSERT_TRUE(image.channels == 1 || image.channels == 3);
        good = true;
    };
    try {
        check(abut::read_image(file));
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("image \""));
    }
    try {
        const int slices = abut::read_stack_info(file).slices;
        abut::read_stack(file, 0, std::min(slices - 1, 3), [&](int, const Image& image) { check(image); });
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("image \""));
    }
    return good;
}

class HostileImage : public testing::TestWithParam<std::string> {};

} // namespace

TEST_P(HostileImage, GivesAPictureOrAnError) {
    const Folder folder;
    const std::vector<Bytes> seeds = seeds_of(GetParam(), folder);
    Random random(20260101);
    const std::size_t cases = GetParam() == "vti" ? 1500 : 4000;
    std::size_t good = 0;
    double longest = 0;
    const MemoryGrowth growth;
    testing::internal::CaptureStderr();
    for (const Bytes& seed : seeds) EXPECT_TRUE(read_all(folder.write("seed", seed)));
    for (std::size_t number = 0; number < cases; ++number) {
        const Bytes bytes = mutated(seeds[below(random, seeds.size())], GetParam(), random);
        const std::filesystem::path file = folder.write("case", bytes);
        const Stopwatch watch;
        if (read_all(file)) ++good;
        longest = std::max(longest, watch.seconds());
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "libraries must not print";
    EXPECT_LT(longest, 1);
    EXPECT_LT(growth.mebibytes(), most_growth);
    EXPECT_GT(good, 0U);
    EXPECT_LT(good, cases);
    std::cout << GetParam() << ": " << cases << " cases, " << good << " pictures, longest " << longest * 1e3
              << " ms, peak memory + " << growth.mebibytes() << " MiB\n";
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, HostileImage, testing::Values("png", "bmp", "tif", "jpg", "vti"),
                         [](const auto& format) { return format.param; });

TEST(HostileImages, TinyFilesThatClaimManyPixels) {
    const Folder folder;
    const auto expect_refused = [&](const std::string& name, const Bytes& bytes, const std::string& reason) {
        expect_refused_at_once(folder.write(name, bytes), reason);
    };
    const auto png_of = [](std::uint32_t width, std::uint32_t height) {
        Bytes file = png(1, 8, 0, {{1}});
        const Bytes w = big(width), h = big(height);
        std::copy(w.begin(), w.end(), file.begin() + 16);
        std::copy(h.begin(), h.end(), file.begin() + 20);
        return with_check_sums(file);
    };
    const std::string too_many = "at most 268435456", cannot = "a file of this size cannot hold the pixels";
    expect_refused("a.png", png_of(100000, 100000), too_many);
    expect_refused("b.png", png_of(16000, 16000), cannot);
    expect_refused("c.png", png_of(0x80000000U, 1), too_many);
    expect_refused("a.tif", test::tiff(100000, 100000, 8, 1, 1, {1}), too_many);
    expect_refused("b.tif", test::tiff(16000, 16000, 8, 1, 1, {1}), cannot);
    expect_refused("c.tif", test::tiff(0, 3, 8, 1, 1, {1}), "is damaged or incomplete"); // says libtiff
    expect_refused("a.bmp", bmp(100000, 100000, 24, {Bytes(4, 1)}), too_many);
    expect_refused("b.bmp", bmp(16000, 16000, 24, {Bytes(4, 1)}), "the BMP file ends too early");
    expect_refused(
        "a.vti",
        [] {
            const std::string text =
                "<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\"><ImageData "
                "WholeExtent=\"0 9999 0 9999 0 9999\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece "
                "Extent=\"0 9999 0 9999 0 9999\"><PointData Scalars=\"a\"><DataArray type=\"UInt8\" "
                "Name=\"a\" format=\"ascii\">1 2 3</DataArray></PointData></Piece></ImageData></VTKFile>";
            return Bytes(text.begin(), text.end());
        }(),
        cannot);
}

TEST(HostileImages, CutOffFilesAreNoPictures) {
    const Folder folder;
    for (const char* format : {"png", "bmp", "tif", "jpg", "vti"})
        for (const Bytes& seed : seeds_of(format, folder))
            for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
                const auto size = static_cast<std::size_t>(share * static_cast<double>(seed.size()));
                const std::filesystem::path file =
                    folder.write("cut", Bytes(seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(size)));
                EXPECT_THAT(message_of([&] {
                                const int slices = abut::read_stack_info(file).slices;
                                abut::read_stack(file, 0, slices - 1, [](int, const Image&) {});
                            }),
                            HasSubstr("image \""))
                    << format << " of " << seed.size() << " bytes, cut to " << size;
            }
}

TEST(HostileImages, SmallFilesCutAtEveryPlace) {
    const Folder folder;
    abut::write_image({3, 2, 1, {1, 2, 3, 4, 5, 6}}, folder.path / "a.tif");
    write_vti(folder.path / "a.vti", vtkXMLWriter::Ascii, false);
    const std::vector<Bytes> files{png(3, 2, 0, {{0}, {1}}),
                                   png(3, 8, 3, {{0, 1, 0}}, png_chunk("PLTE", {1, 2, 3, 4, 5, 6})),
                                   bmp(3, 2, 24, {Bytes(12, 7), Bytes(12, 8)}),
                                   contents(folder.path / "a.tif"),
                                   test::tiff(3, 2, 8, 1, 1, {1, 2, 3, 4, 5, 6}),
                                   seeds_of("jpg", folder).front(),
                                   contents(folder.path / "a.vti")};
    testing::internal::CaptureStderr();
    std::size_t cuts = 0;
    for (const Bytes& whole : files) {
        EXPECT_TRUE(read_all(folder.write("whole", whole)));
        for (std::size_t size = 0; size < whole.size(); ++size, ++cuts) {
            const auto file =
                folder.write("cut", Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
            const bool only_white_space = whole.back() == '\n' && size + 1 == whole.size();
            EXPECT_EQ(read_all(file), only_white_space) << "of " << whole.size() << " bytes, cut to " << size;
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    std::cout << cuts << " cut files\n";
}

TEST(HostileImages, TiffWhosePagesGoInACircle) {
    const Folder folder;
    const Bytes file = test::tiff(1, 1, 8, 1, 1, {5});
    const std::uint32_t directory = file[4]; // its own next one
    EXPECT_THAT(message_of([&] {
                    abut::read_stack_info(folder.write("a.tif", test::tiff(1, 1, 8, 1, 1, {5}, 0, {}, -1, directory)));
                }),
                HasSubstr("is damaged or incomplete"));
}

// Depths, palettes, orientations, strips and tiles: files made by the libraries themselves or byte by byte.
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <jpeglib.h>
#include <tiffio.h>

#include <memory>

using namespace test; // NOLINT(google-build-using-namespace)
using abut::Image;
using abut::read_image;
using testing::HasSubstr;
using Values = std::vector<std::uint16_t>;

namespace {

Image read(const Bytes& bytes) {
    const Folder folder;
    return read_image(folder.write("picture", bytes));
}

std::string error_for(const Bytes& bytes) {
    const Folder folder;
    const std::filesystem::path file = folder.write("picture", bytes);
    return message_of([&] { read_image(file); });
}

struct TiffKind {
    int bits = 8, samples = 1, photometric = PHOTOMETRIC_MINISBLACK, compression = COMPRESSION_NONE;
    bool tiled = false, separate = false;
    int format = SAMPLEFORMAT_UINT, orientation = ORIENTATION_TOPLEFT;
    const char* mode = "w";
    int strip = 5; ///< its rows
};

constexpr int width = 37, height = 29; // tiles of 16 stick out, strips of 5 rows too

int value_at(const TiffKind& kind, int column, int row, int sample) {
    return (column * 7 + row * 131 + sample * 29 + column * row * 1009) & ((1 << kind.bits) - 1);
}

/// One row of `columns` pixels from `column` on, packed as TIFF wants it (16 bits in the machine's order).
Bytes packed(const TiffKind& kind, int column, int columns, int row, int first_sample, int samples) {
    Bytes bytes;
    int bit = 0;
    for (int x = column; x < column + columns; ++x)
        for (int s = first_sample; s < first_sample + samples; ++s) {
            const int value = value_at(kind, x, row, s);
            if (kind.bits == 16) {
                append(bytes, little(static_cast<std::uint32_t>(value), 2));
                continue;
            }
            for (int b = kind.bits - 1; b >= 0; --b, ++bit) {
                if (bit % 8 == 0) bytes.push_back(0);
                if ((value >> b) & 1) bytes.back() |= static_cast<std::uint8_t>(0x80 >> (bit % 8));
            }
        }
    return bytes;
}

void write_tiff(const std::filesystem::path& file, const TiffKind& kind) {
    const std::unique_ptr<TIFF, decltype(&TIFFClose)> owner(TIFFOpen(file.c_str(), kind.mode), TIFFClose);
    TIFF* tiff = owner.get();
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.photometric);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind.format);
    if (kind.compression == COMPRESSION_WEBP) TIFFSetField(tiff, TIFFTAG_WEBP_LOSSLESS, 1);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, kind.orientation);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, kind.separate ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    std::array<Values, 3> map;
    if (kind.photometric == PHOTOMETRIC_PALETTE) {
        for (std::size_t c = 0; c < 3; ++c)
            for (int k = 0; k < (1 << kind.bits); ++k)
                map[c].push_back(static_cast<std::uint16_t>(((k * 5 + 70 * static_cast<int>(c)) & 255) * 257));
        TIFFSetField(tiff, TIFFTAG_COLORMAP, map[0].data(), map[1].data(), map[2].data());
    }
    constexpr int tile = 16;
    if (kind.tiled) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, tile);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, tile);
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kind.strip);
    }
    const int planes = kind.separate ? kind.samples : 1, samples = kind.separate ? 1 : kind.samples;
    for (int plane = 0; plane < planes; ++plane)
        if (kind.tiled) {
            for (int y = 0; y < height; y += tile)
                for (int x = 0; x < width; x += tile) {
                    Bytes data;
                    for (int row = y; row < y + tile; ++row) append(data, packed(kind, x, tile, row, plane, samples));
                    TIFFWriteTile(tiff, data.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0,
                                  static_cast<std::uint16_t>(plane));
                }
        } else {
            for (int row = 0; row < height; ++row) {
                Bytes data = packed(kind, 0, width, row, plane, samples);
                TIFFWriteScanline(tiff, data.data(), static_cast<std::uint32_t>(row),
                                  static_cast<std::uint16_t>(plane));
            }
        }
}

int expected(const TiffKind& kind, int column, int row, int channel) {
    if (kind.photometric == PHOTOMETRIC_PALETTE) return (value_at(kind, column, row, 0) * 5 + 70 * channel) & 255;
    const int most = (1 << kind.bits) - 1;
    int value = value_at(kind, column, row, channel);
    if (kind.photometric == PHOTOMETRIC_MINISWHITE) value = most - value;
    return kind.bits < 8 ? static_cast<int>(value * 255.0 / most + 0.5) : value;
}

void expect_read(const TiffKind& kind) {
    SCOPED_TRACE(testing::Message() << kind.bits << " bits, " << kind.samples << " samples, photometric "
                                    << kind.photometric << ", compression " << kind.compression << ", tiled "
                                    << kind.tiled << ", separate " << kind.separate << ", " << kind.mode);
    const Folder folder;
    write_tiff(folder.path / "a.tif", kind);
    Image image;
    ASSERT_EQ(message_of([&] { image = read_image(folder.path / "a.tif"); }), "");
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    ASSERT_EQ(image.channels, kind.photometric == PHOTOMETRIC_PALETTE ? 3 : kind.samples);
    EXPECT_EQ(image.bits, kind.bits == 16 ? 16 : 8);
    int wrong = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (int c = 0; c < image.channels; ++c)
                if (image.pixels[static_cast<std::size_t>((row * width + column) * image.channels + c)] !=
                    expected(kind, column, row, c))
                    ++wrong;
    EXPECT_EQ(wrong, 0);
}

} // namespace

// === PNG

TEST(ImageDepth, PngOfSixteenBits) {
    const Image grey = read(png(2, 16, 0, {{1, 2, 255, 254}}));
    EXPECT_EQ(grey.bits, 16);
    EXPECT_EQ(grey.pixels, (Values{258, 65534}));
    EXPECT_EQ(read(png(1, 16, 2, {{0, 1, 1, 0, 2, 3}})).pixels, (Values{1, 256, 515}));
    EXPECT_EQ(read(png(1, 16, 4, {{1, 2, 255, 255}})).pixels, (Values{258}));
    EXPECT_THAT(error_for(png(1, 16, 4, {{1, 2, 255, 254}})), HasSubstr("has transparency at 1 pixel;"));
}

TEST(ImageDepth, PngOfTwoAndFourBits) {
    EXPECT_EQ(read(png(4, 2, 0, {{0b00011011}})).pixels, (Values{0, 85, 170, 255}));
    EXPECT_EQ(read(png(3, 4, 0, {{0x0f, 0x70}})).pixels, (Values{0, 255, 119}));
}

TEST(ImageDepth, PngColourKeyIsTransparency) {
    EXPECT_THAT(error_for(png(3, 8, 0, {{7, 8, 7}}, png_chunk("tRNS", {0, 7}))), HasSubstr("transparency at 2 pixels"));
    EXPECT_EQ(read(png(3, 8, 0, {{7, 8, 7}}, png_chunk("tRNS", {0, 9}))).pixels, (Values{7, 8, 7}));
}

TEST(ImageDepth, PngPaletteWithTransparencyAndWithoutSomeColours) {
    const Bytes palette = png_chunk("PLTE", {1, 2, 3, 4, 5, 6});
    Bytes opaque = palette, clear = palette;
    append(opaque, png_chunk("tRNS", {255}));
    append(clear, png_chunk("tRNS", {255, 254}));
    for (const int bits : {1, 2, 4, 8}) { // 0 1, in the topmost bits of a row
        const Bytes row = bits == 8 ? Bytes{0, 1} : Bytes{static_cast<std::uint8_t>(1 << (8 - 2 * bits))};
        EXPECT_EQ(read(png(2, bits, 3, {row}, palette)).pixels, (Values{1, 2, 3, 4, 5, 6})) << bits;
        EXPECT_EQ(read(png(2, bits, 3, {row}, opaque)).pixels, (Values{1, 2, 3, 4, 5, 6})) << bits;
        EXPECT_THAT(error_for(png(2, bits, 3, {row}, clear)), HasSubstr("has transparency at 1 pixel;")) << bits;
    }
    EXPECT_THAT(error_for(png(3, 8, 3, {{0, 1, 2}}, palette)), HasSubstr("a pixel's colour is not in the palette"));
    EXPECT_THAT(error_for(png(2, 4, 3, {{0x0f}}, palette)), HasSubstr("a pixel's colour is not in the palette"));
}

TEST(ImageDepth, InterlacedPng) { // 3 x 2 pixels in the passes of Adam7, by hand
    Bytes file = png(3, 8, 0, {{1, 2, 3}, {4, 5, 6}});
    Bytes header(file.begin() + 16, file.begin() + 29);
    header[12] = 1;
    Bytes adam(file.begin(), file.begin() + 8);
    append(adam, png_chunk("IHDR", header));
    // pass 1: (0,0); passes 2, 3: none; 4: (2,0); 5: none; 6: (1,0); 7: row 1
    append(adam, png_chunk("IDAT", stored({0, 1, 0, 3, 0, 2, 0, 4, 5, 6})));
    append(adam, png_chunk("IEND", {}));
    EXPECT_EQ(read(adam).pixels, (Values{1, 2, 3, 4, 5, 6}));
}

TEST(ImageDepth, AnimatedPng) {
    EXPECT_THAT(error_for(png(1, 8, 0, {{1}}, png_chunk("acTL", {0, 0, 0, 2, 0, 0, 0, 0}))),
                HasSubstr("is an animated PNG"));
}

// === TIFF

TEST(ImageDepth, TiffOfEveryDepthLayoutAndCompression) {
    for (const bool tiled : {false, true}) {
        for (const int bits : {1, 2, 3, 4, 5, 6, 7, 8, 16}) {
            expect_read({bits, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_NONE, tiled});
            expect_read({bits, 1, PHOTOMETRIC_MINISWHITE, COMPRESSION_LZW, tiled});
            expect_read({bits, 3, PHOTOMETRIC_RGB, COMPRESSION_PACKBITS, tiled});
            expect_read({bits, 3, PHOTOMETRIC_RGB, COMPRESSION_ADOBE_DEFLATE, tiled, true});
            if (bits <= 8) expect_read({bits, 1, PHOTOMETRIC_PALETTE, COMPRESSION_NONE, tiled});
        }
        TiffKind big_endian{16, 3, PHOTOMETRIC_RGB, COMPRESSION_LZW, tiled};
        big_endian.mode = "wb";
        expect_read(big_endian);
        big_endian.mode = "w8";
        expect_read(big_endian);
    }
    for (const int compression :
         {COMPRESSION_CCITTRLE, COMPRESSION_CCITTFAX3, // libtiff 4.5 cannot read the RLEW that it writes

          COMPRESSION_CCITTFAX4}) {
        ASSERT_TRUE(TIFFIsCODECConfigured(static_cast<std::uint16_t>(compression))) << compression;
        expect_read({1, 1, PHOTOMETRIC_MINISWHITE, compression});
    }
    for (const bool tiled : {false, true})
        for (const int bits : {8, 16})
            for (const int samples : {1, 3})
                for (const int compression :
                     {COMPRESSION_DEFLATE, COMPRESSION_LZMA, COMPRESSION_ZSTD, COMPRESSION_LERC, COMPRESSION_WEBP}) {
                    ASSERT_TRUE(TIFFIsCODECConfigured(static_cast<std::uint16_t>(compression))) << compression;
                    if (compression == COMPRESSION_WEBP && (bits != 8 || samples != 3)) continue; // all that it holds
                    expect_read(
                        {bits, samples, samples == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB, compression, tiled});
                }
}

TEST(ImageDepth, TiffOfCompressionsThatLibtiffOnlyReads) { // made by hand
    // NeXT: 2 bits; 0 and a whole row as it is. Shades 0 1 2 3 / 3 2 1 0.
    EXPECT_EQ(read(test::tiff(4, 2, 2, 1, 1, {0, 0b00011011, 0, 0b11100100}, 0, {}, -1, 0, COMPRESSION_NEXT)).pixels,
              (Values{0, 85, 170, 255, 255, 170, 85, 0}));
    // ThunderScan: 4 bits; 0xc0 + a pixel as it is; 0x00 + n repeats the last one n times. 1 15 / 7 7.
    EXPECT_EQ(read(test::tiff(2, 2, 4, 1, 1, {0xc1, 0xcf, 0xc7, 0x01}, 0, {}, -1, 0, COMPRESSION_THUNDERSCAN)).pixels,
              (Values{17, 255, 119, 119}));
    EXPECT_THAT(error_for(test::tiff(2, 1, 8, 1, 1, {1, 2}, 0, {}, -1, 0, COMPRESSION_OJPEG)),
                HasSubstr("is a TIFF of an old kind of JPEG compression"));
    for (const int compression : {COMPRESSION_PIXARLOG, COMPRESSION_JBIG})
        EXPECT_THAT(error_for(test::tiff(2, 1, 8, 1, 1, {1, 2}, 0, {}, -1, 0, compression)),
                    HasSubstr("is a TIFF of an unusual compression"));
}

TEST(ImageDepth, TiffWhoseDamageLibtiffOnlyWarnsOf) {
    const Folder folder;
    const auto damaged = [&](TiffKind kind, const std::function<void(Bytes&)>& damage) {
        kind.strip = height;
        const std::filesystem::path file = folder.path / "a.tif";
        write_tiff(file, kind);
        EXPECT_EQ(message_of([&] { read_image(file); }), "");
        std::uint64_t at = 0, size = 0;
        {
            const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(file.c_str(), "r"), TIFFClose);
            at = TIFFGetStrileOffset(tiff.get(), 0);
            size = TIFFGetStrileByteCount(tiff.get(), 0);
        }
        std::ifstream stream(file, std::ios::binary);
        Bytes bytes{std::istreambuf_iterator<char>(stream), {}};
        Bytes strip(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
        damage(strip);
        std::copy(strip.begin(), strip.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
        testing::internal::CaptureStderr();
        EXPECT_THAT(message_of([&] { read_image(folder.write("b.tif", bytes)); }), HasSubstr("is damaged"))
            << kind.compression;
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    };
    const auto second_half = [](std::uint8_t value) {
        return [value](Bytes& strip) {
            std::fill(strip.begin() + static_cast<std::ptrdiff_t>(strip.size() / 2), strip.end(), value);
        };
    };
    damaged({1, 1, PHOTOMETRIC_MINISWHITE, COMPRESSION_CCITTRLE}, second_half(0x35));
    damaged({1, 1, PHOTOMETRIC_MINISWHITE, COMPRESSION_CCITTFAX3}, second_half(0x35));
    damaged({1, 1, PHOTOMETRIC_MINISWHITE, COMPRESSION_CCITTFAX4}, second_half(0x35));
    damaged({8, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_JPEG}, [](Bytes& strip) { // ends in the middle
        strip[strip.size() / 2] = 0xff;
        strip[strip.size() / 2 + 1] = 0xd9;
    });
}

TEST(ImageDepth, TiffOfEveryOrientation) {
    // TIFF 6.0: where the 0th row and the 0th column of the stored 1 2 3 / 4 5 6 are shown.
    const std::vector<std::pair<int, Values>> shown{{2, {3, 2, 1, 6, 5, 4}},  // top, right
                                                    {3, {6, 5, 4, 3, 2, 1}},  // bottom, right
                                                    {4, {4, 5, 6, 1, 2, 3}},  // bottom, left
                                                    {5, {1, 4, 2, 5, 3, 6}},  // left, top
                                                    {6, {4, 1, 5, 2, 6, 3}},  // right, top
                                                    {7, {6, 3, 5, 2, 4, 1}},  // right, bottom
                                                    {8, {3, 6, 2, 5, 1, 4}}}; // left, bottom
    for (const auto& [orientation, values] : shown) {
        const Image image = read(test::tiff(3, 2, 8, 1, 1, {1, 2, 3, 4, 5, 6}, orientation));
        EXPECT_EQ(image.pixels, values) << orientation;
        EXPECT_EQ(image.width, orientation >= 5 ? 2 : 3);
    }
}

TEST(ImageDepth, TiffKindsRefusedByName) {
    const auto error = [](const TiffKind& kind) {
        const Folder folder;
        write_tiff(folder.path / "a.tif", kind);
        return message_of([&] { read_image(folder.path / "a.tif"); });
    };
    EXPECT_THAT(error({8, 4, PHOTOMETRIC_SEPARATED}), HasSubstr("has CMYK colours; save it as RGB"));
    TiffKind kind{16};
    kind.format = SAMPLEFORMAT_INT;
    EXPECT_THAT(error(kind), HasSubstr("has signed numbers"));
    EXPECT_THAT(error_for(test::tiff(1, 1, 32, 1, 1, {1, 2, 3, 4})),
                HasSubstr("has 32 bits per channel; save it with 8"));
    EXPECT_THAT(error_for(test::tiff(1, 1, 12, 1, 1, {1, 2})), HasSubstr("has 12 bits per channel"));
    EXPECT_THAT(error_for(test::tiff(1, 1, 8, 1, 8, {1})), HasSubstr("unusual colours"));
}

// === JPEG

TEST(ImageDepth, JpegOfColoursAndOfCmyk) {
    const auto jpeg = [](int channels, J_COLOR_SPACE space, bool progressive) {
        jpeg_compress_struct state{};
        jpeg_error_mgr errors{};
        state.err = jpeg_std_error(&errors);
        jpeg_create_compress(&state);
        unsigned char* memory = nullptr;
        unsigned long size = 0;
        jpeg_mem_dest(&state, &memory, &size);
        state.image_width = 40;
        state.image_height = 20;
        state.input_components = channels;
        state.in_color_space = space;
        jpeg_set_defaults(&state);
        jpeg_set_quality(&state, 100, TRUE);
        if (progressive) jpeg_simple_progression(&state);
        jpeg_start_compress(&state, TRUE);
        Bytes row;
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < channels; ++c) row.push_back(static_cast<std::uint8_t>(50 + 60 * c));
        for (int y = 0; y < 20; ++y) {
            JSAMPROW line = row.data();
            jpeg_write_scanlines(&state, &line, 1);
        }
        jpeg_finish_compress(&state);
        Bytes bytes(memory, memory + size);
        jpeg_destroy_compress(&state);
        free(memory); // NOLINT(cppcoreguidelines-no-malloc): libjpeg's
        return bytes;
    };
    for (const bool progressive : {false, true}) {
        const Image image = read(jpeg(3, JCS_RGB, progressive));
        ASSERT_EQ(image.channels, 3);
        ASSERT_EQ(image.width, 40);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.pixels[static_cast<std::size_t>(c)], 50 + 60 * c, 2);
    }
    EXPECT_THAT(error_for(jpeg(4, JCS_CMYK, false)), HasSubstr("has CMYK colours; save it as RGB"));
}

// Animations read back chunk by chunk and page by page, by rules written down anew here.
#include "io/render/animation.h"
#include "io/render/offscreen_context.h"
#include "io/render/picture.h"
#include "io/results/write_text.h"
#include "render_support.h"
#include "results_support.h"

#include <fstream>
#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr int width = 331, height = 205; // no multiples of anything

/// Squares that move, of a colour each.
std::vector<fs::path> write_pictures(const TemporaryFolder& folder, int count) {
    OffscreenContext context;
    std::vector<fs::path> files;
    for (int i = 0; i < count; ++i) {
        Picture picture;
        picture.width = width;
        picture.height = height;
        const double x = 20 + 40 * i;
        picture.quads.add_rectangle({x, 50}, {x + 60, 150}, body_colour(i));
        files.push_back(folder / ("picture" + std::to_string(i) + ".png"));
        write_png(context, picture, files.back());
    }
    return files;
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// An unsigned number of `n` bytes, highest first.
std::uint64_t number(const std::string& bytes, std::size_t at, std::size_t n) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < n; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes.at(at + i));
    return value;
}

/// CRC-32 bit by bit.
std::uint32_t crc(const std::string& bytes) {
    std::uint32_t c = 0xffffffff;
    for (const char byte : bytes) {
        c ^= static_cast<std::uint8_t>(byte);
        for (int k = 0; k < 8; ++k) c = (c >> 1) ^ (c & 1 ? 0xedb88320 : 0);
    }
    return ~c;
}

struct Chunk {
    std::string type, data;
};

std::vector<Chunk> chunks_of(const std::string& png) {
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < png.size();) {
        const std::size_t length = number(png, at, 4);
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
        EXPECT_EQ(number(png, at + 8 + length, 4), crc(png.substr(at + 4, 4 + length)));
        at += 12 + length;
    }
    return chunks;
}

std::string bytes_4(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

std::string chunk_bytes(const Chunk& chunk) {
    return bytes_4(static_cast<std::uint32_t>(chunk.data.size())) + chunk.type + chunk.data +
           bytes_4(crc(chunk.type + chunk.data));
}

TEST(RenderAnimation, AnimatedPngHoldsThePictures) {
    TemporaryFolder folder;
    const auto pictures = write_pictures(folder, 4);
    write_animation(pictures, folder / "all.apng", 5);
    const auto chunks = chunks_of(bytes_of(folder / "all.apng"));
    ASSERT_GE(chunks.size(), 3u);
    EXPECT_EQ(chunks[0].type, "IHDR");
    EXPECT_EQ(chunks[1].type, "acTL");
    EXPECT_EQ(number(chunks[1].data, 0, 4), 4u); // pictures
    EXPECT_EQ(number(chunks[1].data, 4, 4), 0u); // for ever
    EXPECT_EQ(chunks.back().type, "IEND");
    std::uint32_t sequence = 0;
    std::vector<std::string> streams;
    for (const Chunk& chunk : chunks) {
        if (chunk.type == "fcTL") {
            EXPECT_EQ(chunk.data.size(), 26u);
            EXPECT_EQ(number(chunk.data, 0, 4), sequence++);
            EXPECT_EQ(number(chunk.data, 4, 4), unsigned(width));
            EXPECT_EQ(number(chunk.data, 8, 4), unsigned(height));
            EXPECT_EQ(number(chunk.data, 12, 8), 0u);
            EXPECT_EQ(number(chunk.data, 20, 2), 1u);
            EXPECT_EQ(number(chunk.data, 22, 2), 5u);
            streams.emplace_back();
        } else if (chunk.type == "fdAT") {
            EXPECT_EQ(number(chunk.data, 0, 4), sequence++);
            streams.back() += chunk.data.substr(4);
        } else if (chunk.type == "IDAT") {
            EXPECT_EQ(streams.size(), 1u);
            streams.back() += chunk.data;
        }
    }
    ASSERT_EQ(streams.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) { // each as a PNG of its own
        const fs::path single = folder / "single.png";
        write_text_atomically(single, "\x89PNG\r\n\x1a\n" + chunk_bytes(chunks[0]) + chunk_bytes({"IDAT", streams[i]}) +
                                          chunk_bytes({"IEND", ""}));
        const Image expected(pictures[i]), got(single);
        ASSERT_EQ(got.width(), width);
        ASSERT_EQ(got.height(), height);
        int others = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                others += got.at({double(x), double(y)}) != expected.at({double(x), double(y)});
        EXPECT_EQ(others, 0);
        EXPECT_EQ(got.at({50.0 + 40 * double(i), 100}), body_colour(int(i)));
    }
}

/// The packets of an Ogg file with one stream (RFC 3533), and the granule position of its last page.
std::pair<std::vector<std::string>, std::uint64_t> packets_of(const std::string& ogg) {
    std::vector<std::string> packets;
    std::uint64_t granule = 0;
    std::string open;
    for (std::size_t at = 0; at < ogg.size();) {
        EXPECT_EQ(ogg.substr(at, 4), "OggS");
        granule = 0;
        for (std::size_t i = 8; i-- > 0;) granule = granule << 8 | static_cast<std::uint8_t>(ogg.at(at + 6 + i));
        const std::size_t segments = number(ogg, at + 26, 1);
        std::size_t data = at + 27 + segments;
        for (std::size_t i = 0; i < segments; ++i) {
            const std::size_t length = number(ogg, at + 27 + i, 1);
            open += ogg.substr(data, length);
            data += length;
            if (length < 255) packets.push_back(std::exchange(open, {}));
        }
        at = data;
    }
    EXPECT_TRUE(open.empty());
    return {packets, granule};
}

TEST(RenderAnimation, VideoIsTheoraOfTheRightSizeAndLength) {
    TemporaryFolder folder;
    const auto pictures = write_pictures(folder, 5);
    write_animation(pictures, folder / "all.ogv", 8);
    const auto [packets, granule] = packets_of(bytes_of(folder / "all.ogv"));
    ASSERT_EQ(packets.size(), 3u + 5u); // three headers, then a packet for each picture
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(number(packets[i], 0, 1), 0x80 + i);
        EXPECT_EQ(packets[i].substr(1, 6), "theora");
    }
    const std::string& header = packets[0]; // Theora specification, 6.2
    EXPECT_EQ(number(header, 10, 2), (width + 15u) / 16);
    EXPECT_EQ(number(header, 12, 2), (height + 15u) / 16);
    EXPECT_EQ(number(header, 14, 3), unsigned(width));
    EXPECT_EQ(number(header, 17, 3), unsigned(height));
    EXPECT_EQ(number(header, 22, 4), 8 * number(header, 26, 4)); // rate as a fraction
    const unsigned shift = number(header, 40, 2) >> 5 & 31;      // after 6 bits of quality
    EXPECT_EQ((granule >> shift) + (granule & ((1u << shift) - 1)), 5u);
}

TEST(RenderAnimation, ErrorsNameFiles) {
    TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { check_animation(folder / "a.mp4", 10); }), HasSubstr(".ogv"));
    EXPECT_THAT(error_of([&] { check_animation(folder / "none/a.ogv", 10); }), HasSubstr("none: no such folder"));
    EXPECT_THAT(error_of([&] { check_animation(folder / "a.ogv", 0); }), HasSubstr("1 to 100"));
    auto pictures = write_pictures(folder, 2);
    fs::resize_file(pictures[1], 60);
    EXPECT_THAT(error_of([&] { write_animation(pictures, folder / "a.png", 10); }),
                HasSubstr("picture1.png: cannot read: the file is cut off"));
    EXPECT_FALSE(fs::exists(folder / "a.png"));
    EXPECT_THAT(error_of([&] { write_animation(pictures, folder / "a.ogv", 10); }),
                HasSubstr("picture1.png: cannot read: the file is cut off"));
    EXPECT_FALSE(fs::exists(folder / "a.ogv"));
}

} // namespace
} // namespace abut::test

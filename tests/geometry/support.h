#pragma once
/// Picture files made byte by byte, independently of the readers under test, and other help for the tests of this room.

#include "geometry/images/image.h"
#include "scene/problem.h"
#include "scene/scene.h"

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace test {

using Bytes = std::vector<std::uint8_t>;

/// A folder of its own that vanishes with the object.
struct Folder {
    std::filesystem::path path;
    Folder() {
        static int count = 0;
        path = std::filesystem::temp_directory_path() /
               ("abut-geometry-" + std::to_string(getpid()) + "-" + std::to_string(count++));
        std::filesystem::create_directories(path);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path write(const std::string& name, const Bytes& bytes) const {
        std::ofstream(path / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path / name;
    }
};

inline void append(Bytes& bytes, const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}
inline Bytes little(std::uint32_t value, int count) {
    Bytes bytes;
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return bytes;
}
inline Bytes big(std::uint32_t value) {
    return {static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
            static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
}

// === PNG

inline Bytes png_chunk(const std::string& name, const Bytes& data) {
    Bytes body(name.begin(), name.end());
    append(body, data);
    std::uint32_t crc = ~0u;
    for (const std::uint8_t byte : body) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xedb88320u : 0u);
    }
    Bytes chunk = big(static_cast<std::uint32_t>(data.size()));
    append(chunk, body);
    append(chunk, big(~crc));
    return chunk;
}

/// zlib stream of one stored block.
inline Bytes stored(const Bytes& data) {
    Bytes stream{0x78, 0x01, 0x01};
    append(stream, little(static_cast<std::uint32_t>(data.size()), 2));
    append(stream, little(~static_cast<std::uint32_t>(data.size()), 2));
    append(stream, data);
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : data) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    append(stream, big((b << 16) | a));
    return stream;
}

/// \param rows bytes of each row, top first. \param extra chunks between header and pixels
inline Bytes png(std::uint32_t width, int bits, int colour_type, const std::vector<Bytes>& rows,
                 const Bytes& extra = {}) {
    Bytes header = big(width);
    append(header, big(static_cast<std::uint32_t>(rows.size())));
    append(header, {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(colour_type), 0, 0, 0});
    Bytes pixels;
    for (const Bytes& row : rows) {
        pixels.push_back(0); // no filter
        append(pixels, row);
    }
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append(file, png_chunk("IHDR", header));
    append(file, extra);
    append(file, png_chunk("IDAT", stored(pixels)));
    append(file, png_chunk("IEND", {}));
    return file;
}

// === BMP

/// \param rows bytes of each row in the order of the file, padded here. height < 0: the first is the top one
inline Bytes bmp(std::int32_t width, std::int32_t height, int bits, const std::vector<Bytes>& rows,
                 const Bytes& palette = {}, std::uint32_t compression = 0, std::uint32_t header = 40,
                 const Bytes& masks = {}) {
    Bytes data;
    for (Bytes row : rows) {
        row.resize((row.size() + 3) / 4 * 4);
        append(data, row);
    }
    const std::uint32_t offset = 14 + header + static_cast<std::uint32_t>(palette.size());
    Bytes file{'B', 'M'};
    append(file, little(offset + static_cast<std::uint32_t>(data.size()), 4));
    append(file, little(0, 4));
    append(file, little(offset, 4));
    append(file, little(header, 4));
    append(file, little(static_cast<std::uint32_t>(width), 4));
    append(file, little(static_cast<std::uint32_t>(height), 4));
    append(file, little(1, 2));
    append(file, little(static_cast<std::uint32_t>(bits), 2));
    append(file, little(compression, 4));
    append(file, little(static_cast<std::uint32_t>(data.size()), 4));
    append(file, little(2835, 4));
    append(file, little(2835, 4));
    append(file, little(static_cast<std::uint32_t>(palette.size()) / 4, 4));
    append(file, little(0, 4));
    append(file, masks);
    file.resize(14 + header);
    append(file, palette);
    append(file, data);
    return file;
}

// === TIFF (little-endian, one strip, uncompressed)

/// \param photometric 0 white is 0, 1 black is 0, 2 RGB, 3 palette. \param palette 3 × 256 shorts, red first
inline Bytes tiff(std::uint32_t width, std::uint32_t height, int bits, int samples, int photometric, const Bytes& data,
                  int orientation = 0, const std::vector<std::uint16_t>& palette = {}, int extra_sample = -1,
                  std::uint32_t next = 0, int compression = 1) {
    struct Entry {
        std::uint32_t tag, type, count, value;
    };
    const auto size = static_cast<std::uint32_t>(data.size());
    const std::uint32_t palette_at = 8 + size, bits_at = palette_at + static_cast<std::uint32_t>(palette.size()) * 2;
    const std::uint32_t directory = bits_at + 8;
    std::vector<Entry> entries{{256, 3, 1, width}, {257, 3, 1, height}};
    entries.push_back({258, 3, static_cast<std::uint32_t>(samples),
                       samples <= 1 ? static_cast<std::uint32_t>(bits)
                                    : (samples == 2 ? static_cast<std::uint32_t>(bits * 65537) : bits_at)});
    entries.push_back({259, 3, 1, static_cast<std::uint32_t>(compression)});
    entries.push_back({262, 3, 1, static_cast<std::uint32_t>(photometric)});
    entries.push_back({273, 4, 1, 8});
    if (orientation) entries.push_back({274, 3, 1, static_cast<std::uint32_t>(orientation)});
    entries.push_back({277, 3, 1, static_cast<std::uint32_t>(samples)});
    entries.push_back({278, 3, 1, height});
    entries.push_back({279, 4, 1, size});
    if (!palette.empty()) entries.push_back({320, 3, static_cast<std::uint32_t>(palette.size()), palette_at});
    if (extra_sample >= 0) entries.push_back({338, 3, 1, static_cast<std::uint32_t>(extra_sample)});

    Bytes file{'I', 'I', 42, 0};
    append(file, little(directory, 4));
    append(file, data);
    for (const std::uint16_t value : palette) append(file, little(value, 2));
    for (int i = 0; i < 4; ++i) append(file, little(static_cast<std::uint32_t>(bits), 2));
    append(file, little(static_cast<std::uint32_t>(entries.size()), 2));
    for (const Entry& entry : entries) {
        append(file, little(entry.tag, 2));
        append(file, little(entry.type, 2));
        append(file, little(entry.count, 4));
        append(file, little(entry.value, 4));
    }
    append(file, little(next, 4));
    return file;
}

// === Errors and scenes

/// what() of the exception that `act` throws; empty if it throws none.
inline std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

/// A square or cubic grid of `cells` cells of size 1 m per axis from the origin.
inline abut::Scene unit_scene(int cells, std::size_t dimension = 2) {
    abut::Scene scene;
    if (dimension == 3) scene.analysis = abut::Analysis::three_d;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        scene.grid.cell[axis] = 1;
        scene.grid.upper[axis] = cells;
    }
    scene.materials.push_back({"steel", abut::MaterialModel::neo_hookean, 7800, 160e9, 80e9});
    scene.materials.push_back({"glass", abut::MaterialModel::neo_hookean, 2500, 40e9, 30e9});
    return scene;
}

inline abut::LegendEntry grey(int value, const std::string& body, const std::string& material = "steel") {
    abut::LegendEntry entry;
    entry.rgb = {value, value, value};
    entry.grey = true;
    entry.is_void = body.empty();
    entry.body = body;
    entry.material = material;
    return entry;
}

/// A grey picture from its rows, top first.
inline abut::Image picture(const std::vector<std::vector<int>>& rows) {
    abut::Image image{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1, {}};
    for (const auto& row : rows)
        for (const int value : row) image.pixels.push_back(static_cast<std::uint16_t>(value));
    return image;
}

} // namespace test

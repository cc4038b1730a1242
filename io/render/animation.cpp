#include "io/render/animation.h"

#include "io/render/render_series.h"
#include "io/results/output_file.h"
#include "io/results/vtk_messages.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPNGReader.h>
#include <vtk_zlib.h>

namespace abut {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, std::string_view cause) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), cause));
}

// PNG (ISO/IEC 15948, third edition with the animation chunks): a signature, then chunks of length, type, data and CRC.

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);

std::string big_endian(std::uint32_t value) {
    std::string bytes(4, '\0');
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (24 - 8 * i) & 0xff);
    return bytes;
}

std::string big_endian_16(int value) {
    return {static_cast<char>(value >> 8 & 0xff), static_cast<char>(value & 0xff)};
}

std::string chunk(std::string_view type, std::string_view data) {
    std::string body(type);
    body += data;
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(static_cast<std::uint32_t>(crc));
}

struct PngParts {
    std::string header; ///< data of IHDR
    std::string pixels; ///< of all IDAT, one compressed stream
};

PngParts read_png(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    if (!bytes.starts_with(signature)) fail(path, "cannot read: no PNG file");
    PngParts parts;
    for (std::size_t at = signature.size(); at + 12 <= bytes.size();) {
        std::uint32_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<std::uint8_t>(bytes[at + i]);
        if (length > bytes.size() - at - 12) break;
        const std::string_view type(&bytes[at + 4], 4), data(bytes.data() + at + 8, length);
        if (type == "IHDR") parts.header = data;
        if (type == "IDAT") parts.pixels += data;
        if (type == "IEND") return parts;
        at += 12 + length;
    }
    fail(path, "cannot read: the file is cut off");
}

/// Whether an Ogg file (RFC 3533) is made of whole pages up to its end, and the last one ends the stream.
bool is_whole_ogg(const fs::path& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    constexpr std::size_t header_size = 27;
    constexpr char end_of_stream = 4;
    bool ended = false;
    for (std::streamoff at = 0; at < size;) {
        std::array<char, header_size> header{};
        std::array<char, 255> lengths{}; // of the page's segments
        file.seekg(at);
        if (!file.read(header.data(), header_size) || std::string_view(header.data(), 4) != "OggS") return false;
        const auto segments = static_cast<std::uint8_t>(header[header_size - 1]);
        if (!file.read(lengths.data(), segments)) return false;
        at += static_cast<std::streamoff>(header_size) + segments;
        for (std::size_t i = 0; i < segments; ++i) at += static_cast<std::uint8_t>(lengths[i]);
        if (at > size) return false;
        ended = (header[5] & end_of_stream) != 0;
    }
    return ended;
}

/// \param shown what messages name
void write_ogv(const std::vector<fs::path>& pictures, const fs::path& file, const fs::path& shown, int fps) {
    VtkMessages messages;
    vtkNew<vtkPNGReader> reader;
    vtkNew<vtkOggTheoraWriter> writer;
    writer->SetInputConnection(reader->GetOutputPort());
    writer->SetFileName(file.c_str());
    writer->SetQuality(2);
    writer->SetSubsampling(false); // colours as sharp as shapes: thin arrows and letters keep theirs
    writer->SetRate(fps);
    read_png(pictures.front());
    reader->SetFileName(pictures.front().c_str());
    reader->Update();
    int cause = 0; // of the first write that failed: VTK passes over them, the system knows
    const auto watched = [&cause](auto&& call) {
        errno = 0;
        call();
        if (cause == 0) cause = errno;
    };
    watched([&] { writer->Start(); });
    for (const fs::path& picture : pictures) {
        read_png(picture); // libpng would end the program where a file is cut off
        reader->SetFileName(picture.c_str());
        reader->Update();
        watched([&] { writer->Write(); });
    }
    watched([&] { writer->End(); });
    const std::string message = messages.first_error();
    if (message.empty() && writer->GetError() == 0 && is_whole_ogg(file)) return;
    fail(shown, fmt::format("cannot write: {}", cause != 0         ? std::strerror(cause)
                                                : !message.empty() ? message
                                                                   : "the file is incomplete"));
}

/// The pictures' pixels as they are in their files; one picture in memory at a time.
void write_apng(const std::vector<fs::path>& pictures, OutputFile& out, int fps) {
    const std::string header = read_png(pictures.front()).header;
    out.write(signature);
    out.write(chunk("IHDR", header));
    const std::string for_ever = big_endian(0);
    out.write(chunk("acTL", big_endian(static_cast<std::uint32_t>(pictures.size())) + for_ever));
    std::uint32_t sequence = 0;
    for (const fs::path& picture : pictures) {
        const PngParts parts = read_png(picture);
        if (parts.header != header) fail(picture, "its size or kind differs from that of the first picture");
        // Size, place 0, 0, duration 1/fps s; each picture replaces the one before.
        out.write(chunk("fcTL", big_endian(sequence++) + header.substr(0, 8) + big_endian(0) + big_endian(0) +
                                    big_endian_16(1) + big_endian_16(fps) + std::string(2, '\0')));
        if (sequence == 1) // what viewers without animation show, too
            out.write(chunk("IDAT", parts.pixels));
        else
            out.write(chunk("fdAT", big_endian(sequence++) + parts.pixels));
    }
    out.write(chunk("IEND", {}));
}

} // namespace

void check_animation(const fs::path& file, int fps) {
    const std::string extension = file.extension().string();
    if (extension != ".ogv" && extension != ".apng" && extension != ".png")
        throw RenderRequestError(
            fmt::format("{}: an animation is a video, .ogv, or an animated PNG, .apng or .png; not \"{}\"",
                        file.string(), extension));
    if (fps < 1 || fps > 100)
        throw RenderRequestError(fmt::format("{} pictures a second; an animation has 1 to 100", fps));
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(folder))
        throw RenderRequestError(fmt::format("{}: no such folder for the animation", folder.string()));
    if (fs::is_directory(file))
        throw RenderRequestError(fmt::format("{}: is a folder, not a file for the animation", file.string()));
}

void write_animation(const std::vector<fs::path>& pictures, const fs::path& file, int fps) {
    replace_file(file, [&](const fs::path& temporary) {
        if (file.extension() == ".ogv") {
            write_ogv(pictures, temporary, file, fps);
            return;
        }
        OutputFile out(temporary, file);
        write_apng(pictures, out, fps);
        out.close();
    });
}

} // namespace abut

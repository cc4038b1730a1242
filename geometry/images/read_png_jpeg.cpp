#include "geometry/images/formats.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace abut::formats {

namespace {

/// VTK prints its errors to stderr; ours go into exceptions instead.
class QuietVtk {
public:
    QuietVtk() : shown_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
    ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(shown_); }
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

private:
    vtkTypeBool shown_;
};

/// CRC-32 of ISO 3309, as PNG uses it.
std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> entries{};
        for (std::uint32_t n = 0; n < 256; ++n) {
            std::uint32_t c = n;
            for (int bit = 0; bit < 8; ++bit) c = (c & 1) ? 0xedb88320u ^ (c >> 1) : c >> 1;
            entries[n] = c;
        }
        return entries;
    }();
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 0; i < size; ++i) crc = table[(crc ^ data[i]) & 0xff] ^ (crc >> 8);
    return ~crc;
}

std::uint32_t big_endian(const std::uint8_t* data) {
    return (std::uint32_t{data[0]} << 24) | (std::uint32_t{data[1]} << 16) | (std::uint32_t{data[2]} << 8) | data[3];
}

template <class Reader>
Image read_with(const std::filesystem::path& file) {
    const QuietVtk quiet;
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkImageData* picture = reader->GetOutput();
    vtkDataArray* scalars = picture->GetPointData()->GetScalars();
    if (reader->GetErrorCode() != vtkErrorCode::NoError || scalars == nullptr ||
        scalars->GetDataType() != VTK_UNSIGNED_CHAR)
        throw std::runtime_error("is damaged or incomplete");

    const int* size = picture->GetDimensions();
    Image image{size[0], size[1], scalars->GetNumberOfComponents(), {}};
    const std::size_t row_bytes = static_cast<std::size_t>(image.width) * image.channels;
    image.pixels.resize(row_bytes * image.height);
    // VTK's row 0 is the lowest of the picture, ours the highest.
    const auto* source = static_cast<const std::uint8_t*>(scalars->GetVoidPointer(0));
    for (int row = 0; row < image.height; ++row)
        std::copy_n(source + row_bytes * (image.height - 1 - row), row_bytes, image.pixels.data() + row_bytes * row);
    return image;
}

} // namespace

void check_png(const Bytes& bytes) {
    bool has_data = false, has_palette = false, ended = false;
    int colour_type = 0;
    for (std::size_t at = 8; !ended;) {
        if (bytes.size() - at < 12) throw std::runtime_error("is incomplete: the PNG file ends too early");
        const std::size_t length = big_endian(&bytes[at]);
        if (length > bytes.size() - at - 12) throw std::runtime_error("is incomplete: the PNG file ends too early");
        const auto is = [&](const char* name) { return std::memcmp(&bytes[at + 4], name, 4) == 0; };
        if (crc32(&bytes[at + 4], length + 4) != big_endian(&bytes[at + 8 + length]))
            throw std::runtime_error("is damaged: a PNG check sum is wrong");
        if (at == 8) {
            if (!is("IHDR") || length != 13) throw std::runtime_error("is damaged: the PNG file has no header");
            if (big_endian(&bytes[16]) == 0 || big_endian(&bytes[20]) == 0)
                throw std::runtime_error("has no pixels (its width or height is 0)");
            if (bytes[24] == 16) throw std::runtime_error("has 16 bit; save it with 8 bits per channel");
            colour_type = bytes[25];
        }
        has_data = has_data || is("IDAT");
        has_palette = has_palette || is("PLTE");
        ended = is("IEND");
        at += 12 + length;
    }
    if (!has_data) throw std::runtime_error("is damaged: the PNG file has no pixel data");
    if (colour_type == 3 && !has_palette) throw std::runtime_error("is damaged: the PNG file lacks its palette");
}

Image read_png(const std::filesystem::path& file) {
    return read_with<vtkPNGReader>(file);
}

Image read_jpeg(const std::filesystem::path& file) {
    return read_with<vtkJPEGReader>(file);
}

} // namespace abut::formats

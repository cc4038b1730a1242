#include "geometry/images/check_vti.h"

#include "geometry/images/formats.h"

#include <fmt/format.h>
#include <vtkBase64InputStream.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace abut::formats {

namespace {

using Extent = std::array<int, 6>;

[[noreturn]] void fail(std::string_view reason) {
    throw std::runtime_error(fmt::format("is damaged or incomplete: {}", reason));
}

bool is(vtkXMLDataElement* element, const char* name) {
    return element->GetName() != nullptr && std::strcmp(element->GetName(), name) == 0;
}

bool attribute_is(vtkXMLDataElement* element, const char* name, const char* value) {
    const char* found = element->GetAttribute(name);
    return found != nullptr && std::strcmp(found, value) == 0;
}

std::vector<vtkXMLDataElement*> children(vtkXMLDataElement* parent) {
    std::vector<vtkXMLDataElement*> found;
    found.reserve(static_cast<std::size_t>(parent->GetNumberOfNestedElements()));
    for (int k = 0; k < parent->GetNumberOfNestedElements(); ++k) found.push_back(parent->GetNestedElement(k));
    return found;
}

// === Pieces

/// Cells along an axis; of an axis along which the volume is flat, 1.
std::int64_t cells(const Extent& extent, const Extent& whole, std::size_t axis) {
    const bool flat = whole[2 * axis] == whole[2 * axis + 1];
    return flat ? 1 : std::int64_t{extent[2 * axis + 1]} - extent[2 * axis];
}

bool share_cells(const Extent& a, const Extent& b, const Extent& whole) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (whole[2 * axis] == whole[2 * axis + 1]) continue;
        if (std::min(a[2 * axis + 1], b[2 * axis + 1]) <= std::max(a[2 * axis], b[2 * axis])) return false;
    }
    return true;
}

/// VTK leaves numbers that no piece gives uninitialized. Pieces that lie inside, share no cells and have as many as the
/// whole fill it, points included.
void check_filled(const std::vector<Extent>& pieces, const Extent& whole) {
    double sum = 0, all = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) all *= static_cast<double>(cells(whole, whole, axis));
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        double product = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (pieces[k][2 * axis] < whole[2 * axis] || pieces[k][2 * axis + 1] > whole[2 * axis + 1])
                fail("a piece sticks out of the VTI file's extent");
            product *= static_cast<double>(cells(pieces[k], whole, axis));
        }
        sum += product;
        for (std::size_t other = 0; other < k && product > 0; ++other)
            if (share_cells(pieces[k], pieces[other], whole)) fail("pieces of the VTI file overlap");
    }
    if (sum != all) fail("the pieces of the VTI file do not fill its extent");
}

/// The array in a piece, which must be there once and of the same kind everywhere.
vtkXMLDataElement* array_in(vtkXMLDataElement* piece, const VtiArray& array) {
    vtkXMLDataElement* found = nullptr;
    for (vtkXMLDataElement* data : children(piece)) {
        if (!is(data, array.on_cells ? "CellData" : "PointData")) continue;
        for (vtkXMLDataElement* element : children(data)) {
            const char* name = element->GetAttribute("Name");
            if (name == nullptr || name != array.name) continue;
            int type = 0, components = 1;
            element->GetScalarAttribute("NumberOfComponents", components);
            if (!is(element, "DataArray") || found != nullptr || components != array.components ||
                element->GetWordTypeAttribute("type", type) == 0 || (type != array.type && array.type != VTK_ID_TYPE))
                fail(fmt::format("its array \"{}\" is twice in a piece, or not everywhere the same", array.name));
            found = element;
        }
    }
    if (found == nullptr) fail(fmt::format("a piece lacks the array \"{}\"", array.name));
    return found;
}

// === Compressed blocks

/// Reads the words before the blocks of an array, as VTK will.
class BlockHeader {
public:
    BlockHeader(vtkXMLDataElement* root, std::istream& stream, bool raw)
        : long_words_(attribute_is(root, "header_type", "UInt64")),
          big_endian_(attribute_is(root, "byte_order", "BigEndian")) {
        if (raw)
            input_ = vtkSmartPointer<vtkInputStream>::New();
        else
            input_ = vtkSmartPointer<vtkBase64InputStream>::New();
        input_->SetStream(&stream);
        input_->StartReading();
    }

    std::uint64_t word() {
        std::array<std::uint8_t, 8> bytes{};
        const std::size_t count = long_words_ ? 8 : 4;
        if (input_->Read(bytes.data(), count) != count) fail("the VTI file ends too early");
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < count; ++k)
            value |= std::uint64_t{bytes[k]} << (8 * (big_endian_ ? count - 1 - k : k));
        return value;
    }

private:
    bool long_words_, big_endian_;
    vtkSmartPointer<vtkInputStream> input_;
};

/// VTK allocates as many blocks as the file names, of the sizes that it names.
void check_blocks(BlockHeader header, double array_bytes, std::uint64_t file_size) {
    const std::uint64_t blocks = header.word(), size = header.word(), last = header.word();
    // Each block has a word of its own in the header.
    if (blocks == 0 || blocks > file_size / 4) fail("the VTI file cannot have so many blocks");
    const auto whole_blocks = static_cast<double>(last == 0 ? blocks : blocks - 1);
    if (whole_blocks * static_cast<double>(size) + static_cast<double>(last) != array_bytes || last > array_bytes ||
        (blocks > 1 && size > array_bytes))
        fail("the blocks of the VTI file are not as large as its array");
    for (std::uint64_t k = 0; k < blocks; ++k)
        if (header.word() > file_size) fail("a block of the VTI file is larger than the file");
}

/// Where the numbers of an array start when they are binary; none for text.
std::optional<std::streamoff> binary_start(vtkXMLDataElement* array, vtkXMLDataParser* parser, std::istream& stream) {
    long long offset = 0;
    if (array->GetScalarAttribute("offset", offset) != 0) {
        if (offset < 0 || parser->GetAppendedDataPosition() <= 0) fail("an array of the VTI file has no data");
        return parser->GetAppendedDataPosition() + offset;
    }
    if (!attribute_is(array, "format", "binary")) return {};
    stream.seekg(array->GetXMLByteIndex());
    char byte = 0;
    while (stream.get(byte) && byte != '>') {
    }
    while (stream.get(byte) && (byte == ' ' || byte == '\n' || byte == '\t' || byte == '\r')) {
    }
    if (!stream) fail("the VTI file ends too early");
    return static_cast<std::streamoff>(stream.tellg()) - 1;
}

} // namespace

void check_vti_markup(const std::filesystem::path& file) {
    constexpr int most_tags = 20000;
    constexpr std::size_t longest_end = 256;
    std::ifstream stream(file, std::ios::binary);
    const std::string_view appended = "<AppendedData", declaration = "<!DOCTYPE", end = "</VTKFile>";
    std::string text; // a few bytes of the last part, so that names are found across its end, and the next part
    std::vector<char> part(1 << 16);
    int tags = 0;
    while (stream.read(part.data(), static_cast<std::streamsize>(part.size())), stream.gcount() > 0) {
        const std::size_t kept = std::min(text.size(), appended.size() - 1);
        text.erase(0, text.size() - kept);
        text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
        const std::size_t binary = text.find(appended);
        const std::string_view markup = std::string_view(text).substr(0, binary);
        tags += static_cast<int>(std::count(markup.begin() + static_cast<std::ptrdiff_t>(kept), markup.end(), '<'));
        if (tags > most_tags) fail("a VTI file of a picture does not have so many elements");
        if (markup.find(declaration) != std::string_view::npos) fail("a VTI file has no document type");
        if (binary != std::string_view::npos) break;
    }
    // VTK goes on when the end of a file is missing.
    const std::uintmax_t size = std::filesystem::file_size(file);
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(size - std::min<std::uintmax_t>(size, longest_end)));
    stream.read(part.data(), longest_end);
    if (std::string_view(part.data(), static_cast<std::size_t>(stream.gcount())).find(end) == std::string_view::npos)
        throw std::runtime_error("is incomplete: the VTI file ends too early");
}

void check_vti_pieces(vtkXMLImageDataReader& reader, const std::filesystem::path& file, const VtiArray& array,
                      const std::array<int, 6>& whole) {
    vtkXMLDataParser* parser = reader.GetXMLParser();
    vtkXMLDataElement* root = parser == nullptr ? nullptr : parser->GetRootElement();
    if (root == nullptr) fail("it has no elements");
    const bool compressed = root->GetAttribute("compressor") != nullptr && parser->GetCompressor() != nullptr;
    if (root->GetAttribute("compressor") != nullptr && !compressed)
        throw std::runtime_error("is a VTI file of an unknown compression; save it with zlib or uncompressed");

    std::vector<vtkXMLDataElement*> arrays;
    std::vector<Extent> pieces;
    bool raw = false;
    for (vtkXMLDataElement* part : children(root)) {
        if (is(part, "AppendedData")) raw = attribute_is(part, "encoding", "raw");
        for (vtkXMLDataElement* piece : children(part)) {
            if (is(piece, "FieldData")) piece->RemoveAllNestedElements(); // may claim any number of values
            if (!is(part, "ImageData") || !is(piece, "Piece")) continue;
            Extent extent{};
            if (piece->GetVectorAttribute("Extent", 6, extent.data()) != 6) fail("a piece has no extent");
            if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5]) continue; // empty
            pieces.push_back(extent);
            arrays.push_back(array_in(piece, array));
        }
        if (is(part, "FieldData")) part->RemoveAllNestedElements();
    }
    check_filled(pieces, whole);
    const std::uint64_t size = std::filesystem::file_size(file);
    std::ifstream stream(file, std::ios::binary);
    for (std::size_t k = 0; k < arrays.size(); ++k) {
        arrays[k]->RemoveAllNestedElements(); // ranges and other information, of any length that they claim
        if (!compressed) continue;
        stream.clear();
        const std::optional<std::streamoff> start = binary_start(arrays[k], parser, stream);
        if (!start) continue;
        double bytes = static_cast<double>(vtkDataArray::GetDataTypeSize(array.type)) * array.components;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t length = std::int64_t{pieces[k][2 * axis + 1]} - pieces[k][2 * axis];
            bytes *= static_cast<double>(array.on_cells ? std::max<std::int64_t>(length, 1) : length + 1);
        }
        stream.clear();
        stream.seekg(*start);
        const bool is_appended = arrays[k]->GetAttribute("offset") != nullptr;
        check_blocks({root, stream, is_appended && raw}, bytes, size);
    }
}

} // namespace abut::formats

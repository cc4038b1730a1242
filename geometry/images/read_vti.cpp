#include "geometry/images/check_vti.h"
#include "geometry/images/formats.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkDataObject.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

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

[[noreturn]] void fail() {
    throw std::runtime_error("is damaged or incomplete");
}

using Array = VtiArray;

std::vector<Array> arrays_of(vtkInformation* output) {
    std::vector<Array> arrays;
    for (const bool on_cells : {false, true}) {
        vtkInformationVector* fields =
            output->Get(on_cells ? vtkDataObject::CELL_DATA_VECTOR() : vtkDataObject::POINT_DATA_VECTOR());
        const int count = fields == nullptr ? 0 : fields->GetNumberOfInformationObjects();
        for (int k = 0; k < count; ++k) {
            vtkInformation* field = fields->GetInformationObject(k);
            const char* name = field->Get(vtkDataObject::FIELD_NAME());
            if (name == nullptr) continue;
            const int attributes = field->Get(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE());
            arrays.push_back({name, field->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()),
                              field->Get(vtkDataObject::FIELD_ARRAY_TYPE()), on_cells,
                              (attributes & (1 << vtkDataSetAttributes::SCALARS)) != 0});
        }
    }
    return arrays;
}

Array choose(const std::vector<Array>& arrays) {
    if (arrays.empty()) throw std::runtime_error("has no arrays on its points or cells");
    if (arrays.size() == 1) return arrays.front();
    const Array* chosen = nullptr;
    for (const Array& array : arrays) {
        if (!array.active) continue;
        if (chosen != nullptr)
            throw std::runtime_error("has active scalars on points and on cells; save it with one array only");
        chosen = &array;
    }
    if (chosen == nullptr)
        throw std::runtime_error(fmt::format(
            "has {} arrays and none of them is the active scalars; save it with one array only", arrays.size()));
    return *chosen;
}

void check_kind(const Array& array) {
    switch (array.type) {
    case VTK_FLOAT:
    case VTK_DOUBLE:
        throw std::runtime_error(fmt::format(
            "has floating point numbers in its array \"{}\"; convert it to integers from 0 to 65535", array.name));
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
    case VTK_INT:
    case VTK_UNSIGNED_INT:
    case VTK_LONG:
    case VTK_UNSIGNED_LONG:
    case VTK_LONG_LONG:
    case VTK_UNSIGNED_LONG_LONG:
    case VTK_ID_TYPE:
        break;
    default:
        throw std::runtime_error(fmt::format("has no numbers in its array \"{}\"; convert it to integers", array.name));
    }
    if (array.components != 1 && array.components != 3)
        throw std::runtime_error(fmt::format("has {} components in its array \"{}\"; save it with 1 (grey) or 3 (RGB)",
                                             array.components, array.name));
}

/// The most values that a byte of the file can become, by its compressor; a plain file takes at least a byte for each.
double largest_ratio(vtkXMLImageDataReader& reader) {
    vtkXMLDataParser* parser = reader.GetXMLParser();
    if (parser == nullptr || parser->GetRootElement() == nullptr) fail();
    const char* compressor = parser->GetRootElement()->GetAttribute("compressor");
    const std::string_view name = compressor == nullptr ? "" : compressor;
    if (name.empty()) return 1;
    if (name == "vtkZLibDataCompressor") return deflate_ratio;
    if (name == "vtkLZ4DataCompressor") return 256;
    return 65536;
}

/// The rows of a volume whose axes are turned are not those that ParaView shows.
void check_direction(vtkInformation* output) {
    if (!output->Has(vtkDataObject::DIRECTION())) return;
    const double* direction = output->Get(vtkDataObject::DIRECTION());
    for (int k = 0; k < 9; ++k)
        if (direction[k] != (k % 4 == 0 ? 1 : 0))
            throw std::runtime_error("has turned axes (Direction); save it with axes along x, y and z");
}

/// A volume of which one slice at a time is read.
class Volume {
public:
    explicit Volume(const std::filesystem::path& file) {
        check_vti_markup(file);
        const QuietVtk quiet;
        reader_->SetFileName(file.c_str());
        reader_->SetActiveTimeDataArrayName(nullptr); // else VTK reads it at once, as long as it claims to be
        reader_->UpdateInformation();
        vtkInformation* output = reader_->GetOutputInformation(0);
        if (reader_->GetErrorCode() != vtkErrorCode::NoError || output == nullptr ||
            !output->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
            fail();
        output->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent_.data());
        array_ = choose(arrays_of(output));
        check_kind(array_);
        std::array<std::int64_t, 3> count{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            count[axis] = std::int64_t{extent_[2 * axis + 1]} - extent_[2 * axis] + (array_.on_cells ? 0 : 1);
            if (axis == 2 && array_.on_cells && count[axis] == 0) count[axis] = 1; // a plane of cells
        }
        check_pixels(count[0], count[1]);
        check_pixels(count[2], 1);
        check_ratio(static_cast<double>(count[0]) * static_cast<double>(count[1]) * static_cast<double>(count[2]) *
                        array_.components,
                    static_cast<double>(std::filesystem::file_size(file)), largest_ratio(*reader_));
        info_ = {static_cast<int>(count[0]), static_cast<int>(count[1]), static_cast<int>(count[2]),
                 array_.type == VTK_UNSIGNED_CHAR ? 8 : 16, std::array<double, 3>{1, 1, 1}};
        if (output->Has(vtkDataObject::SPACING())) output->Get(vtkDataObject::SPACING(), info_.spacing->data());
        for (const double length : *info_.spacing)
            if (!std::isfinite(length) || length <= 0)
                throw std::runtime_error(fmt::format("has a spacing of {}; it must be larger than 0", length));
        reader_->GetPointDataArraySelection()->DisableAllArrays();
        reader_->GetCellDataArraySelection()->DisableAllArrays();
        (array_.on_cells ? reader_->GetCellDataArraySelection() : reader_->GetPointDataArraySelection())
            ->EnableArray(array_.name.c_str());
        reader_->UpdateInformation(); // the choice of arrays has VTK parse the file again
        if (reader_->GetErrorCode() != vtkErrorCode::NoError) fail();
        check_direction(output);
        check_vti_pieces(*reader_, file, array_, extent_);
    }

    const StackInfo& info() const { return info_; }

    Image read(int slice) {
        const QuietVtk quiet;
        std::array<int, 6> part = extent_;
        part[4] += slice;
        part[5] = array_.on_cells ? std::min(part[4] + 1, extent_[5]) : part[4];
        reader_->vtkAlgorithm::UpdateExtent(part.data());
        vtkImageData* picture = reader_->GetOutput();
        if (reader_->GetErrorCode() != vtkErrorCode::NoError || picture == nullptr) fail();
        vtkDataArray* values = array_.on_cells ? picture->GetCellData()->GetArray(array_.name.c_str())
                                               : picture->GetPointData()->GetArray(array_.name.c_str());
        const std::int64_t pixels = std::int64_t{info_.width} * info_.height;
        if (values == nullptr || values->GetNumberOfComponents() != array_.components ||
            values->GetDataType() != array_.type)
            fail();
        // VTK may have read more than we asked for.
        const int* read = picture->GetExtent();
        const std::int64_t before = pixels * (std::int64_t{part[4]} - read[4]);
        if (read[0] != part[0] || read[1] != part[1] || read[2] != part[2] || read[3] != part[3] || before < 0 ||
            before + pixels > values->GetNumberOfTuples())
            fail();
        Image image{info_.width, info_.height, array_.components, {}, info_.bits};
        image.pixels.reserve(static_cast<std::size_t>(pixels) * array_.components);
        for (int row = info_.height - 1; row >= 0; --row) // VTK's row 0 is the lowest
            for (int column = 0; column < info_.width; ++column)
                for (int c = 0; c < array_.components; ++c) {
                    const double value = values->GetComponent(before + std::int64_t{row} * info_.width + column, c);
                    if (!(value >= 0 && value <= 65535))
                        throw std::runtime_error(
                            fmt::format("has the number {} in its array \"{}\"; they must lie between 0 and 65535",
                                        value, array_.name));
                    image.pixels.push_back(static_cast<std::uint16_t>(value));
                }
        return image;
    }

private:
    vtkSmartPointer<vtkXMLImageDataReader> reader_ = vtkSmartPointer<vtkXMLImageDataReader>::New();
    std::array<int, 6> extent_{};
    Array array_;
    StackInfo info_;
};

} // namespace

StackInfo vti_info(const std::filesystem::path& file) {
    return Volume(file).info();
}

SliceReader open_vti(const std::filesystem::path& file) {
    return [volume = std::make_shared<Volume>(file)](int slice) { return volume->read(slice); };
}

} // namespace abut::formats

#include "geometry/images/image.h"

#include <fmt/format.h>
#include <vtkBMPWriter.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace abut {

namespace {

/// Removes a file when it goes out of scope; after a successful rename there is none.
struct RemoveAtEnd {
    std::filesystem::path file;
    ~RemoveAtEnd() {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    }
};

template <class Writer>
void write_with(const Image& image, const std::filesystem::path& file) {
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(image.width, image.height, 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, image.channels);
    const std::size_t row_bytes = static_cast<std::size_t>(image.width) * image.channels;
    auto* target = static_cast<std::uint8_t*>(picture->GetScalarPointer());
    for (int row = 0; row < image.height; ++row) // VTK's row 0 is the lowest
        std::copy_n(image.pixels.data() + row_bytes * row, row_bytes, target + row_bytes * (image.height - 1 - row));

    vtkNew<Writer> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(picture);
    writer->Write();
    if (writer->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError) throw std::runtime_error("the disk is full");
    if (writer->GetErrorCode() != vtkErrorCode::NoError) throw std::runtime_error("the picture could not be written");
}

} // namespace

void write_image(const Image& image, const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (extension != ".png" && extension != ".bmp")
        throw std::runtime_error(fmt::format("cannot write \"{}\": the name must end in .png or .bmp", file.string()));
    // Beside the target, so that the rename stays within one file system.
    const RemoveAtEnd temporary{file.string() + fmt::format(".{}.part", getpid())};
    try {
        // VTK's writers print when the file cannot be opened; so we find out before they do.
        if (!std::ofstream(temporary.file)) throw std::runtime_error("no such folder, or no permission");
        if (extension == ".png")
            write_with<vtkPNGWriter>(image, temporary.file);
        else
            write_with<vtkBMPWriter>(image, temporary.file);
        std::filesystem::rename(temporary.file, file);
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("cannot write \"{}\": {}", file.string(), error.what()));
    }
}

} // namespace abut

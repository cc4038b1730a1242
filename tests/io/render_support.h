#pragma once
/// \file render_support.h
/// Pictures read back.

#include "io/render/picture.h"

#include <filesystem>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

namespace abut::test {

/// A PNG file.
struct Image {
    vtkNew<vtkPNGReader> reader;
    explicit Image(const std::filesystem::path& path) {
        reader->SetFileName(path.c_str());
        reader->Update();
    }
    int width() const { return reader->GetOutput()->GetDimensions()[0]; }
    int height() const { return reader->GetOutput()->GetDimensions()[1]; }
    /// y upwards, as in ours.
    Rgb at(const Pixel& p) const {
        const auto* bytes = static_cast<const std::uint8_t*>(
            reader->GetOutput()->GetScalarPointer(static_cast<int>(p[0]), static_cast<int>(p[1]), 0));
        return {bytes[0], bytes[1], bytes[2]};
    }
    bool is_white_at_the_edges() const { // nothing is clipped
        for (int x = 0; x < width(); ++x)
            for (const int y : {0, height() - 1})
                if (at({double(x), double(y)}) != Rgb{255, 255, 255}) return false;
        for (int y = 0; y < height(); ++y)
            for (const int x : {0, width() - 1})
                if (at({double(x), double(y)}) != Rgb{255, 255, 255}) return false;
        return true;
    }
};

} // namespace abut::test

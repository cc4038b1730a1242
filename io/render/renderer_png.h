#pragma once
/// \file renderer_png.h
/// What a VTK renderer shows, as a PNG file.

#include <filesystem>

class vtkRenderer; // NOLINT(cppcoreguidelines-virtual-class-destructor)

namespace abut {

class OffscreenContext;

/// Draws `renderer` alone, `width` by `height` pixels with edges smoothed by `samples` a pixel, fonts with 72 dots per
/// inch (their sizes are then pixels), and writes a PNG file, which appears complete or not at all. Throws
/// std::runtime_error naming file and cause.
void write_renderer_png(OffscreenContext& context, vtkRenderer& renderer, int width, int height, int samples,
                        const std::filesystem::path& path);

} // namespace abut

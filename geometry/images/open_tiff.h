#pragma once
/// \file open_tiff.h
/// A TIFF file open in libtiff, whose messages go nowhere.

#include <filesystem>
#include <memory>
#include <tiffio.h>

namespace abut::formats {

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

/// \param mode of TIFFOpen() \param most_memory largest piece that libtiff may allocate [bytes], 0: any
/// \param guessed becomes true when libtiff only warns that it has put pixels for missing or wrong ones
/// \return nothing if it cannot be opened
Tiff open_tiff_quietly(const std::filesystem::path& file, const char* mode, std::ptrdiff_t most_memory = 0,
                       bool* guessed = nullptr);

} // namespace abut::formats

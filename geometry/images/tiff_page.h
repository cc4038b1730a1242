#pragma once
/// \file tiff_page.h
/// One page of a TIFF file.

#include "geometry/images/formats.h"

#include <tiffio.h>

namespace abut::formats {

/// What the directory of a page says, checked to be of a kind that we read and to fit into the file.
struct TiffPage {
    int width = 0, height = 0; ///< as stored, before the orientation is followed
    int bits = 0;              ///< per value as stored: 1 to 8 or 16
    int samples = 0;           ///< values per pixel as stored
    int photometric = 0;
    int orientation = 0;
    bool separate = false; ///< one plane per channel

    bool palette() const { return photometric == PHOTOMETRIC_PALETTE; }
    bool turned() const { return orientation >= ORIENTATION_LEFTTOP; } ///< rows become columns
    int channels() const { return palette() ? samples + 2 : samples; }
    PictureSize size() const {
        return {turned() ? height : width, turned() ? width : height, bits == 16 && !palette() ? 16 : 8};
    }
};

/// \param file_size [bytes] \throws std::runtime_error as readers do
TiffPage tiff_page(TIFF* tiff, double file_size);

/// Reads the pixels of the page on which \p tiff stands.
Image read_tiff_page(TIFF* tiff, const TiffPage& page);

} // namespace abut::formats

// Through libjpeg itself: VTK 9.1's reader takes pictures with missing pixels for whole ones.
#include "geometry/images/c_library.h"
#include "geometry/images/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio> // jpeglib.h needs it
#include <jerror.h>
#include <jpeglib.h>
#include <stdexcept>

namespace abut::formats {

namespace {

/// libjpeg's state for one picture.
struct Jpeg {
    jpeg_decompress_struct state{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf escape{};

    Jpeg() = default;
    ~Jpeg() { jpeg_destroy_decompress(&state); }
    Jpeg(const Jpeg&) = delete;
    Jpeg& operator=(const Jpeg&) = delete;
};

[[noreturn]] void escape(j_common_ptr state) {
    std::longjmp(static_cast<Jpeg*>(state->client_data)->escape, 1); // NOLINT(cert-err52-cpp)
}

/// libjpeg goes on with grey pixels where data is missing or wrong; to us that is damage.
void on_message(j_common_ptr state, int level) {
    if (level >= 0) return;
    const int code = state->err->msg_code;
    if (code != JWRN_EXTRANEOUS_DATA && code != JWRN_ADOBE_XFORM && code != JWRN_JFIF_MAJOR) escape(state);
}
void print_nothing(j_common_ptr) {}

/// A tiny progressive file can ask for its pixels to be gone over without end.
void limit_scans(j_common_ptr state) {
    constexpr int most_scans = 200; // usual are 10
    if (reinterpret_cast<j_decompress_ptr>(state)->input_scan_number > most_scans) escape(state);
}

/// Reads the header. \throws std::runtime_error for kinds that we do not read
PictureSize start(Jpeg& jpeg, const Bytes& bytes) {
    jpeg.state.err = jpeg_std_error(&jpeg.errors);
    jpeg.errors.error_exit = escape;
    jpeg.errors.emit_message = on_message;
    jpeg.errors.output_message = print_nothing;
    jpeg.progress.progress_monitor = limit_scans;
    jpeg.state.client_data = &jpeg;
    const bool good = completes(jpeg.escape, [&] {
        jpeg_create_decompress(&jpeg.state);
        jpeg.state.progress = &jpeg.progress;
        jpeg_mem_src(&jpeg.state, bytes.data(), bytes.size());
        jpeg_read_header(&jpeg.state, TRUE);
    });
    if (!good) {
        if (jpeg.errors.msg_code == JERR_EMPTY_IMAGE)
            throw std::runtime_error("has no pixels (its width or height is 0)");
        if (jpeg.errors.msg_code == JERR_BAD_PRECISION)
            throw std::runtime_error("is a JPEG of more than 8 bits per channel; save it as PNG");
        throw std::runtime_error("is damaged or incomplete");
    }
    const jpeg_decompress_struct& state = jpeg.state;
    check_pixels(state.image_width, state.image_height);
    if (state.data_precision != 8)
        throw std::runtime_error("is a JPEG of more than 8 bits per channel; save it as PNG");
    if (state.jpeg_color_space == JCS_CMYK || state.jpeg_color_space == JCS_YCCK)
        throw std::runtime_error("has CMYK colours; save it as RGB");
    if (state.num_components != 1 && state.num_components != 3)
        throw std::runtime_error(fmt::format("is a JPEG of {} channels; save it as PNG", state.num_components));
    if (state.arith_code) throw std::runtime_error("is an arithmetically coded JPEG; save it as PNG");
    // At least one bit for each block of 8 x 8 values; of 3 channels, two may be stored at a 16th of the pixels.
    constexpr double most_pixels_per_byte = 1024;
    check_ratio(static_cast<double>(state.image_width) * state.image_height, static_cast<double>(bytes.size()),
                most_pixels_per_byte);
    return {static_cast<int>(state.image_width), static_cast<int>(state.image_height), 8};
}

} // namespace

PictureSize jpeg_size(const Bytes& bytes) {
    Jpeg jpeg;
    return start(jpeg, bytes);
}

Image read_jpeg(const Bytes& bytes) {
    Jpeg jpeg;
    const PictureSize size = start(jpeg, bytes);
    Image image{size.width, size.height, jpeg.state.num_components, {}};
    jpeg.state.out_color_space = image.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    const std::size_t values = static_cast<std::size_t>(image.width) * image.channels;
    image.pixels.resize(values * image.height);
    Bytes row(values);
    const bool whole = completes(jpeg.escape, [&] {
        jpeg_start_decompress(&jpeg.state);
        for (int y = 0; y < image.height; ++y) {
            JSAMPROW line = row.data();
            jpeg_read_scanlines(&jpeg.state, &line, 1);
            std::copy_n(row.data(), values, image.pixels.data() + values * y);
        }
        jpeg_finish_decompress(&jpeg.state);
    });
    if (!whole) throw std::runtime_error("is damaged or incomplete");
    return image;
}

} // namespace abut::formats

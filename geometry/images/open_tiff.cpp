#include "geometry/images/open_tiff.h"

#include <cstdarg>
#include <string_view>

namespace abut::formats {

namespace {

constexpr int handled = 1; // or libtiff prints to stderr

int say_nothing(TIFF*, void*, const char*, const char*, va_list) { // NOLINT(cert-dcl50-cpp)
    return handled;
}

int note_warning(TIFF*, void* guessed, const char* module, const char*, va_list) { // NOLINT(cert-dcl50-cpp)
    // The decoders of fax and of JPEG go on with pixels of their own where data is wrong; other warnings are harmless.
    const std::string_view from = module == nullptr ? "" : module;
    if (guessed != nullptr && (from.starts_with("Fax") || from.starts_with("JPEG")))
        *static_cast<bool*>(guessed) = true;
    return handled;
}

} // namespace

Tiff open_tiff_quietly(const std::filesystem::path& file, const char* mode, std::ptrdiff_t most_memory, bool* guessed) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
    if (!options) return nullptr;
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), say_nothing, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), note_warning, guessed);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_memory);
    return Tiff(TIFFOpenExt(file.c_str(), mode, options.get()));
}

} // namespace abut::formats

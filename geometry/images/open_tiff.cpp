#include "geometry/images/open_tiff.h"

#include <cstdarg>

namespace abut::formats {

namespace {

int say_nothing(TIFF*, void*, const char*, const char*, va_list) { // NOLINT(cert-dcl50-cpp)
    constexpr int handled = 1;                                     // or libtiff prints to stderr
    return handled;
}

} // namespace

Tiff open_tiff_quietly(const std::filesystem::path& file, const char* mode, std::ptrdiff_t most_memory) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
    if (!options) return nullptr;
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), say_nothing, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), say_nothing, nullptr);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_memory);
    return Tiff(TIFFOpenExt(file.c_str(), mode, options.get()));
}

} // namespace abut::formats

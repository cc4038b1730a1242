#pragma once
/// \file c_library.h
/// Calls into libpng and libjpeg, which report errors by a jump.

#include <csetjmp>

namespace abut::formats {

/// Runs \p call, which must own nothing (its frames vanish without destructors).
/// \return false if the library jumped to \p escape
template <class Call>
bool completes(std::jmp_buf& escape, Call call) {
    if (setjmp(escape) != 0) return false; // NOLINT(cert-err52-cpp,modernize-avoid-setjmp-longjmp)
    call();
    return true;
}

} // namespace abut::formats

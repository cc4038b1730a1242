#pragma once
/// \file sanitizer_memory.h
/// For tests of how much memory is taken: what the address sanitizer takes besides.

#ifdef __has_feature // clang's way to say it; gcc defines __SANITIZE_ADDRESS__
#if __has_feature(address_sanitizer)
#define ABUT_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define ABUT_ADDRESS_SANITIZER
#endif

namespace test {

/// Freed memory that it keeps to find uses of it, and its shadow [MiB].
#ifdef ABUT_ADDRESS_SANITIZER
constexpr long sanitizer_keeps = 256 + 64;
#else
constexpr long sanitizer_keeps = 0;
#endif

} // namespace test

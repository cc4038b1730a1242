#pragma once
/// \file si_prefix.h
/// Readable magnitudes: 3.42e-6 s as "3.42 us".

#include <string>
#include <string_view>

namespace abut {

struct SiPrefix {
    double factor = 1;       ///< what one prefixed unit is in the unit itself
    std::string_view symbol; ///< "n", "u", "m", "", "k", …
};

/// The prefix that brings |value| between 1 and 1000; none for zero and for what is out of reach (f to T).
SiPrefix si_prefix(double value);

/// A time with up to 4 digits and its prefix, e.g. "3.42 us" [s]; no prefix from a second upwards.
std::string format_time(double seconds);

/// A time in the prefix and with the decimals that suit `end`, so that a growing time does not jump: "3.42 us".
std::string format_time(double seconds, double end);

/// How far a simulation is, both times in the prefix of the end: "3.42 us of 15 us".
std::string format_time_of(double seconds, double end);

} // namespace abut

#pragma once
/// \file random.h
/// Random numbers that are the same with every compiler and standard library (std::uniform_real_distribution is not).

#include <cstdint>
#include <random>

namespace abut {

/// A stream of random numbers from a seed.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1).
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    /// Uniform in [lower, upper).
    double between(double lower, double upper) { return lower + (upper - lower) * unit(); }

    /// Normal of mean 0 and deviation 1, as the sum of twelve uniform numbers: no function of the C library, whose last
    /// digits differ, is used. Never beyond ±6.
    double normal() {
        double sum = -6;
        for (int k = 0; k < 12; ++k) sum += unit();
        return sum;
    }

    /// One of 0 .. count - 1.
    int below(int count) { return static_cast<int>(unit() * count); }

private:
    std::mt19937_64 engine_; // its output is fixed by the standard
};

} // namespace abut

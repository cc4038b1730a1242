#pragma once
/// \file bar.h
/// A progress bar on a terminal.

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace abut {

/// Columns of the terminal that `out` is; 80 if it is none.
std::size_t columns(std::FILE* out);

/// "0:07", "12:34", "1:02:03"; "?" for what is not finite [s].
std::string format_duration(double seconds);

/// "[####....] TEXT" in less than `columns`; the text alone where there is no room for both. \param fraction 0 to 1
std::string bar_line(double fraction, const std::string& text, std::size_t columns);

/// A bar for work that comes in countable pieces: "[####....] 12 of 40 pictures  0:07 left". Draws on terminals only;
/// removed at its end.
class CountBar {
public:
    /// \param what the pieces, in plural
    explicit CountBar(std::string what, std::FILE* out = stderr);
    CountBar(const CountBar&) = delete;
    CountBar& operator=(const CountBar&) = delete;
    ~CountBar();

    void update(int done, int total);

private:
    std::string what_;
    std::FILE* out_;
    bool on_terminal_, drawn_ = false;
    std::chrono::steady_clock::time_point start_;
};

} // namespace abut

#include "io/results/bar.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace abut {

std::size_t columns(std::FILE* out) {
    winsize size{};
    return ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string format_duration(double seconds) {
    if (!std::isfinite(seconds) || seconds > 1e7) return "?";
    const long total = std::lround(std::max(0.0, seconds));
    if (total >= 3600) return fmt::format("{}:{:02}:{:02}", total / 3600, total / 60 % 60, total % 60);
    return fmt::format("{}:{:02}", total / 60, total % 60);
}

std::string bar_line(double fraction, const std::string& text, std::size_t columns) {
    // The last column stays free: some terminals wrap there.
    const std::size_t room = columns - 1;
    if (room <= text.size() + 12) return text.substr(0, room);
    const std::size_t width = std::min<std::size_t>(room - text.size() - 2, 40);
    const auto done = static_cast<std::size_t>(fraction * static_cast<double>(width));
    return fmt::format("[{:#<{}}{:.<{}}]{}", "", done, "", width - done, text);
}

CountBar::CountBar(std::string what, std::FILE* out)
    : what_(std::move(what)), out_(out), on_terminal_(isatty(fileno(out)) != 0),
      start_(std::chrono::steady_clock::now()) {}

CountBar::~CountBar() {
    if (!drawn_) return;
    std::fputs("\r\x1b[K", out_);
    std::fflush(out_);
}

void CountBar::update(int done, int total) {
    if (!on_terminal_) return;
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double left = done > 0 ? passed * (total - done) / done : INFINITY;
    const std::string text = fmt::format(" {} of {} {}  {} left", done, total, what_, format_duration(left));
    fmt::print(out_, "\r{}\x1b[K", bar_line(total > 0 ? double(done) / total : 1.0, text, columns(out_)));
    std::fflush(out_);
    drawn_ = true;
}

} // namespace abut

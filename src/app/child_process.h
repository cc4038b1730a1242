#pragma once
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// How a child ended.
struct ChildEnd {
    int exit_code = -1; ///< 128 + the signal's number for one that a signal ended
    int signal = 0;     ///< that ended it; 0: none
    bool over_time = false;
};

/// Another abut, which this program waits for. It doesn't outlive this program, signals from the terminal don't reach
/// it, and where memory runs out it goes first.
class ChildProcess {
public:
    /// Starts `abut ARGUMENTS`; all that it says goes to `log`. Throws std::runtime_error if that is impossible.
    /// \param time_limit wall time after which it is ended [s]
    ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log,
                 std::optional<double> time_limit);
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ~ChildProcess(); ///< ends it

    /// Looks whether it has ended; never waits. Ends one that is over its time.
    std::optional<ChildEnd> poll();
    /// Asks it to stop, and ends it if it doesn't within seconds.
    void stop();

private:
    pid_t id_ = -1;
    std::chrono::steady_clock::time_point start_;
    std::optional<double> time_limit_;
    bool over_time_ = false;
};

} // namespace abut

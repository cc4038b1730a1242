#include "app/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace abut {

namespace {

using namespace std::chrono_literals;

/// In the child: becomes the program; never returns. Only calls that are safe after a fork.
[[noreturn]] void become_abut(char* const* arguments, int log) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::setpgid(0, 0);
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0 || ::dup2(log, STDOUT_FILENO) < 0 ||
        ::dup2(log, STDERR_FILENO) < 0)
        ::_exit(126);
    ::execv("/proc/self/exe", arguments);
    ::_exit(127);
}

} // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log,
                           std::optional<double> time_limit)
    : start_(std::chrono::steady_clock::now()), time_limit_(time_limit) {
    std::vector<std::string> words{"abut"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int descriptor = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor < 0) throw std::runtime_error(log.string() + ": cannot write: " + std::strerror(errno));
    id_ = ::fork();
    if (id_ == 0) become_abut(pointers.data(), descriptor);
    const int error = errno;
    ::close(descriptor);
    if (id_ < 0) throw std::runtime_error(std::string("cannot start a run: ") + std::strerror(error));
    std::ofstream("/proc/" + std::to_string(id_) + "/oom_score_adj") << 1000;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : id_(other.id_), start_(other.start_), time_limit_(other.time_limit_), over_time_(other.over_time_) {
    other.id_ = -1;
}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    std::swap(id_, other.id_); // the other ends what was here
    std::swap(start_, other.start_);
    std::swap(time_limit_, other.time_limit_);
    std::swap(over_time_, other.over_time_);
    return *this;
}

ChildProcess::~ChildProcess() {
    if (id_ < 0) return;
    ::kill(id_, SIGKILL);
    while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::optional<ChildEnd> ChildProcess::poll() {
    int status = 0;
    if (::waitpid(id_, &status, WNOHANG) != id_) {
        const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (time_limit_ && passed > *time_limit_ && !over_time_) {
            over_time_ = true;
            ::kill(id_, SIGKILL);
        }
        return {};
    }
    id_ = -1;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return ChildEnd{signal ? 128 + signal : WEXITSTATUS(status), signal, over_time_};
}

void ChildProcess::stop() {
    if (id_ < 0) return;
    ::kill(id_, SIGTERM);
    for (int i = 0; i < 500 && !poll(); ++i) std::this_thread::sleep_for(10ms);
}

} // namespace abut

#include "io/render/workers.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace abut {
namespace {

/// What the processes share: the next number that nobody has taken.
class SharedCounter {
public:
    SharedCounter() {
        void* memory =
            mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw std::runtime_error(std::string("no shared memory: ") + std::strerror(errno));
        value_ = new (memory) std::atomic<int>(0);
    }
    SharedCounter(const SharedCounter&) = delete;
    SharedCounter& operator=(const SharedCounter&) = delete;
    ~SharedCounter() { munmap(value_, sizeof(*value_)); }
    int take() { return value_->fetch_add(1); }
    void exhaust(int count) { value_->store(count); }

private:
    std::atomic<int>* value_ = nullptr;
};

// Messages through the pipe: a byte for each call that is done; '!', the text and a zero for one that threw. They are
// shorter than PIPE_BUF, so that those of two processes don't mix.
constexpr char call_done = '.', call_failed = '!';
constexpr std::size_t longest_text = 2000;

void tell(int pipe, std::string_view message) {
    while (::write(pipe, message.data(), message.size()) < 0 && errno == EINTR) {
    }
}

/// A worker's life; ends the process, without the parent's destructors and buffers.
[[noreturn]] void serve(int pipe, int count, SharedCounter& next, const std::function<void(int)>& work) {
    prctl(PR_SET_PDEATHSIG, SIGTERM); // not to outlive the program
    int exit_code = 0;
    try {
        for (int i = next.take(); i < count; i = next.take()) {
            work(i);
            tell(pipe, {&call_done, 1});
        }
    } catch (const std::exception& error) {
        next.exhaust(count);
        tell(pipe, call_failed + std::string(error.what()).substr(0, longest_text) + '\0');
        exit_code = 1;
    }
    _exit(exit_code);
}

/// Reads messages until all workers have closed the pipe. \return the first failure's text
std::string listen(int pipe, const std::function<void(int)>& done) {
    std::string failure, text;
    bool in_text = false;
    int count = 0;
    char buffer[4096];
    for (;;) {
        const ssize_t length = ::read(pipe, buffer, sizeof buffer);
        if (length < 0 && errno == EINTR) continue;
        if (length <= 0) return failure;
        for (const char c : std::string_view(buffer, static_cast<std::size_t>(length))) {
            if (in_text && c == '\0') {
                if (failure.empty()) failure = text;
                in_text = false;
            } else if (in_text) {
                text += c;
            } else if (c == call_failed) {
                in_text = true;
                text.clear();
            } else {
                done(++count);
            }
        }
    }
}

} // namespace

void share_work(int count, int jobs, const std::function<void(int)>& work, const std::function<void(int)>& done) {
    if (jobs <= 1 || count <= 1) {
        for (int i = 0; i < count; ++i) {
            work(i);
            done(i + 1);
        }
        return;
    }
    SharedCounter next;
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error(std::string("no pipe to workers: ") + std::strerror(errno));
    std::fflush(nullptr); // else workers would have a copy of what is still to be written
    std::vector<pid_t> workers;
    int fork_error = 0;
    for (int i = 0; i < std::min(jobs, count); ++i) {
        const pid_t worker = fork();
        if (worker == 0) {
            ::close(ends[0]);
            serve(ends[1], count, next, work);
        }
        if (worker < 0) {
            fork_error = errno;
            break;
        }
        workers.push_back(worker);
    }
    ::close(ends[1]);
    std::string failure =
        workers.empty() ? std::string("cannot start workers: ") + std::strerror(fork_error) : listen(ends[0], done);
    ::close(ends[0]);
    for (const pid_t worker : workers) {
        int status = 0;
        while (waitpid(worker, &status, 0) < 0 && errno == EINTR) {
        }
        if (failure.empty() && WIFSIGNALED(status))
            failure = fmt::format("a process that draws was ended by signal {} ({}); fewer jobs need less memory",
                                  WTERMSIG(status), strsignal(WTERMSIG(status)));
    }
    if (!failure.empty()) throw std::runtime_error(failure);
}

} // namespace abut

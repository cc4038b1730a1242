#include "io/results/output_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace abut {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view cause) {
    throw std::runtime_error(fmt::format("{}: cannot write: {}", path.string(), cause));
}

struct RemovedOnExit {
    std::filesystem::path path;
    bool armed = true;
    ~RemovedOnExit() {
        std::error_code ignored;
        if (armed) std::filesystem::remove(path, ignored);
    }
};

} // namespace

OutputFile::OutputFile(const std::filesystem::path& path, const std::filesystem::path& shown)
    : shown_(shown.empty() ? path : shown),
      descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail(shown_, std::strerror(errno));
}

OutputFile OutputFile::continued(const std::filesystem::path& path, std::uintmax_t bytes) {
    OutputFile file;
    file.shown_ = path;
    file.descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file.descriptor_ < 0) fail(path, std::strerror(errno));
    const off_t size = ::lseek(file.descriptor_, 0, SEEK_END);
    if (size < 0 || static_cast<std::uintmax_t>(size) < bytes)
        fail(path, fmt::format("it has {} bytes instead of at least {}; has it been changed?", size, bytes));
    file.size_ = static_cast<std::size_t>(bytes);
    const auto keep = static_cast<off_t>(bytes);
    if (::ftruncate(file.descriptor_, keep) != 0 || ::lseek(file.descriptor_, keep, SEEK_SET) != keep)
        fail(path, std::strerror(errno));
    return file;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : shown_(std::move(other.shown_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
    std::swap(shown_, other.shown_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(size_, other.size_);
    return *this;
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
    const std::size_t after = size_ + bytes.size();
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            const int cause = errno;
            // A device or a pipe can't take back what it has got; nor must it.
            [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, static_cast<off_t>(size_));
            fail(shown_, std::strerror(cause));
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    size_ = after;
}

void OutputFile::sync() {
    // Pipes and some network file systems cannot sync; that is no loss of data.
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP)
        fail(shown_, std::strerror(errno));
}

void OutputFile::close() {
    if (descriptor_ >= 0 && ::close(std::exchange(descriptor_, -1)) != 0) fail(shown_, std::strerror(errno));
}

void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path& temporary)>& write) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        fail(path, "it is there already and is no regular file");

    const auto temporary = path.parent_path() / fmt::format(".{}.tmp", path.filename().string());
    OutputFile file(temporary, path); // a missing or read-only folder is reported here, by its cause
    RemovedOnExit guard{temporary};
    write(temporary);
    file.sync();
    file.close();
    std::filesystem::rename(temporary, path, error);
    if (error) fail(path, error.message());
    guard.armed = false;
}

} // namespace abut

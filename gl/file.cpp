#include "gl/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace gl {

void FileWriter::fail(const char* what) const {
    throw std::runtime_error(path_.string() + ": " + what + ": " + std::strerror(errno));
}

FileWriter::FileWriter(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code ignored;
    if (std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored)) {
        fd_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (fd_ < 0) {
            fail("cannot be written");
        }
        return;
    }
    std::string name = ".";
    name += path_.filename().string();
    name += ".XXXXXX";
    temporary_ = (path_.parent_path() / name).string();
    fd_ = mkostemp(temporary_.data(), O_CLOEXEC);
    if (fd_ < 0) {
        fail("cannot be created");
    }
}

FileWriter::~FileWriter() {
    if (fd_ >= 0) {
        close(fd_);
        if (!temporary_.empty()) {
            unlink(temporary_.c_str());
        }
    }
}

void FileWriter::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            fail("cannot be written");
        }
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
}

void FileWriter::finish() {
    if (!temporary_.empty()) {
        const mode_t mask = umask(0);
        umask(mask);
        if (fchmod(fd_, 0666 & ~mask) != 0) {
            fail("cannot be written");
        }
    }
    const int fd = fd_;
    fd_ = -1;
    const bool closed = close(fd) == 0;
    if (closed && (temporary_.empty() || rename(temporary_.c_str(), path_.c_str()) == 0)) {
        return;
    }
    const int reason = errno;
    if (!temporary_.empty()) {
        unlink(temporary_.c_str());
    }
    errno = reason;
    fail(closed ? "cannot be created" : "cannot be written");
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    FileWriter writer(path);
    writer.write(bytes);
    writer.finish();
}

}  // namespace gl

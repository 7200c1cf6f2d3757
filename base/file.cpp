#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <stdexcept>

#include "base/write_all.h"

namespace base {

namespace {

namespace fs = std::filesystem;

/// Does the system make this name up? /dev/stdout is a link to what is open already.
bool is_of_system(const fs::path& path) {
    const std::string& name = path.native();
    return name.starts_with("/dev/") || name.starts_with("/proc/");
}

/// Where the links that begin at `path` end, whether something is there or not.
fs::path end_of_links(fs::path path) {
    constexpr int kMostLinks = 40;  // As Linux.
    std::error_code error;
    for (int i = 0; i < kMostLinks && !is_of_system(path) && fs::is_symlink(path, error); ++i) {
        const fs::path next = fs::read_symlink(path, error);
        if (error) {
            break;
        }
        path = path.parent_path() / next;
    }
    return path;
}

/// A name that is nobody's, as long as a name may be at most: the beginning of `name` and a number.
std::string temporary_name(const std::string& name) {
    constexpr std::size_t kLongest = 200;  // Of 255 bytes.
    std::size_t length = std::min(name.size(), kLongest);
    while (length < name.size() && length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0U) == 0x80U) {
        --length;  // Not within a character.
    }
    std::random_device random;
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), ".%08x%08x", random(), random());
    std::string result = ".";
    result.append(name, 0, length);
    return result += number.data();
}

}  // namespace

void FileWriter::fail(const char* what) const {
    throw std::runtime_error(path_.string() + ": " + what + ": " + std::strerror(errno));
}

FileWriter::FileWriter(std::filesystem::path path) : path_(std::move(path)), target_(end_of_links(path_)) {
    std::error_code ignored;
    if (!is_of_system(target_) && fs::is_symlink(target_, ignored)) {
        errno = ELOOP;
        fail("cannot be written");
    }
    struct stat there {};
    const bool exists = stat(target_.c_str(), &there) == 0;
    if (is_of_system(target_) || (exists && !S_ISREG(there.st_mode))) {
        fd_ = open(target_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
        if (fd_ < 0) {
            fail("cannot be written");
        }
        return;
    }
    if (exists && access(target_.c_str(), W_OK) != 0) {
        fail("cannot be written");
    }
    const mode_t mask = umask(0);
    umask(mask);
    mode_ = exists ? there.st_mode & 07777U : 0666U & ~mask;
    open_temporary();
    if (exists) {
        // Whoever may write to another's file leaves it to its owner, where the system lets them.
        [[maybe_unused]] const int kept = fchown(fd_, there.st_uid, there.st_gid);
    }
}

void FileWriter::open_temporary() {
    constexpr int kMostTries = 100;
    for (int i = 0; i < kMostTries && fd_ < 0; ++i) {
        temporary_ = (target_.parent_path() / temporary_name(target_.filename().string())).string();
        name_.emplace(temporary_);
        const MakingOfFile making;
        fd_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (fd_ < 0 && errno != EEXIST) {
            break;
        }
    }
    if (fd_ < 0) {
        fail("cannot be created");
    }
}

void FileWriter::remove_temporary() {
    if (!temporary_.empty()) {
        unlink(temporary_.c_str());
    }
    name_.reset();
}

FileWriter::~FileWriter() {
    if (fd_ >= 0) {
        close(fd_);
        remove_temporary();
    }
}

void FileWriter::write(std::string_view bytes) {
    if (!write_all(fd_, bytes)) {
        fail("cannot be written");
    }
}

void FileWriter::finish() {
    if (!temporary_.empty() && fchmod(fd_, static_cast<mode_t>(mode_)) != 0) {
        fail("cannot be written");
    }
    const int fd = fd_;
    fd_ = -1;
    const bool closed = close(fd) == 0;
    if (closed && (temporary_.empty() || rename(temporary_.c_str(), target_.c_str()) == 0)) {
        name_.reset();
        return;
    }
    const int reason = errno;
    remove_temporary();
    errno = reason;
    fail(closed ? "cannot be created" : "cannot be written");
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    FileWriter writer(path);
    writer.write(bytes);
    writer.finish();
}

void make_folder(const std::filesystem::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) {
        throw std::runtime_error(path.string() + ": this folder cannot be made: " + error.message());
    }
}

std::optional<std::string> read_regular_file(const std::filesystem::path& path) {
    const int fd = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) {
        return std::nullopt;
    }
    struct stat there {};
    std::optional<std::string> bytes;
    if (fstat(fd, &there) == 0 && S_ISREG(there.st_mode)) {
        bytes.emplace();
        try {
            bytes->resize(static_cast<std::size_t>(there.st_size));
        } catch (...) {
            close(fd);
            throw;
        }
        std::size_t got = 0;
        while (got < bytes->size()) {
            const ssize_t n = ::read(fd, bytes->data() + got, bytes->size() - got);
            if (n < 0 && errno == EINTR) {
                continue;
            }
            if (n <= 0) {
                break;
            }
            got += static_cast<std::size_t>(n);
        }
        bytes->resize(got);
    }
    close(fd);
    return bytes;
}

}  // namespace base

#include "base/write_all.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <ctime>

namespace base {

namespace {

/// Keeps signals that a failing write() sends from this thread, for as long as it lives.
class Unsignaled {
  public:
    Unsignaled() {
        sigemptyset(&kept_);
        sigaddset(&kept_, SIGPIPE);
        sigaddset(&kept_, SIGXFSZ);
        sigset_t pending;
        if (sigpending(&pending) == 0 && sigismember(&pending, SIGPIPE) == 1) {
            sigdelset(&kept_, SIGPIPE);  // Somebody else's.
        }
        pthread_sigmask(SIG_BLOCK, &kept_, &before_);
    }
    ~Unsignaled() {
        const int reason = errno;
        const timespec at_once{};
        while (sigtimedwait(&kept_, nullptr, &at_once) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
        errno = reason;
    }
    Unsignaled(const Unsignaled&) = delete;
    Unsignaled& operator=(const Unsignaled&) = delete;

  private:
    sigset_t kept_{}, before_{};
};

}  // namespace

bool write_all(int fd, std::string_view bytes, int patience) {
    const Unsignaled unsignaled;
    while (!bytes.empty()) {
        const ssize_t n = ::write(fd, bytes.data(), bytes.size());
        if (n > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(n));
            continue;
        }
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n == 0 || (errno != EAGAIN && errno != EWOULDBLOCK)) {
            return false;
        }
        pollfd ready{fd, POLLOUT, 0};
        const int found = poll(&ready, 1, patience);
        if (found == 0 || (found < 0 && errno != EINTR)) {
            errno = EAGAIN;
            return false;
        }
    }
    return true;
}

}  // namespace base

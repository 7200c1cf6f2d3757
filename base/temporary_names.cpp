#include "base/temporary_names.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

namespace base {

/// A handler may look at an entry at any time, from any thread: entries are neither changed nor freed, only marked. A
/// run writes a handful of files.
struct TemporaryName::Entry {
    std::string name;
    std::atomic<bool> there = true;
    Entry* next = nullptr;
};

namespace {

std::atomic<TemporaryName::Entry*>& first_entry() {
    static constinit std::atomic<TemporaryName::Entry*> first = nullptr;
    return first;
}

std::atomic<int>& files_being_made() {
    static constinit std::atomic<int> count = 0;
    return count;
}

std::atomic<bool>& removal_begun() {
    static constinit std::atomic<bool> begun = false;
    return begun;
}

void remove_and_end(int signal) {
    remove_temporary_names();
    // Not before: the same signal may come once more, to another thread (`timeout` sends it twice).
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    sigaction(signal, &action, nullptr);
    raise(signal);  // Its default action follows when this returns.
}

}  // namespace

TemporaryName::TemporaryName(std::string name) : entry_(new Entry{std::move(name)}) {
    std::atomic<Entry*>& first = first_entry();
    entry_->next = first;
    while (!first.compare_exchange_weak(entry_->next, entry_)) {
    }
}

void TemporaryName::release() {
    entry_->there = false;
}

MakingOfFile::MakingOfFile() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
    ++files_being_made();
    if (removal_begun()) {
        --files_being_made();
        while (true) {
            pause();
        }
    }
}

MakingOfFile::~MakingOfFile() {
    --files_being_made();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

/// Calls nothing that a signal handler may not.
void remove_temporary_names() {
    removal_begun() = true;
    // Not for ever: what makes a file may hang, as on a network's disk.
    for (int i = 0; i < 1000 && files_being_made() > 0; ++i) {
        poll(nullptr, 0, 1);
    }
    for (const auto* entry = first_entry().load(); entry != nullptr; entry = entry->next) {
        if (entry->there) {
            unlink(entry->name.c_str());
        }
    }
}

void remove_temporary_names_at_signals() {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGXCPU, SIGUSR1, SIGUSR2, SIGALRM}) {
        struct sigaction action {};
        if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) {
            continue;  // As nohup ignores SIGHUP.
        }
        action.sa_handler = remove_and_end;
        action.sa_flags = 0;
        sigfillset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace base

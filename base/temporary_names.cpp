#include "base/temporary_names.h"

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

/// The default action comes back only when all is removed: the signal may come a second time, to another thread, as
/// timeout(1) sends it to the program and to its group.
void remove_and_end(int signal) {
    remove_temporary_names();
    std::signal(signal, SIG_DFL);
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

/// Calls nothing that a signal handler may not.
void remove_temporary_names() {
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
        sigfillset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace base

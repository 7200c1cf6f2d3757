// The names of files that are being written, which are not to outlive the program.
#pragma once

#include <csignal>
#include <string>

namespace base {

/// A name that is removed when a signal ends the program, from its construction to release(); see
/// remove_temporary_names_at_signals(). Construct it before the file is there.
class TemporaryName {
  public:
    explicit TemporaryName(std::string name);
    ~TemporaryName() { release(); }
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

    /// The file is gone, or has its final name.
    void release();

    struct Entry;

  private:
    Entry* entry_;
};

/// Held while a file of a temporary name is made: who removes such files waits for it, so that none is made behind
/// their back. Where the removal has begun, the constructor does not return: the program ends.
class MakingOfFile {
  public:
    MakingOfFile();
    ~MakingOfFile();
    MakingOfFile(const MakingOfFile&) = delete;
    MakingOfFile& operator=(const MakingOfFile&) = delete;

  private:
    sigset_t before_{};  ///< Signals that the thread had blocked; all are while this is held.
};

/// Removes all files of temporary names, for a program that ends without its destructors. From any thread, or a signal
/// handler.
void remove_temporary_names();

/// From now on SIGTERM, SIGINT, SIGHUP and the like, where they would have ended the program, first remove all
/// temporary names. To be called once, in main().
void remove_temporary_names_at_signals();

}  // namespace base

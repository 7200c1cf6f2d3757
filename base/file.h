// Files that are written whole or not at all, and read whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/temporary_names.h"

namespace base {

/// Writes to a temporary name in the same folder, which takes the place of `path` at the end, with the mode of the file
/// that was there; a symbolic link stays, and what it points to is written. A device or a pipe, which cannot be
/// replaced, is written to as it is. Everything throws std::runtime_error with the file's name and the reason.
class FileWriter {
  public:
    explicit FileWriter(std::filesystem::path path);
    /// Without finish() before, nothing has happened to `path`.
    ~FileWriter();
    FileWriter(const FileWriter&) = delete;
    FileWriter& operator=(const FileWriter&) = delete;

    void write(std::string_view bytes);
    /// Nothing may be written after it.
    void finish();

  private:
    [[noreturn]] void fail(const char* what) const;
    void open_temporary();
    void remove_temporary();

    std::filesystem::path path_;    ///< As it was given.
    std::filesystem::path target_;  ///< The end of the links.
    std::string temporary_;         ///< Empty where the target itself is written to.
    std::optional<TemporaryName> name_;
    unsigned mode_ = 0;
    int fd_ = -1;
};

/// All at once.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// A folder, with those above it; one that is there already stays. Throws std::runtime_error with its name and the
/// reason.
void make_folder(const std::filesystem::path& path);

/// The bytes of a regular file; nothing where there is none or it cannot be read. Never waits, as opening a pipe would.
[[nodiscard]] std::optional<std::string> read_regular_file(const std::filesystem::path& path);

}  // namespace base

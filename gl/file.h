// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gl {

/// Writes to a temporary name in the same folder, which takes the place of `path` at the end; a device or a pipe, which
/// cannot be replaced, is written to as it is. Everything throws std::runtime_error with the file's name and the
/// reason.
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

    std::filesystem::path path_;
    std::string temporary_;  ///< Empty where `path_` itself is written to.
    int fd_ = -1;
};

/// All at once.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace gl

// What is not saved, kept in a file of its own, so that it outlives a program that is killed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ui {

/// One for each file that is edited, and each process that edits it.
class Recovery {
  public:
    /// `folder`: where they are kept, made when it is needed; empty: nothing is kept. `path`: of the file that is
    /// edited, absolute.
    Recovery(std::filesystem::path folder, std::string path) : folder_(std::move(folder)), path_(std::move(path)) {}

    /// `saved`: as the file had it; `text`: with what is not saved. What cannot be written is nobody's trouble.
    void keep(const std::string& saved, const std::string& text) const;
    /// There is nothing unsaved now.
    void drop() const;

    struct Left {
        std::filesystem::path kept;  ///< Where it is.
        std::string saved, text;     ///< As keep() was given them.
    };
    /// Of a process that is no more; the newest of several.
    [[nodiscard]] std::optional<Left> left() const;
    /// It has been taken, or is not wanted.
    static void forget(const Left& left);

  private:
    [[nodiscard]] std::string stem() const;
    [[nodiscard]] std::filesystem::path own() const;

    std::filesystem::path folder_;
    std::string path_;
};

}  // namespace ui

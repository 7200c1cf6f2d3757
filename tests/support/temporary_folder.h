// A folder for the files of one test.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace test_support {

/// All bytes of a file; none where it is not there.
[[nodiscard]] inline std::string read_file(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "csgscope-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw std::system_error(errno, std::generic_category(), name);
        }
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::string path(const std::string& name) const { return (path_ / name).string(); }
    /// Gives the path of the file that it writes.
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path(name);
    }
    /// As many editors save: a new file takes the name of the old one.
    void replace(const std::string& name, const std::string& text) const {
        write(name + "~new", text);
        std::filesystem::rename(path_ / (name + "~new"), path_ / name);
    }
    void remove(const std::string& name) const { std::filesystem::remove(path_ / name); }
    [[nodiscard]] std::string read(const std::string& name) const { return read_file(path_ / name); }

  private:
    std::filesystem::path path_;
};

}  // namespace test_support

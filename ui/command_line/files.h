// The files of the command line: standard input and output stand for "-".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "ui/pipeline/json.h"

namespace ui {

/// The text of a source file. Throws UsageError where it cannot be read.
[[nodiscard]] std::string read_source(const std::string& path);

/// The whole of standard input. Throws UsageError where it is longer than a source text may be.
[[nodiscard]] std::string read_standard_input();

/// A file that is written piece by piece, and is there whole or not at all; "-" is standard output. Everything throws
/// std::runtime_error with the reason.
class OutputFile {
  public:
    explicit OutputFile(const std::string& path);
    void write(std::string_view bytes);
    void finish();

  private:
    std::optional<base::FileWriter> file_;  ///< Nothing: standard output.
    std::string waiting_;                   ///< For standard output: pieces may be small.
};

/// Writes the file whole or not at all, or to standard output for "-". Throws std::runtime_error with the reason.
void write_output(const std::string& path, const std::string& bytes);

/// JSON as it is written: indented, with a newline at its end. Names that are no UTF-8 are written with U+FFFD.
[[nodiscard]] std::string text_of(const Json& json);

/// A rule for make, as OpenSCAD's -d writes it: each of `targets` depends on all of `sources`.
[[nodiscard]] std::string dependency_rules(const std::vector<std::string>& targets,
                                           const std::vector<std::string>& sources);

/// Runs `command` with the path as its last argument, as OpenSCAD's -m does; it ends with this program. What went
/// wrong; empty where it ended well.
[[nodiscard]] std::string run_make_command(const std::string& command, const std::string& path);

}  // namespace ui

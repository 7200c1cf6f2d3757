// Messages of a program on standard error, as OpenSCAD prints them, and as the text of an .echo file.
#pragma once

#include <string>

#include "csg/scad/diagnostics.h"

namespace ui {

class Messages {
  public:
    /// `quiet`: only errors are printed.
    explicit Messages(bool quiet) : quiet_(quiet) {}

    /// Prints OpenSCAD's line; for errors also the place as file:line:column, the source line and a caret.
    void add(const csg::scad::Message& message, const csg::scad::SourceSet& sources);
    /// A warning of ours, outside the language.
    void warn(const std::string& text);

    [[nodiscard]] std::size_t warnings() const { return warnings_; }
    [[nodiscard]] const std::string& echo_text() const { return echo_; }  ///< Line by line, all that OpenSCAD prints.

  private:
    bool quiet_;
    std::size_t warnings_ = 0;
    std::string echo_;
};

/// "csgscope: error: text" on standard error.
void print_error(const std::string& text);

}  // namespace ui

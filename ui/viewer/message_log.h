// What a program said, line by line, as the console shows it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "csg/scad/source/diagnostics.h"
#include "ui/viewer/text_place.h"

namespace ui {

enum class LineKind { Echo, Warning, Error, Note, Excerpt };

struct LogLine {
    LineKind kind = LineKind::Echo;
    std::string text;                          ///< Without newline.
    std::shared_ptr<const TextPlace> place{};  ///< Where it points to; null where it points nowhere.
};

/// Bounded: a program may print without end. Errors are kept where other messages are only counted any more.
class MessageLog {
  public:
    /// Errors and warnings with a known place as file:line:column, the source line and a caret; the rest as OpenSCAD
    /// prints it.
    void add(const csg::scad::Message& message, const csg::scad::SourceSet& sources);
    /// Messages of ours, outside the language; may hold several lines.
    void add(LineKind kind, const std::string& text);

    [[nodiscard]] std::span<const LogLine> lines() const { return lines_; }
    [[nodiscard]] std::size_t left_out() const { return left_out_; }  ///< Messages that are not in lines().
    [[nodiscard]] std::size_t errors() const { return errors_; }
    [[nodiscard]] std::size_t warnings() const { return warnings_; }
    /// In one line, the file without its folder: "model.scad:3:5: …"; empty where there is none.
    [[nodiscard]] const std::string& first_error() const { return first_error_; }
    [[nodiscard]] std::string text() const;  ///< All lines, each with a newline.

  private:
    /// True for the first error.
    bool count(LineKind kind);
    /// Where it gives false the message is left out.
    bool room_for(LineKind kind);
    void append(LineKind kind, const std::string& text, const std::shared_ptr<const TextPlace>& place = {});

    std::vector<LogLine> lines_;
    std::size_t bytes_ = 0, left_out_ = 0, errors_ = 0, warnings_ = 0;
    std::string first_error_;
};

}  // namespace ui

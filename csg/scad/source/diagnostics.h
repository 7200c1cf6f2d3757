// Messages about a program: what is wrong, and where.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "csg/scad/source/source.h"

namespace csg::scad {

enum class Severity : std::uint8_t { Error, Warning, Echo, Deprecated, Trace, Info };

/// `text` is the bare message: no severity, no place. Both renderings (below) add these.
struct Message {
    Severity severity = Severity::Error;
    SourceRange where;  ///< Not known() where the message has no place.
    std::string text;
    bool parsing = false;  ///< Arose before anything ran. OpenSCAD names the file as it was opened in such messages.
};

/// Takes messages in the order in which they arise. May be empty: use `report`.
using MessageSink = std::function<void(const Message&)>;

inline void report(const MessageSink& sink, const Message& message) {
    if (sink) {
        sink(message);
    }
}

/// "error", "warning", "echo", …
[[nodiscard]] std::string_view severity_name(Severity severity);

/// `file:line:column: error: text`, then the source line and a line with carets under the range, each ending with a
/// newline. Columns are shown as code points, tabs are kept so that the caret stands where the eye expects it; very
/// long lines are cut around the caret. A message without a place is `error: text`.
[[nodiscard]] std::string render(const Message& message, const SourceSet& sources);

/// OpenSCAD's one-line form, without newline: `WARNING: text in file a.scad, line 3`, `ECHO: …`. `base_directory` is
/// cut from file names (OpenSCAD shows them relative to the main file, but relative to the working directory in what
/// arose while parsing); empty leaves them as they are.
[[nodiscard]] std::string render_openscad(const Message& message, const SourceSet& sources,
                                          std::string_view base_directory = {});

}  // namespace csg::scad

// Messages of a program on standard error, as OpenSCAD prints them, and as the text of an .echo file.
#pragma once

#include <exception>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/source/diagnostics.h"
#include "csg/tree/out_of_memory.h"

namespace ui {

class Messages {
  public:
    /// `quiet`: only errors are printed.
    explicit Messages(bool quiet);

    /// Prints OpenSCAD's line; for errors also the place as file:line:column, the source line and a caret.
    void add(const csg::scad::Message& message, const csg::scad::SourceSet& sources);
    /// From now on each is printed once, and counted once, however often it is added.
    void each_once() { each_once_ = true; }
    /// A warning of ours, outside the language.
    void warn(const std::string& text);

    [[nodiscard]] std::size_t count() const { return count_; }  ///< Of messages added.
    [[nodiscard]] std::size_t warnings() const { return warnings_; }
    [[nodiscard]] const std::string& echo_text() const { return echo_; }  ///< Line by line, all that OpenSCAD prints.

    /// The variable of the environment that says how many messages of the same run another program has printed, which
    /// has handed it over: as many are not printed again.
    static constexpr const char* kSaid = "CSGSCOPE_MESSAGES_SAID";

  private:
    void print(const std::string& line);

    bool quiet_;
    bool each_once_ = false;
    std::set<std::string> printed_;  ///< Where each is to be printed once.
    std::size_t said_ = 0;           ///< By another program.
    std::size_t count_ = 0;
    std::size_t warnings_ = 0;
    std::string echo_;
};

/// "csgscope: error: text" on standard error, once for each line of the text.
void print_error(std::string_view text);

/// The same for a run that got no more memory for what `what_for` names (null: nobody knows); names --memory-limit
/// where the arguments do. Needs none itself.
void print_out_of_memory(const std::vector<std::string>& arguments, const char* what_for);

/// What a run with the arguments gives; where it throws, a message and 1.
template <typename Action>
[[nodiscard]] auto or_error(const std::vector<std::string>& arguments, const Action& action) -> decltype(action()) {
    try {
        return action();
    } catch (const csg::OutOfMemory& out) {
        print_out_of_memory(arguments, out.what());
    } catch (const std::bad_alloc&) {
        print_out_of_memory(arguments, nullptr);
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return 1;
}

}  // namespace ui

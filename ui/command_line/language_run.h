// The part of a run that is the language alone: the source, its messages, and the outputs that are texts.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "csg/scad/scad.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/options.h"
#include "ui/command_line/time_limit.h"
#include "ui/pipeline/program_runner.h"

namespace ui {

/// Says on a terminal what is going on; nothing elsewhere.
class Progress {
  public:
    explicit Progress(bool quiet);
    ~Progress() { say(""); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void say(const char* stage) const;

  private:
    bool shown_;
};

void write_outputs(const Options& options, Format format, const std::string& bytes);

class LanguageRun {
  public:
    /// The options and the limit must outlive it. `measures` answers what a program asks of fonts and drawings; may be
    /// null.
    LanguageRun(const Options& options, TimeLimit& limit, std::shared_ptr<csg::scad::Measures> measures);

    /// Reads the source. Throws UsageError.
    void read();
    /// The runs to come have this $t; nothing is read or parsed again for them.
    void set_time(double time);
    /// Makes the outputs that are texts, evaluating only where one of all outputs needs it. False where an error in the
    /// file, or the time, ended the run; the messages have said why.
    [[nodiscard]] bool operator()();
    /// The tree at another $t, once there has been a run; null where there is none, and an error has been told. Makes
    /// no outputs.
    [[nodiscard]] std::shared_ptr<const csg::Tree> evaluate_at(double time);
    /// Where the program puts its camera at another $t, as far as it says so.
    [[nodiscard]] csg::scad::ViewSettings view_at(double time);
    /// The tree with another text of the main file, definitions as they are; null where that has an error, which is not
    /// told.
    [[nodiscard]] std::shared_ptr<const csg::Tree> evaluate_text(const std::string& text);
    /// The tree of another file, evaluated in the same way, once the source has been; null where an error ended that.
    [[nodiscard]] std::shared_ptr<const csg::Tree> evaluate_other(const std::string& path);
    void write_dependencies() const;
    /// The options' memory limit, if there is one, for the stage that comes (memory_limit.h).
    void hold_memory_limit() const;

    [[nodiscard]] const csg::scad::Evaluation& evaluation() const { return run_.evaluation; }
    [[nodiscard]] double evaluate_ms() const { return run_.milliseconds; }
    [[nodiscard]] Messages& messages() { return messages_; }
    [[nodiscard]] const Messages& messages() const { return messages_; }
    [[nodiscard]] const Progress& progress() const { return progress_; }

  private:
    [[nodiscard]] bool only(std::initializer_list<Format> formats) const;
    [[nodiscard]] bool write_syntax(bool tell);
    [[nodiscard]] bool evaluate();
    [[nodiscard]] ProgramRun run_at(double time);
    void limit_memory();
    void make(const std::string& path);
    void take_parameter_set();
    [[nodiscard]] std::shared_ptr<csg::scad::LoadedProgram> load();
    void write_tree() const;

    const Options& options_;
    TimeLimit& limit_;
    Messages messages_;
    Progress progress_;
    csg::scad::Request request_;
    std::string appended_;  ///< To the main file's text, by definitions that are statements.
    ProgramRunner runner_;
    bool loaded_ = false;  ///< It is looked at before it runs.
    ProgramRun run_;
    std::set<std::string> made_;  ///< By -m, or tried to.
};

/// Does what the arguments ask for where the language is all it takes, and gives the exit status; nothing where it
/// takes more, of which nothing is done then. `hand_over` is called, from any thread, where it turns out in the middle
/// that the answer of a font or a drawing is needed: it is given how many messages have been printed, and does not come
/// back.
[[nodiscard]] std::optional<int> run_language(const std::vector<std::string>& arguments,
                                              const std::function<void(std::size_t said)>& hand_over);

}  // namespace ui

// A program that has been read and parsed, and runs as often as one likes.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "csg/scad/scad.h"
#include "csg/scad/syntax/parser.h"

namespace csg::scad {

struct Compiled;

/// All members may be called from any thread; one run after another. What it is made of stays as it was loaded: the
/// files are not looked at again.
class LoadedProgram {
  public:
    /// What the parser made of the main file. `definitions`: those of the request that was parsed.
    LoadedProgram(Parsed parsed, std::vector<std::string> definitions);
    ~LoadedProgram();
    LoadedProgram(const LoadedProgram&) = delete;
    LoadedProgram& operator=(const LoadedProgram&) = delete;

    /// Evaluates with the request's definitions, variables and limits; all but these and its `reader` and
    /// `make_missing` is the program's. Messages, those of the parser first, are the same each time. Must be called on
    /// a thread with a deep stack (program/deep_thread.h). Throws std::bad_alloc.
    void run(const Request& request, const EvaluationSink& sink, const char* stack_limit, Evaluation& result);

    /// The definitions that hold from now on, until a run has others. can_define() them.
    void define(const std::vector<std::string>& definitions);
    /// The main file, with all that it includes, and the definitions that hold have a syntax tree.
    [[nodiscard]] bool well_formed() const {
        const std::scoped_lock lock(mutex_);
        return definitions_ok_;
    }
    /// Whether another run may have these definitions. Where texts of definitions name files they are part of it.
    [[nodiscard]] bool can_define(const std::vector<std::string>& definitions) const;
    /// Runs have left so much behind that it were better parsed anew.
    [[nodiscard]] bool spent() const {
        const std::scoped_lock lock(mutex_);
        return spent_;
    }
    /// Lets go of what runs have found out.
    void forget_code();

    /// Calls `look` with the syntax tree. While it looks nothing runs, and no body is built.
    template <typename Look>
    auto look(const Look& look) const {
        const std::scoped_lock lock(mutex_);
        return look(parsed_.program);
    }
    /// The same, with all bodies built that have been left out.
    template <typename Look>
    auto look_at_all(const Look& look) {
        const std::scoped_lock lock(mutex_);
        build_all();
        return look(parsed_.program);
    }
    /// What the parser had to say, with the definitions that hold.
    [[nodiscard]] std::vector<Message> messages() const;
    /// The texts that messages refer to.
    [[nodiscard]] SourceSet sources() const {
        const std::scoped_lock lock(mutex_);
        return parsed_.program.sources;
    }

  private:
    void set_definitions(const std::vector<std::string>& definitions);
    void build_all();
    void tell_files(Evaluation& result) const;
    void evaluate(const Request& request, const char* stack_limit, const MessageSink& gate, Evaluation& result);

    mutable std::mutex mutex_;
    Parsed parsed_;
    std::optional<std::vector<std::string>> defined_;  ///< The definitions that hold; nothing: none are known to.
    bool definitions_ok_;
    std::vector<Message> definition_messages_;
    std::size_t parsed_nodes_;  ///< Expressions that there were at first: definitions add some each time.
    std::unique_ptr<Compiled> compiled_;
    std::vector<Symbol> compiled_names_;  ///< Variables that only definitions name, as `compiled_` knows them.
    bool spent_ = false;
};

}  // namespace csg::scad

// Reads what a program is made of, and notes what it read: what the program depends on. Internal to csg/scad.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/scad/program/piece_store.h"
#include "csg/scad/scad.h"
#include "csg/scad/source/source_store.h"
#include "csg/scad/syntax/parser.h"

namespace csg::scad {

/// What was looked for, in order: parsing is a function of this.
struct ReadLog {
    struct Step {
        std::string path;
        bool made = false;  ///< `make_missing` was asked to make it; else it was read.
        SourceResult result{};
        std::optional<DiskState> state{};
    };
    std::vector<Step> steps;
};

/// One load. All that it is given must outlive it.
class Loading {
  public:
    /// `store` and `pieces`: null for a program that is not kept.
    Loading(const Request& request, SourceStore* store, PieceStore* pieces)
        : request_(request), store_(store), pieces_(pieces) {}

    /// The main file, from the request or from where it is. The first that is to be called.
    [[nodiscard]] SourceResult main();
    /// Goes through the steps of another load of the same main file; true where all gave the same. parse() goes on from
    /// where they did not: nothing is read or made twice.
    [[nodiscard]] bool repeats(const ReadLog& before);
    [[nodiscard]] Parsed parse(const SharedSource& main);

    [[nodiscard]] const ReadLog& log() const { return log_; }

  private:
    [[nodiscard]] SourceResult read(const std::string& path);
    void make(const std::string& path);
    /// Whether that is the next step of the log, which is gone on with.
    [[nodiscard]] bool is_next(const std::string& path, bool made);
    [[nodiscard]] SourceResult next_read(const std::string& path);
    void next_make(const std::string& path);

    const Request& request_;
    SourceStore* const store_;
    PieceStore* const pieces_;
    ReadLog log_;
    std::size_t next_ = 0;  ///< Steps that the parser has asked for.
};

/// Evaluates, on a deep thread, the program that `load` gives; null where there is none, with messages that say why.
/// `once`: what the run finds out about the program is not kept.
using Load = std::function<std::shared_ptr<LoadedProgram>(Evaluation& result, std::vector<Message>& messages)>;
[[nodiscard]] Evaluation evaluate_with(const Request& request, const EvaluationSink& sink, bool once, const Load& load);

}  // namespace csg::scad

// The one way from a source to a tree: the command line, the window and comparisons go it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "csg/scad/program/program_cache.h"

namespace ui {

/// Shows a message, and gives how many warnings have been shown so far.
using ShowMessage = std::function<std::size_t(const csg::scad::Message& message, const csg::scad::SourceSet& sources)>;

struct ProgramRun {
    csg::scad::Evaluation evaluation;
    bool stopped_by_warning = false;  ///< A hard one: what came after it was not shown.
    double milliseconds = 0;          ///< Wall time.
    /// There is a tree, and nothing that was to end the run.
    [[nodiscard]] bool good() const { return evaluation.ok && !stopped_by_warning; }
};

/// Keeps what it has loaded: what did not change is not parsed again. All members may be called from any thread.
class ProgramRunner {
  public:
    /// `measures` answers what programs ask of fonts and drawings; may be null.
    explicit ProgramRunner(std::shared_ptr<csg::scad::Measures> measures) : measures_(std::move(measures)) {}

    /// Evaluates the request, whose `measures` are set. `hard_warnings`: as soon as there is a warning, that is all
    /// there is. Where the request's token stops it, the evaluation says so.
    [[nodiscard]] ProgramRun run(csg::scad::Request request, bool hard_warnings, const ShowMessage& show);
    /// The same for a program that is not asked for again: nothing is kept.
    [[nodiscard]] ProgramRun run_once(csg::scad::Request request, bool hard_warnings, const ShowMessage& show);

    /// The program as it is now, with the request's definitions, but not run; null where its main file cannot be read,
    /// of which a message is shown.
    [[nodiscard]] std::shared_ptr<csg::scad::LoadedProgram> load(const csg::scad::Request& request,
                                                                 const ShowMessage& show);

  private:
    std::shared_ptr<csg::scad::Measures> measures_;
    csg::scad::ProgramCache programs_;
};

}  // namespace ui

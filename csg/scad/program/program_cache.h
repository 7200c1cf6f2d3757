// Programs that stay loaded: what did not change is neither read nor parsed again, but checked.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "csg/scad/program/loaded_program.h"
#include "csg/scad/program/piece_store.h"
#include "csg/scad/source/source_store.h"

namespace csg::scad {

/// All members may be called from any thread.
class ProgramCache {
  public:
    ProgramCache();
    ~ProgramCache();
    ProgramCache(const ProgramCache&) = delete;
    ProgramCache& operator=(const ProgramCache&) = delete;

    /// The program of the request's main file as its files are now; null where that cannot be read, which `sink` is
    /// told. It is the one of before where all that was read for it, and all that was looked for and not found, is as
    /// it was. What the parser has to say is in its messages().
    [[nodiscard]] std::shared_ptr<LoadedProgram> load(const Request& request, const EvaluationSink& sink);

    /// The same as scad::evaluate(), message by message, with a program that may have been loaded before.
    [[nodiscard]] Evaluation evaluate(const Request& request, const EvaluationSink& sink);

    struct Counts {
        std::size_t parsed = 0;  ///< Times that a program was put together, …
        std::size_t kept = 0;    ///< … that one was found to be as it was, …
        std::size_t pieces = 0;  ///< … and that a file was parsed by itself.
    };
    [[nodiscard]] Counts counts() const;

  private:
    struct Entry;
    struct Found {
        std::shared_ptr<LoadedProgram> program;
        std::vector<std::pair<std::string, DiskState>> looked_for;
    };
    [[nodiscard]] Found find(const Request& request, std::vector<Message>& messages);

    static constexpr std::size_t kMostPrograms = 8;
    mutable std::mutex mutex_;
    SourceStore sources_;
    PieceStore pieces_;
    std::list<Entry> entries_;  ///< The one asked for last first.
    Counts counts_;
};

}  // namespace csg::scad

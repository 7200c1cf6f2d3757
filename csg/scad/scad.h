// The front end in one call: an OpenSCAD file in, a CSG tree out.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "csg/scad/builtin/measures.h"
#include "csg/scad/source/diagnostics.h"
#include "csg/scad/source/disk_state.h"
#include "csg/tree/tree.h"

namespace csg::scad {

/// What an evaluation may use before it ends with a located error.
struct Limits {
    std::size_t stack_bytes = std::size_t{256} << 20;  ///< Reserved, not touched: recursion of functions and modules.
    std::size_t list_elements = 100'000'000;           ///< Elements of all lists alive at one time.
    std::size_t nodes = 20'000'000;                    ///< Nodes of the tree.
    unsigned tail_calls = 1'000'000;                   ///< Of one function in a row, as in OpenSCAD.
};

/// A view in OpenSCAD's terms: $vpt, $vpr (degrees), $vpd, $vpf (degrees).
struct View {
    std::array<double, 3> translation{0, 0, 0};
    std::array<double, 3> rotation{55, 0, 25};
    double distance = 140;
    double fov = 22.5;
};

struct Request {
    // What decides which program it is (program/loaded_program.h): a load looks at these.

    std::string path;                 ///< The main file; also names it in messages.
    std::optional<std::string> text;  ///< Taken in place of the file's text where given.
    SourceReader reader = read_source_file;
    std::vector<std::string> search_path = search_path_from_environment();
    FileMaker make_missing{};  ///< Asked for files that the program names and that are not there; may be empty.

    // What differs from run to run; a run also uses `reader` and `make_missing`, for the files that it imports.

    std::vector<std::string> definitions;  ///< `name=expression`, as of -D; they override the file's assignments.
    Limits limits;
    std::stop_token stop;          ///< Asked often; a stopped evaluation ends with an error soon.
    double time = 0;               ///< $t
    bool preview = true;           ///< $preview
    bool trace_parameters = true;  ///< Traces show the parameters of user modules (--trace-usermodule-parameters).
    std::size_t trace_depth = 12;  ///< Steps shown at either end of a trace (--trace-depth).
    bool check_parameters = true;  ///< Warn of arguments that user definitions do not take (--check-parameters).
    bool check_ranges = false;     ///< Warn of dimensions that make nothing (--check-parameter-ranges).
    bool by_error = false;         ///< $fe has its meaning (--enable discretization-by-error).
    bool lazy_union = false;       ///< Loops, branches, children() make no groups (--enable lazy-union).
    std::shared_ptr<Measures> measures;  ///< Answers textmetrics(), dxf_dim() and the like; may be null.
    View view;                           ///< What the $vp… variables hold before the file sets them.
};

/// The $vp… variables that the main file sets at top level.
struct ViewSettings {
    std::optional<std::array<double, 3>> translation;
    std::optional<std::array<double, 3>> rotation;
    std::optional<double> distance;
    std::optional<double> fov;
};

class LoadedProgram;

struct Evaluation {
    std::shared_ptr<const Tree> tree;  ///< Null where there was an error; a tree without root for an empty model.
    bool ok = false;                   ///< The same as "tree is set".
    bool parsed = false;               ///< The main file is well formed: whatever went wrong did so while it ran.
    bool stopped = false;              ///< The stop token ended it.
    bool out_of_memory = false;        ///< The system refused memory, which ended it.
    ViewSettings view;
    /// All that were read, the main file first, and those that shapes are to be read from: what to watch for changes.
    std::vector<std::string> files;
    std::size_t errors = 0;
    std::size_t warnings = 0;
    std::shared_ptr<const SourceSet> sources;      ///< For rendering messages.
    std::shared_ptr<const LoadedProgram> program;  ///< What ran; null where the main file could not be read.
    /// Where there is a cache (program/program_cache.h): all files that were looked for, those too that are not there,
    /// and how they were before they were read; in the order in which they were looked for.
    std::vector<std::pair<std::string, DiskState>> looked_for;
};

/// Takes messages with the texts they refer to; see `render` and `render_openscad`.
using EvaluationSink = std::function<void(const Message&, const SourceSet&)>;

/// Parses and evaluates, once. Never throws; whatever went wrong is a message. Runs on a thread of its own with
/// `limits.stack_bytes` of stack and waits for it; `sink` is called from that thread.
[[nodiscard]] Evaluation evaluate(const Request& request, const EvaluationSink& sink);

}  // namespace csg::scad

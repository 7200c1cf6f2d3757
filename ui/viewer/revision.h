// One evaluation of the source: from the file to a model that can be shown, or to the messages that say why not.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "csg/scad/customizer/customizer.h"
#include "csg/scad/scad.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/motion/depiction.h"
#include "ui/viewer/call_at.h"
#include "ui/viewer/file_watcher.h"
#include "ui/viewer/message_log.h"

namespace ui {

/// An earlier state of a model.
struct Baseline {
    std::string name;                       ///< For people: "it was opened", "old.scad".
    std::shared_ptr<const csg::Tree> tree;  ///< Null: as the file says.
    std::string path;                       ///< Of that file.
    bool operator==(const Baseline&) const = default;
};

/// What the motion of a program depends on.
struct ProgramState {
    std::shared_ptr<const csg::scad::LoadedProgram> program;
    std::vector<std::string> customized;
    std::pair<double, double> interval{0, 1};  ///< Of $t.
    bool operator==(const ProgramState&) const = default;
};

/// What is drawn of a motion beside the model of the program that moves so; beside others nothing is.
struct DepictedMotion {
    std::vector<Depiction> depictions;
    std::shared_ptr<const Motion> motion;
    ProgramState of;
    double aspect = 1;  ///< Of pictures: width by height.
};

/// What is shown: where the text comes from and how it is evaluated.
struct Source {
    /// Names the text; read from there unless `text` is given. Empty: nothing is open. "-": standard input.
    std::string path;
    std::optional<std::string> text;
    std::vector<std::string> definitions;  ///< Statements that come after the text.
    bool preview = true;                   ///< $preview
    bool hard_warnings = false;            ///< A warning is an error.
    bool by_error = false;                 ///< $fe has its meaning.
    bool lazy_union = false;
    csg::PartRule parts{};
    npr::Sections sections{};               ///< Those by parts are made of the model at once.
    std::vector<std::string> customized{};  ///< name=expression, which count above the definitions.

    std::vector<CallAt> hidden{};   ///< What these make is left out …
    std::optional<CallAt> alone{};  ///< … and all but what this makes.
    double time = 0;                ///< $t

    std::optional<CallAt> explained{};  ///< Shown instead of the model is what this did, while it is there.
    std::optional<Baseline> before{};   ///< … or what has changed since.
    csg::Showing showing = csg::Showing::Preview;

    std::shared_ptr<const DepictedMotion> depicted{};  ///< Null: nothing is.

    std::optional<std::string> edited{};  ///< The main file's text with what is not saved: counts above all others.

    [[nodiscard]] bool nothing() const { return path.empty(); }
    /// The file that is followed; empty where there is none.
    [[nodiscard]] std::string followed() const { return path == "-" ? std::string() : path; }
};

struct Revision {
    std::shared_ptr<const Model> model;              ///< Null where there was an error.
    std::shared_ptr<const csg::Tree> tree;           ///< Of the program: all of it, whatever of it the model shows.
    std::shared_ptr<const csg::Tree> before;         ///< Of the source's baseline, where it has one.
    std::shared_ptr<const DepictedMotion> depicted;  ///< Whose glyphs the model has; null: it has none.
    std::vector<std::string> depiction_problems;     ///< By its depictions: why one is not drawn; empty where it is.
    std::vector<BubbleRequest> bubbles;              ///< Of those, …
    std::vector<FrameRequest> frames;                ///< … to be written into pictures, …
    std::vector<GlyphStyle> styles;                  ///< … and in styles of their own.
    csg::scad::ViewSettings view;
    /// Of the main file, with the source's definitions as their values; nothing where that cannot be parsed.
    std::optional<std::vector<csg::scad::CustomizerParameter>> parameters;
    std::shared_ptr<const csg::scad::SourceSet> sources;  ///< Null where nothing was read.
    MessageLog messages;
    std::map<std::string, DiskState> files;  ///< All that were looked for, as they were before they were read.
    double evaluate_ms = 0, build_ms = 0;    ///< Wall time.
};

/// What the source asks of the language, but for what is customized and what is to be measured. Reads its file where
/// definitions are to stand behind its text.
[[nodiscard]] csg::scad::Request request_of(const Source& source, const csg::scad::View& camera,
                                            const std::stop_token& stop = {});

/// Makes a revision; `camera` is what the $vp… variables hold. Never throws; blocks until done or, with a revision of
/// no worth, until the token has ended it. Not to be called by two threads at a time.
using Evaluate = std::function<Revision(const Source&, const csg::scad::View& camera, const std::stop_token&)>;

/// Evaluates the source and builds its model; texts, programs and meshes are kept from one revision to the next, so
/// that an edit reads and builds only what it changed.
[[nodiscard]] Evaluate make_evaluate();

}  // namespace ui

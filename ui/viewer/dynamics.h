// What the window draws of motion and says of parts, and what moves, which a thread of its own looks for.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/pipeline/program_runner.h"
#include "ui/viewer/document.h"
#include "ui/viewer/dynamics_commands.h"
#include "ui/viewer/frame_log.h"
#include "ui/viewer/latest_job.h"

namespace ui {

/// What moves, of which program; or why that is not known.
struct MotionAnswer {
    ProgramState of;
    std::shared_ptr<const Motion> motion;
    std::string error;
};

/// Lives on the thread of the window.
class Dynamics {
  public:
    /// `wake` is called from another thread when update() has something new.
    explicit Dynamics(std::function<void()> wake);

    /// Reads them; what cannot be read is told by errors() and left out. The file of rules is read where it is another
    /// than before.
    void set(GlyphTexts texts);
    [[nodiscard]] const GlyphTexts& texts() const { return texts_; }

    /// Those with which nothing is wrong, as options of the command line.
    [[nodiscard]] std::vector<std::string> options() const;

    /// What is wrong with each text, by its place in texts(): with its form, its names, or what it asks to be drawn.
    struct Errors {
        std::vector<std::string> depictions, labels, arrows;
        std::string rules;
        std::string picture;  ///< Why nothing could be written into the last picture.
    };
    [[nodiscard]] const Errors& errors() const { return errors_; }
    void set_picture_error(std::string error) { errors_.picture = std::move(error); }

    /// Is it to be known what moves? `panel`: which lists it.
    [[nodiscard]] bool wants_motion(bool panel) const { return panel || !depictions_.empty(); }
    /// Begins to look for what moves in the program that the document shows, unless that is known, or looked for.
    void look(const Document& document, const csg::scad::View& camera);
    void cancel();
    /// After that look() begins anew.
    void forget_canceled() { canceled_ = {}; }
    /// Takes what was found. True where something is new.
    bool update();

    /// Null where it is not known.
    [[nodiscard]] const std::shared_ptr<const Motion>& motion() const { return known_.motion; }
    [[nodiscard]] const std::string& motion_error() const { return known_.error; }
    /// Whole seconds since the search began; nothing where there is none.
    [[nodiscard]] std::optional<int> looking_for() const;

    /// What revisions are to draw; null where that is nothing. `aspect`: of pictures.
    [[nodiscard]] std::shared_ptr<const DepictedMotion> depicted(double aspect) const;
    /// What is wanted for the model of the document, whose glyphs have bubbles and frames; null where that is nothing.
    /// Finds errors of names, and of what the revision could not draw.
    [[nodiscard]] std::shared_ptr<const Annotations> annotations(const Document& document);

    [[nodiscard]] FrameRecord::Dynamics record() const;

  private:
    void read_rules();
    [[nodiscard]] std::pair<double, double> interval() const;

    GlyphTexts texts_;
    std::vector<std::string> depiction_forms_, label_forms_;  ///< Errors of their form.
    Errors errors_;
    std::vector<Depiction> depictions_;        ///< Those that can be read, then the rules.
    std::vector<std::size_t> depiction_text_;  ///< Which text each of the first is of.
    std::vector<Depiction> rules_;
    Annotations read_;                     ///< Labels and arrows that can be read.
    std::vector<std::size_t> label_text_;  ///< Which text each label is of.
    MotionAnswer known_;
    ProgramState sought_, canceled_;  ///< What is looked for, and for what that was given up.
    int searches_ = 0;
    std::chrono::steady_clock::time_point began_;
    std::shared_ptr<ProgramRunner> runner_;
    LatestJob<MotionAnswer> job_;  ///< Last: its jobs use the above.
};

}  // namespace ui

// All that the window shows and how it follows the file, without the window: document, view, evaluation, watcher.
#pragma once

#include <chrono>
#include <functional>

#include "ui/pipeline/editing/added_shape.h"
#include "ui/pipeline/editing/statement_pieces.h"
#include "ui/viewer/animation.h"
#include "ui/viewer/camera_control.h"
#include "ui/viewer/commands.h"
#include "ui/viewer/customizer.h"
#include "ui/viewer/document.h"
#include "ui/viewer/dynamics.h"
#include "ui/viewer/editing.h"
#include "ui/viewer/ghost.h"
#include "ui/viewer/latest_job.h"
#include "ui/viewer/layout.h"
#include "ui/viewer/moving.h"
#include "ui/viewer/selection.h"
#include "ui/viewer/settings.h"
#include "ui/viewer/view_state.h"
#include "ui/viewer/window.h"

namespace ui {

/// Lives on the thread of the window; only the evaluation runs elsewhere.
class Session {
  public:
    /// Begins to evaluate. `wake` is called from another thread when update() has something new.
    Session(const WindowOptions& options, Evaluate evaluate, std::function<void()> wake);

    /// Takes what the evaluation and the watcher have to tell; `now` in seconds. True where something is new.
    bool update(double now);

    /// Carries out what concerns document and view, and gives false for what only the window can do.
    bool perform(const Command& command);
    /// Shifts the camera until the point is in the middle, at the size that it has; the camera turns about it then.
    void look_at(const glm::dvec3& point);
    /// What was picked at a place of the picture is selected; the text shows where the first of it comes from.
    void select(std::vector<SelectedSurface> surfaces, const glm::dvec2& at);
    /// The console says so.
    void tell(LineKind kind, const std::string& text) { document_.add_message(kind, text); }
    /// So many layers were seen in a picture of the model.
    void see_layers(const Model& model, int layers);

    [[nodiscard]] const Document& document() const { return document_; }
    [[nodiscard]] const ViewState& view() const { return view_; }
    [[nodiscard]] base::Camera& camera() { return view_.picture.camera; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] const Shown& shown() const { return shown_; }
    [[nodiscard]] const Customizer& customizer() const { return customizer_; }
    [[nodiscard]] const Selection& selection() const { return selection_; }
    /// What is selected, by a click in the picture or in the tree; none: kNoOccurrence.
    [[nodiscard]] csg::OccurrenceId selected_occurrence() const { return selected_; }
    /// "lid.scad:12"; empty where nothing is.
    [[nodiscard]] const std::string& selected_place() const { return selected_place_; }
    [[nodiscard]] const Ghost& ghost() const { return ghost_; }  ///< Of that.
    [[nodiscard]] const Animation& animation() const { return animation_; }
    [[nodiscard]] const TextPlace& text() const { return text_; }
    /// What is drawn of motion, and written at parts.
    [[nodiscard]] const Dynamics& dynamics() const { return dynamics_; }
    /// Wanted in pictures of the model; null: nothing is.
    [[nodiscard]] const std::shared_ptr<const Annotations>& annotations() const { return annotations_; }
    /// The last picture of the model could not have all of them, and why; empty: it has.
    void tell_unwritten(const std::string& why) { dynamics_.set_picture_error(why); }
    /// What is edited by hand.
    [[nodiscard]] const Editing& editing() const { return editing_; }
    /// What a hand holds in the model that is shown, or has put there while the text follows.
    [[nodiscard]] const HeldPart& held() const { return held_; }
    /// Something can be moved: the model is that of the text, and nothing is being moved.
    [[nodiscard]] bool can_move() const;
    /// How the text can follow what was moved last, of which way_taken() was taken; or why it cannot. Nothing where
    /// there is nothing to be told of it any more.
    [[nodiscard]] const std::optional<MoveAnswer>& ways() const { return ways_; }
    [[nodiscard]] std::size_t way_taken() const { return way_taken_; }
    /// What is not saved is given up.
    void discard_edits();
    /// The form is shown that asks what is to become of what is not saved.
    void ask_before_leaving() { shown_.leave_form = true; }
    [[nodiscard]] bool evaluating() const { return job_.busy(); }
    /// Whole seconds since the evaluation that runs was asked for; nothing where none runs.
    [[nodiscard]] std::optional<int> evaluating_for() const;
    /// The newest models differ from those before by a value of the customizer, which may go on changing.
    [[nodiscard]] bool customizing() const { return customizing_; }
    /// The most layers that were seen of the model, from wherever it was looked at; at least 1.
    [[nodiscard]] int layer_count() const { return layer_count_; }

  private:
    /// What is to be selected in the next model.
    struct SelectNext {
        csg::OccurrenceId up = 0;                   ///< So far above that leaf.
        csg::LeafId leaf = 0, leaves = 0;           ///< As long as there are as many; none: nothing is.
        std::string name;                           ///< That it is called by; of another name it is something else.
        std::optional<csg::scad::ByteRange> bytes;  ///< Else what these of the main file make.
    };
    bool edit_by_hand(const Command& command);
    bool edit_text(Action action);
    void put(const HeldPart& held);
    void take_ways(MoveAnswer answer);
    void set_number(const SetNumber& number);
    void take_way(std::optional<std::size_t> way);
    void add_shape(AddedShape shape);
    void edit_statement(Action action);
    /// False where it is no action of that menu.
    bool arrange(Action action);
    /// The text has changed: the model is to follow.
    void follow_text();
    void save();
    void look_at_disk();
    /// The model is that of the text as it has been edited.
    [[nodiscard]] bool in_step() const;
    /// The byte of the main file's text where the call stands; nothing where it is of another.
    [[nodiscard]] std::optional<std::size_t> byte_of(const csg::SourceLocation& where) const;
    /// Of what is selected, in the text.
    [[nodiscard]] std::optional<StatementText> selected_statement() const;
    /// From the world to where the statement stands, through the transforms that it is in.
    [[nodiscard]] glm::dmat4 into_statement(const StatementText& statement) const;
    [[nodiscard]] SelectNext same_as_now() const;
    void select_again(const SelectNext& next);
    void open(const std::filesystem::path& path);
    void evaluate();
    [[nodiscard]] LatestJob<Revision>::Job next_revision() const;
    /// Gives the evaluation that runs up.
    void cancel();
    void close();
    void customize();
    /// Evaluates again while a value changes: what is quick is waited for.
    void follow_soon();
    void show_text(const TextPlace& place);
    /// The ghost is that of the selection.
    void mark_selected();
    void mark(csg::OccurrenceId occurrence, const std::string& place);
    void clear_selection();
    void show_selected_text();
    void run_animation();
    bool animate(const Command& command);
    bool look_at_tree(const Command& command);
    /// False where it is for others to do.
    bool inspect(const InspectionCommand& command);
    /// False where it is no command about motion and labels.
    bool act_on_dynamics(const DynamicsCommand& command);
    void set_glyphs(GlyphTexts texts);
    void depict_selected(const std::string& technique);
    void label_selected(const std::string& text);
    /// Where parts are not told apart yet, they are from the next model on, and the label follows then.
    void add_label(const Model& model, csg::OccurrenceId occurrence, const std::string& text);
    /// After a revision, or what was found: glyphs are those of the model that is shown.
    void follow_motion();
    /// The newest texts take the place of what is shown.
    void renew_text();
    void place_camera();
    void cut(const npr::Sections& sections);
    bool act(Action action);
    /// False where it is no command about settings.
    bool change_settings(const Command& command);
    void step_style(int by);
    void step_layers(int by);

    CameraRequest camera_request_;
    bool camera_placed_ = false;  ///< On a model that is not empty; from then on it is the user's.
    Document document_;
    ViewState view_;
    Customizer customizer_;
    Selection selection_;  ///< In the model that is shown, as are …
    csg::OccurrenceId selected_ = csg::kNoOccurrence;
    std::string selected_place_;
    Ghost ghost_;
    Animation animation_;
    double now_ = 0;  ///< Of the last update.
    TextPlace text_;  ///< That the text panel shows.
    bool customizing_ = false;
    Editing editing_;
    std::shared_ptr<const Annotations> annotations_;
    struct LabelToCome {
        std::shared_ptr<const Model> model;  ///< In which it was asked for.
        csg::OccurrenceId occurrence = csg::kNoOccurrence;
        std::string text;
    };
    std::optional<LabelToCome> label_to_come_;
    bool parts_given_ = false;  ///< What is a part is not for labels to say.
    HeldPart held_;
    std::optional<MoveAnswer> ways_;
    std::size_t way_taken_ = 0;
    std::optional<SelectNext> select_next_;        ///< Where that is not the same as now.
    double typed_at_ = 0;                          ///< When something was typed last.
    std::optional<std::size_t> number_step_;       ///< Steps of the text with that of the number that is dragged.
    std::chrono::steady_clock::time_point began_;  ///< The evaluation asked for last.
    Shown shown_;
    std::filesystem::path settings_file_;
    Settings settings_;
    int layer_count_ = 1;
    std::uint64_t layers_of_ = 0;  ///< Generation of the model that layer_count_ belongs to.
    Evaluate evaluate_;
    FileWatcher watcher_;
    Dynamics dynamics_;
    FindWays find_ways_;
    LatestJob<MoveAnswer> moving_;
    LatestJob<Revision> job_;  ///< Last: its jobs use the above.
};

}  // namespace ui

// The file that is shown: the last model that it gave, and what is the matter with it now.
#pragma once

#include <memory>
#include <string>

#include "ui/viewer/revision.h"

namespace ui {

enum class DocumentState {
    Evaluating,  ///< Nothing is known yet.
    Good,        ///< The model is of the newest revision.
    Failed,      ///< The newest revision has errors; the model, if any, is older.
    Gone,        ///< The file is not there; the model, if any, is what it gave last.
};

class Document {
  public:
    explicit Document(Source source) : source_(std::move(source)) {}

    /// Takes a newer revision. Where it has a model, that is shown from now on; an older one is kept otherwise.
    void receive(Revision revision);
    /// Whether the file is gone, as its watcher sees it.
    void set_gone(bool gone) { gone_ = gone; }
    /// A message of ours.
    void add_message(LineKind kind, const std::string& text) { messages_.add(kind, text); }
    void clear_messages() { messages_ = {}; }
    /// The revision that was being made is given up.
    void cancel() { canceled_ = true; }
    /// The values of the customizer's parameters in revisions to come.
    void customize(std::vector<std::string> definitions) { source_.customized = std::move(definitions); }
    /// What revisions to come show instead of the model; nothing: the model.
    void explain(std::optional<CallAt> call) { source_.explained = std::move(call); }
    /// Revisions to come show what has changed since; nothing: the model.
    void compare(std::optional<Baseline> before) { source_.before = std::move(before); }
    /// Revisions to come are without what the call makes, or have it again.
    void hide(const CallAt& call, bool hidden);
    /// Revisions to come show that alone; nothing: all.
    void show_alone(std::optional<CallAt> call) { source_.alone = std::move(call); }
    /// The text of revisions to come, where that is not what the file has.
    void edit(std::optional<std::string> text) { source_.edited = std::move(text); }
    /// $t of revisions to come.
    void set_time(double time) { source_.time = time; }
    /// Revisions to come have glyphs of that beside the model; null: none.
    void depict(std::shared_ptr<const DepictedMotion> motion) { source_.depicted = std::move(motion); }
    /// The parts of revisions to come.
    void divide(csg::PartRule parts) { source_.parts = std::move(parts); }

    [[nodiscard]] const Source& source() const { return source_; }
    [[nodiscard]] std::string file_name() const;  ///< Without its folder; empty where nothing is open.
    [[nodiscard]] DocumentState state() const;
    [[nodiscard]] const std::shared_ptr<const Model>& model() const { return model_; }  ///< Null before the first.
    /// Of the model's text, all of it; of the first that the file gave; of the baseline. Null where there is none.
    [[nodiscard]] const std::shared_ptr<const csg::Tree>& tree() const { return tree_; }
    [[nodiscard]] const std::shared_ptr<const csg::Tree>& first_tree() const { return first_tree_; }
    [[nodiscard]] const std::shared_ptr<const csg::Tree>& before() const { return before_; }
    /// The texts of the newest revision; null before the first.
    [[nodiscard]] const std::shared_ptr<const csg::scad::SourceSet>& sources() const { return sources_; }
    /// The texts of the model; null before the first.
    [[nodiscard]] const std::shared_ptr<const csg::scad::SourceSet>& model_sources() const { return model_sources_; }
    /// The glyphs of the model.
    struct Glyphs {
        std::shared_ptr<const DepictedMotion> of;  ///< Null: there are none.
        std::vector<std::string> problems;         ///< See Revision::depiction_problems.
        std::vector<BubbleRequest> bubbles;
        std::vector<FrameRequest> frames;
        std::vector<GlyphStyle> styles;
    };
    [[nodiscard]] const Glyphs& glyphs() const { return glyphs_; }
    [[nodiscard]] const csg::scad::ViewSettings& view() const { return view_; }  ///< Of the model.
    [[nodiscard]] const MessageLog& messages() const { return messages_; }       ///< Of the newest revision.
    [[nodiscard]] double milliseconds() const { return milliseconds_; }          ///< That the newest revision took.
    /// For people: what is wrong, and that the model is an older one; empty where all is well.
    [[nodiscard]] std::string trouble() const;

  private:
    Source source_;
    std::shared_ptr<const Model> model_;
    std::shared_ptr<const csg::Tree> tree_, first_tree_, before_;
    std::shared_ptr<const csg::scad::SourceSet> sources_, model_sources_;
    Glyphs glyphs_;
    csg::scad::ViewSettings view_;
    MessageLog messages_;
    std::string first_error_;  ///< Outlives clear_messages().
    double milliseconds_ = 0;
    bool received_ = false;
    bool failed_ = false;
    bool gone_ = false;
    bool canceled_ = false;
};

}  // namespace ui

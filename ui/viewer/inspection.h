// What is known of the inside of the model: findings of checks, measures, changes by part, each made by a thread of its
// own, and the thin places of the picture.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ui/pipeline/comparison/part_changes.h"
#include "ui/pipeline/inspection/layer_measures.h"
#include "ui/pipeline/inspection/sight_finder.h"
#include "ui/pipeline/picture/thickness_map.h"
#include "ui/viewer/document.h"
#include "ui/viewer/frame_log.h"
#include "ui/viewer/inspection_commands.h"
#include "ui/viewer/latest_job.h"

namespace ui {

/// A place that was found.
struct InspectedPlace {
    std::string headline;  ///< "thin wall, 0.4 mm, limit 0.8"
    std::string place;     ///< "lid.scad:12"; empty where no call is known.
    glm::dvec3 point{0.0};
    std::optional<glm::dvec3> direction;  ///< Of length 1: what is measured reaches from the point …
    double value = 0;                     ///< … so far, in world units.
    TextPlace text;
    csg::OccurrenceId occurrence = csg::kNoOccurrence;  ///< In the model that is shown.
};

/// What each answer has.
struct InspectionAnswer {
    std::uint64_t asked_of = 0;  ///< Generation of the model that was shown when it was asked for.
    std::string error;           ///< Why there is none; empty where there is.
};
struct CheckAnswer : InspectionAnswer {
    std::shared_ptr<const Model> model;    ///< That was checked: occurrences of findings are of it.
    std::vector<InspectedPlace> findings;  ///< By kind, the worst first.
    CheckResult result;
    std::shared_ptr<SightFinder> sight;  ///< In that model.
};
struct MeasuresAnswer : InspectionAnswer {
    LayerMeasures measures;
    std::vector<std::string> names;  ///< Of the parts.
};
struct ChangesAnswer : InspectionAnswer {
    std::vector<PartChange> parts;
};

/// Lives on the thread of the window.
class Inspection {
  public:
    /// `evaluate`: for this alone. `wake` is called from another thread when update() has something new.
    Inspection(Evaluate evaluate, std::function<void()> wake);

    /// Takes what has been found. True where something is new.
    bool update();
    /// Begins what is asked for, in place of what is under way. False where it is for others to do.
    bool perform(const InspectionCommand& command, const Document& document, const csg::scad::View& camera);
    void cancel();
    /// Forgets everything: another file is shown.
    void clear();
    /// A picture of the model has been drawn; null: of one that is not shown any more. `thickness`: null where it shows
    /// none.
    void see(std::shared_ptr<const Model> model, std::shared_ptr<const ThicknessMap> thickness);

    /// "check", "measure", "changes"; empty where nothing is under way.
    [[nodiscard]] const std::string& task() const { return task_; }
    /// Whole seconds since that began.
    [[nodiscard]] int task_seconds() const;
    [[nodiscard]] const std::optional<CheckAnswer>& checks() const { return checks_; }
    [[nodiscard]] const std::optional<MeasuresAnswer>& measures() const { return measures_; }
    [[nodiscard]] const std::optional<ChangesAnswer>& changes() const { return changes_; }
    /// Of the picture that is shown; null where that shows none.
    [[nodiscard]] const std::shared_ptr<const ThicknessMap>& thickness() const { return thickness_; }

    /// A finding of the last check, or a thin place of the picture, in the model that the document shows.
    [[nodiscard]] InspectedPlace finding(std::size_t index, const Document& document) const;
    [[nodiscard]] InspectedPlace thin_place(std::size_t index, const Document& document) const;
    /// A direction from which the finding is seen; see SightFinder.
    [[nodiscard]] glm::dvec3 sight(const InspectedPlace& place, const glm::dvec3& wish) const;

    void mark(InspectedPlace place) { marked_ = std::move(place); }
    void unmark() { marked_.reset(); }
    [[nodiscard]] const std::optional<InspectedPlace>& marked() const { return marked_; }

    [[nodiscard]] FrameRecord::Inspection record() const;

  private:
    using Answer = std::variant<CheckAnswer, MeasuresAnswer, ChangesAnswer>;
    void start(std::string task, LatestJob<Answer>::Job job);

    Evaluate evaluate_;
    std::optional<CheckAnswer> checks_;
    std::optional<MeasuresAnswer> measures_;
    std::optional<ChangesAnswer> changes_;
    std::shared_ptr<const Model> seen_;
    std::shared_ptr<const ThicknessMap> thickness_;
    std::optional<InspectedPlace> marked_;
    std::string task_;
    std::chrono::steady_clock::time_point began_;
    LatestJob<Answer> job_;  ///< Last: its jobs use the above.
};

}  // namespace ui

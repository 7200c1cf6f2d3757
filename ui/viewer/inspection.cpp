#include "ui/viewer/inspection.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/stop.h"
#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/inspection/check.h"
#include "ui/pipeline/inspection/finding_text.h"

namespace ui {

namespace {

/// Where the innermost call to what is there stands.
void add_call(InspectedPlace& place, const Model& model, const csg::scad::SourceSet& sources) {
    const std::vector<CallStep> steps = steps_to(model, place.occurrence);
    if (steps.empty()) {
        return;
    }
    const csg::SourceLocation& where = steps.back().node.where;
    const std::filesystem::path file(model.tree->files()[where.file]);
    place.place = fmt::format("{}:{}", file.filename().string(), where.line);
    if (auto call = call_place(model, sources, steps.back())) {
        place.text = {std::move(call->text), call->range};
    }
}

/// The model of the source's whole program, as it was customized, or an error.
std::shared_ptr<const Model> model_of(Source source, const csg::PartRule& parts, const Evaluate& evaluate,
                                      const csg::scad::View& camera, const std::stop_token& stop, Revision& revision) {
    source.sections = {};
    source.explained.reset();
    source.before.reset();
    source.parts = parts;
    revision = evaluate(source, camera, stop);
    base::end_if_asked(stop);
    if (!revision.model) {
        const std::string& error = revision.messages.first_error();
        throw ModelError(error.empty() ? "the file has errors" : error);
    }
    if (revision.model->empty()) {
        throw ModelError("the model is empty");
    }
    return revision.model;
}

/// Runs `work`, whose exceptions become the answer's error.
template <typename Answer, typename Work>
Answer answered(std::uint64_t asked_of, const Work& work) {
    Answer answer;
    answer.asked_of = asked_of;
    try {
        work(answer);
    } catch (const base::Stopped&) {
        // Nobody waits for it.
    } catch (const std::exception& error) {
        answer.error = error.what();
    }
    return answer;
}

}  // namespace

Inspection::Inspection(Evaluate evaluate, std::function<void()> wake)
    : evaluate_(std::move(evaluate)), job_(std::move(wake)) {}

void Inspection::start(std::string task, LatestJob<Answer>::Job job) {
    job_.start(std::move(job));
    task_ = std::move(task);
    began_ = std::chrono::steady_clock::now();
}

bool Inspection::update() {
    auto answer = job_.take();
    if (!answer) {
        return false;
    }
    task_.clear();
    if (auto* checks = std::get_if<CheckAnswer>(&*answer)) {
        checks_ = std::move(*checks);
    } else if (auto* measures = std::get_if<MeasuresAnswer>(&*answer)) {
        measures_ = std::move(*measures);
    } else if (auto* changes = std::get_if<ChangesAnswer>(&*answer)) {
        changes_ = std::move(*changes);
    }
    return true;
}

bool Inspection::perform(const InspectionCommand& command, const Document& document, const csg::scad::View& camera) {
    const std::uint64_t shown = document.model() ? document.model()->generation : 0;
    if (const auto* checks = std::get_if<RunChecks>(&command)) {
        Source source = document.source();
        source.preview = false;
        source.showing = csg::Showing::Result;
        source.hidden.clear();
        source.alone.reset();
        start("check", [=, evaluate = evaluate_, asked = *checks](const std::stop_token& stop) -> Answer {
            return answered<CheckAnswer>(shown, [&](CheckAnswer& answer) {
                Revision revision;
                answer.model = model_of(source, asked.parts, evaluate, camera, stop, revision);
                need_whole(*answer.model);
                if (answer.model->flat) {
                    throw ModelError("the model is an outline in the plane, which has no walls; extrude it first");
                }
                answer.result = check(*answer.model, asked.request, stop);
                answer.sight = std::make_shared<SightFinder>(answer.model);
                for (const Finding& f : answer.result.findings) {
                    InspectedPlace& place = answer.findings.emplace_back();
                    place.headline = headline(*answer.model, f);
                    place.point = f.point;
                    place.direction = f.kind == FindingKind::Size ? std::nullopt : f.direction;
                    place.value = f.direction ? f.value.value_or(0) : 0;
                    place.occurrence = f.occurrence;
                    add_call(place, *answer.model, *revision.sources);
                }
            });
        });
    } else if (const auto* measures = std::get_if<RunMeasures>(&command)) {
        start("measure",
              [=, evaluate = evaluate_, source = document.source(),
               asked = *measures](const std::stop_token& stop) -> Answer {
                  return answered<MeasuresAnswer>(shown, [&](MeasuresAnswer& answer) {
                      Revision revision;
                      const auto model = model_of(source, asked.parts, evaluate, camera, stop, revision);
                      answer.measures = measure_by_layers(*model, asked.precision, stop);
                      for (const csg::Part& part : model->scene.parts) {
                          answer.names.push_back(part.name);
                      }
                  });
              });
    } else if (const auto* parts = std::get_if<RunPartChanges>(&command)) {
        if (!document.before() || !document.tree()) {
            return true;
        }
        start("changes",
              [=, before = document.before(), after = document.tree(),
               asked = *parts](const std::stop_token& stop) -> Answer {
                  return answered<ChangesAnswer>(shown, [&](ChangesAnswer& answer) {
                      answer.parts = part_changes(*before, *after, asked.parts, stop);
                  });
              });
    } else if (std::holds_alternative<CancelInspection>(command)) {
        cancel();
    } else {
        return false;
    }
    return true;
}

void Inspection::cancel() {
    job_.cancel();
    task_.clear();
}

void Inspection::clear() {
    cancel();
    checks_.reset();
    measures_.reset();
    changes_.reset();
    marked_.reset();
    thickness_.reset();
    seen_.reset();
}

void Inspection::see(std::shared_ptr<const Model> model, std::shared_ptr<const ThicknessMap> thickness) {
    if (model) {
        thickness_ = std::move(thickness);
        seen_ = std::move(model);
    }
}

int Inspection::task_seconds() const {
    using std::chrono::duration_cast, std::chrono::seconds;
    return static_cast<int>(duration_cast<seconds>(std::chrono::steady_clock::now() - began_).count());
}

InspectedPlace Inspection::finding(std::size_t index, const Document& document) const {
    if (!checks_ || index >= checks_->findings.size()) {
        return {};
    }
    InspectedPlace place = checks_->findings[index];
    place.occurrence =
        document.model() ? occurrence_like(*checks_->model, place.occurrence, *document.model()) : csg::kNoOccurrence;
    return place;
}

InspectedPlace Inspection::thin_place(std::size_t index, const Document& document) const {
    InspectedPlace place;
    if (!thickness_ || index >= thickness_->places.size()) {
        return place;
    }
    const ThinPlace& thin = thickness_->places[index];
    place.headline = fmt::format("{:.6g} mm", thin.value);
    place.point = thin.point;
    place.direction = thin.direction;
    place.value = thin.value;
    if (seen_ == document.model() && document.model_sources()) {
        place.occurrence = thin.occurrence;
        add_call(place, *seen_, *document.model_sources());
    }
    return place;
}

glm::dvec3 Inspection::sight(const InspectedPlace& place, const glm::dvec3& wish) const {
    return checks_ && checks_->sight ? checks_->sight->from(place.point, wish) : wish;
}

FrameRecord::Inspection Inspection::record() const {
    FrameRecord::Inspection record;
    record.task = task_;
    if (thickness_) {
        record.range = thickness_->range;
        record.thin_places = static_cast<int>(thickness_->places.size());
    }
    if (checks_) {
        record.findings = static_cast<int>(checks_->findings.size());
        record.error = checks_->error;
    }
    if (measures_) {
        record.volume = measures_->measures.all.volume.value;
    }
    if (changes_) {
        record.changed_parts = 0;
        for (const PartChange& part : changes_->parts) {
            record.changed_parts += part.kind == PartChange::Kind::Unchanged ? 0 : 1;
        }
    }
    record.marked = marked_ ? marked_->headline : "";
    return record;
}

}  // namespace ui

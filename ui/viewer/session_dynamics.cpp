// What commands do to depictions of motion and to labels.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/motion/body_at.h"
#include "ui/pipeline/picture/camera.h"
#include "ui/viewer/session.h"

namespace ui {

namespace {

/// Null where nothing is selected.
const csg::Part* part_of(const Model& model, csg::OccurrenceId occurrence) {
    const auto leaf = std::ranges::find(model.scene.leaves, occurrence, &csg::LeafInstance::occurrence);
    return occurrence == csg::kNoOccurrence || leaf == model.scene.leaves.end() ? nullptr
                                                                                : &model.scene.parts[leaf->part];
}

}  // namespace

bool Session::act_on_dynamics(const DynamicsCommand& command) {
    if (const auto* glyphs = std::get_if<SetGlyphs>(&command)) {
        set_glyphs(glyphs->texts);
    } else if (const auto* depicted = std::get_if<DepictSelected>(&command)) {
        depict_selected(depicted->technique);
    } else if (const auto* label = std::get_if<LabelSelected>(&command)) {
        label_selected(label->text);
    } else if (std::holds_alternative<CancelMotion>(command)) {
        dynamics_.cancel();
    } else if (std::holds_alternative<LookForMotion>(command)) {
        dynamics_.forget_canceled();
        follow_motion();
    }
    return true;
}

void Session::set_glyphs(GlyphTexts texts) {
    dynamics_.set(std::move(texts));
    const AnnotationTexts& annotations = dynamics_.texts().annotations;
    const bool needs_parts = !annotations.labels.empty() || annotations.callouts;
    bool evaluates = false;
    if (needs_parts && !parts_given_) {
        const csg::PartRule wanted = parts_of_labels(annotations);
        evaluates = document_.source().parts != wanted;
        document_.divide(wanted);
    }
    const auto depicted = dynamics_.depicted(camera_request_.aspect);
    evaluates |= depicted != nullptr || document_.source().depicted != nullptr;
    document_.depict(depicted);
    follow_motion();
    if (evaluates && document_.model()) {
        follow_soon();
    }
}

void Session::follow_motion() {
    if (dynamics_.wants_motion(shown_.dynamics)) {
        dynamics_.look(document_, scad_view(view_.picture.camera));
    }
    // Once it is known, the model is made with it.
    const auto& drawn = document_.source().depicted;
    const auto known = dynamics_.depicted(camera_request_.aspect);
    if (known && (!drawn || drawn->motion != known->motion)) {
        document_.depict(known);
        follow_soon();
    }
    if (label_to_come_ && document_.model() && document_.model() != label_to_come_->model) {
        const LabelToCome label = *std::exchange(label_to_come_, {});
        add_label(*document_.model(), occurrence_like(*label.model, label.occurrence, *document_.model()), label.text);
    }
    annotations_ = dynamics_.annotations(document_);
}

void Session::depict_selected(const std::string& technique) {
    const auto& model = document_.model();
    if (!model || selected_ == csg::kNoOccurrence) {
        document_.add_message(LineKind::Warning, "WARNING: click what is to be depicted first");
        return;
    }
    if (!dynamics_.motion()) {
        document_.add_message(LineKind::Warning, "WARNING: what moves is not known yet");
        return;
    }
    const auto leaf = std::ranges::find(model->scene.leaves, selected_, &csg::LeafInstance::occurrence);
    const csg::Box box = leaf == model->scene.leaves.end()
                             ? csg::Box{}
                             : model->geometry.leaves[static_cast<std::size_t>(leaf - model->scene.leaves.begin())].box;
    const glm::dvec3 point = selection_.empty() ? 0.5 * (box.lo + box.hi) : selection_.current().surface.point;
    const MovingBody* const body = body_at(*dynamics_.motion(), *model, selected_, point, document_.source().time);
    if (body == nullptr) {
        document_.add_message(LineKind::Warning, fmt::format("WARNING: what is selected does not move while $t runs"));
        return;
    }
    GlyphTexts texts = dynamics_.texts();
    texts.depictions.push_back(
        fmt::format("{} {{{}}}{}", technique, body->name, technique == "speak" ? " (text=\"…\")" : ""));
    set_glyphs(std::move(texts));
}

void Session::label_selected(const std::string& text) {
    const auto& model = document_.model();
    if (!model || selected_ == csg::kNoOccurrence) {
        document_.add_message(LineKind::Warning, "WARNING: click what is to be labeled first");
        return;
    }
    const AnnotationTexts& annotations = dynamics_.texts().annotations;
    if (!parts_given_ && annotations.labels.empty() && !annotations.callouts) {
        label_to_come_ = LabelToCome{model, selected_, text};
        document_.divide({csg::PartRule::Kind::Depth, 1, {}});
        evaluate();
        return;
    }
    add_label(*model, selected_, text);
}

void Session::add_label(const Model& model, csg::OccurrenceId occurrence, const std::string& text) {
    const csg::Part* const part = part_of(model, occurrence);
    if (part == nullptr) {
        return;
    }
    GlyphTexts texts = dynamics_.texts();
    texts.annotations.labels.push_back(fmt::format("{}={}", part->name, text.empty() ? part->name : text));
    set_glyphs(std::move(texts));
}

}  // namespace ui

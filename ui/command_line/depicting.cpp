#include "ui/command_line/depicting.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "ui/command_line/files.h"
#include "ui/pipeline/annotation/annotation_texts.h"
#include "ui/pipeline/picture/camera.h"

namespace ui {

std::vector<Depiction> rules_of(const Options& options) {
    if (options.depiction_rules.empty()) {
        return {};
    }
    try {
        return read_depiction_rules(read_source(options.depiction_rules), options.depiction_rules);
    } catch (const std::runtime_error& problem) {
        throw UsageError(fmt::format("--depict-rules: {}", problem.what()));
    }
}

void Depicting::read() {
    annotations_ = annotations_of(options_.annotations);
    depictions_ = options_.depictions;
    const std::vector<Depiction> rules = rules_of(options_);
    depictions_.insert(depictions_.end(), rules.begin(), rules.end());
}

const Motion& Depicting::motion() {
    if (!motion_) {
        MotionRequest request;
        request.derivatives = false;
        for (const Depiction& d : depictions_) {
            request.from = std::min(request.from, d.times ? d.times->first : 0);
            request.to = std::max(request.to, d.times ? d.times->second : 1);
        }
        language_.progress().say("Looking for what moves…");
        language_.hold_memory_limit();
        motion_ = find_motion([this](double time) { return language_.evaluate_at(time); }, request, limit_.token());
        language_.progress().say("");
    }
    return *motion_;
}

std::shared_ptr<const csg::Tree> Depicting::depicted(std::shared_ptr<const csg::Tree> tree, double now) {
    if (depictions_.empty()) {
        return tree;
    }
    const DepictionSource source{*tree, motion(), now, [this](double time) { return camera_at(time); },
                                 static_cast<double>(options_.picture.size.x) / options_.picture.size.y};
    std::shared_ptr<const csg::Tree> result;
    try {
        Depicted made = depict(source, depictions_, limit_.token());
        result = std::make_shared<const csg::Tree>(std::move(made.tree));
        annotations_.bubbles = std::move(made.bubbles);
        annotations_.frames = std::move(made.frames);
        styles_ = std::move(made.styles);
    } catch (const std::runtime_error& problem) {
        throw UsageError(fmt::format("--depict: {}", problem.what()));
    }
    if ((!annotations_.bubbles.empty() || !annotations_.frames.empty()) &&
        (!options_.plan.empty() || options_.thickness)) {
        throw UsageError("--depict: bubbles and frames are for one view; leave --plan and --thickness out");
    }
    return result;
}

/// That of the program, wherever the picture is taken from.
base::Camera Depicting::camera_at(double time) {
    CameraRequest request;
    request.projection = options_.projection;
    return choose_camera(request, language_.view_at(time), {});
}

std::shared_ptr<const Model> Depicting::annotated(const Model& model, const npr::Picture& picture, Renderer& renderer) {
    if (!annotations_.any()) {
        return nullptr;
    }
    const base::View view(picture.camera, picture.size, model.geometry.box.lo, model.geometry.box.hi);
    const Annotated made = annotate(
        model, view, [&](int layers) { return renderer.first_layers(model, view, layers); }, annotations_,
        picture.scheme.background);
    for (const std::size_t label : made.unseen) {
        language_.messages().warn(
            fmt::format("--label {}: nothing of it is in the picture", options_.annotations.labels[label]));
    }
    if (options_.hard_warnings && !made.unseen.empty()) {
        throw ModelError("stopped at a warning");
    }
    return made.model;
}

}  // namespace ui

#include "ui/viewer/label_layer.h"

#include <fmt/format.h>

#include "ui/pipeline/stopwatch.h"

namespace ui {

const Model& LabelLayer::annotated(const Model& model, const PictureRequest& picture,
                                   const std::shared_ptr<const Annotations>& wanted, std::uint64_t version) {
    if (!wanted || model.empty()) {
        annotated_.reset();
        of_.reset();
        error_.clear();
        return model;
    }
    if (of_ != wanted || version_ != version) {
        of_ = wanted;
        version_ = version;
        annotated_.reset();
        error_.clear();
        Stopwatch watch;
        if (!peeler_) {
            peeler_.emplace(goldfeather::EngineOptions{}, Painter::Cpu);
        }
        try {
            const base::View view(picture.camera, picture.size, model.geometry.box.lo, model.geometry.box.hi);
            Annotated made = annotate(
                model, view, [&](int layers) { return peeler_->first_layers(model, view, layers); }, *wanted,
                picture.scheme.background);
            annotated_ = std::move(made.model);
            for (const std::size_t label : made.unseen) {
                error_ += fmt::format("{}nothing of {} is in the picture", error_.empty() ? "" : "\n",
                                      wanted->labels[label].of.text);
            }
        } catch (const ModelError& error) {
            error_ = error.what();
        }
        milliseconds_ = watch.lap();
    }
    return annotated_ ? *annotated_ : model;
}

void LabelLayer::update(const Model& model, const csg::solid::SceneChange& change) {
    if (peeler_) {
        peeler_->update(model, change);
    }
}

}  // namespace ui

#include "ui/command_line/film_frames.h"

#include <utility>

#include "ui/pipeline/mesh/outline.h"

namespace ui {

std::shared_ptr<const Model> FilmFrames::follow(const std::shared_ptr<const csg::Tree>& tree,
                                                const npr::Sections& sections, Renderer* renderer) {
    if (options_.frames == 0 || model_ == nullptr || needs_geometry(options_)) {
        return nullptr;
    }
    if (same_content(*tree_, *tree)) {
        leaves_kept_ += model_->scene.leaves.size();
        return model_;
    }
    // What is not made of the scene alone would be of another tree.
    if (!options_.preview || !sections.cuts.empty() || extent_of(*model_) == Extent::Flat) {
        return nullptr;
    }
    if (!moving_) {
        moving_.emplace(*model_, options_.preview ? csg::Showing::Preview : csg::Showing::Result, options_.parts);
    }
    if (!moving_->follow(*tree)) {
        return nullptr;
    }
    if (renderer != nullptr) {
        renderer->update(moving_->model(), moving_->change());
    }
    tree_ = tree;
    model_ = std::shared_ptr<const Model>(std::shared_ptr<const Model>(), &moving_->model());
    leaves_placed_ += moving_->moved();
    leaves_kept_ += model_->scene.leaves.size() - moving_->moved();
    image_.reset();
    return model_;
}

void FilmFrames::built(std::shared_ptr<const Model> model, std::shared_ptr<const csg::Tree> tree) {
    leaves_placed_ += model->scene.leaves.size();
    model_ = std::move(model);
    tree_ = std::move(tree);
    moving_.reset();
    image_.reset();
}

const base::Image* FilmFrames::same_image(const npr::Picture& picture) const {
    return options_.frames != 0 && image_ && picture_ == picture ? &*image_ : nullptr;
}

const base::Image& FilmFrames::drew(base::Image image, const npr::Picture& picture) {
    ++drawn_;
    picture_ = picture;
    return image_.emplace(std::move(image));
}

Json FilmFrames::figures() const {
    return {{"frames", options_.end_frame - options_.first_frame},
            {"drawn", drawn_},
            {"leaves_placed", leaves_placed_},
            {"leaves_kept", leaves_kept_}};
}

}  // namespace ui

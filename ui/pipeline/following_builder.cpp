#include "ui/pipeline/following_builder.h"

#include <utility>

#include "base/stop.h"
#include "ui/pipeline/model_parts.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

namespace {

/// Larger models are not kept twice.
constexpr std::size_t kMostTriangles = 2'000'000;
/// Where more than one in so many leaves has moved, nothing is gained.
constexpr std::size_t kFewInLeaves = 8;

}  // namespace

void FollowingBuilder::forget() {
    last_.reset();
    moving_.reset();
}

void FollowingBuilder::show(csg::Showing showing) {
    if (std::exchange(showing_, showing) != showing) {
        forget();
    }
    builder_.show(showing);
}

void FollowingBuilder::divide(csg::PartRule parts) {
    if (!(parts == parts_)) {
        forget();
    }
    parts_ = parts;
    builder_.divide(std::move(parts));
}

void FollowingBuilder::cut(npr::Sections sections) {
    if (!(sections == sections_)) {
        forget();
    }
    sections_ = sections;
    builder_.cut(std::move(sections));
}

std::shared_ptr<Model> FollowingBuilder::follow(const csg::Tree& tree) {
    if (!last_ || !last_->warnings.empty() || !last_->failures.empty() || !sections_.cuts.empty() || last_->empty() ||
        last_->statistics.triangles > kMostTriangles) {
        return nullptr;
    }
    Stopwatch watch;
    csg::Scene scene = csg::make_scene(tree, showing_, parts_);
    const auto moved = leaves_moved(*last_, tree, scene);
    if (!moved || *moved > 1 + scene.leaves.size() / kFewInLeaves) {
        return nullptr;
    }
    if (!moving_) {
        moving_ = std::make_unique<MovingModel>(*last_, showing_, parts_);
    }
    if (!moving_->follow(tree)) {
        return nullptr;
    }
    auto model = std::make_shared<Model>(moving_->model());
    model->generation = next_generation();
    model->scene = std::move(scene);
    const ModelStatistics times = model->statistics;
    model->statistics = last_->statistics;
    model->statistics.normalize_ms = times.normalize_ms;
    model->statistics.place_ms = watch.lap() - times.normalize_ms;
    return model;
}

std::shared_ptr<const Model> FollowingBuilder::build(std::shared_ptr<const csg::Tree> tree, const std::stop_token& stop,
                                                     std::shared_ptr<const csg::scad::LoadedProgram> program) {
    base::end_if_asked(stop);
    std::shared_ptr<Model> followed = follow(*tree);
    followed_ = followed != nullptr;
    if (!followed) {
        forget();
        last_ = builder_.build(std::move(tree), stop, std::move(program));
        return last_;
    }
    followed->tree = std::move(tree);
    followed->program = std::move(program);
    last_ = std::move(followed);
    return last_;
}

}  // namespace ui

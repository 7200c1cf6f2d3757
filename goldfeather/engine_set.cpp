#include "goldfeather/engine_set.h"

#include <string>
#include <utility>

namespace goldfeather {
namespace {

class SceneWithFallback : public PreparedScene {
  public:
    SceneWithFallback(const EngineInput& input, Engine& meant, Engine& fallback)
        : input_(input), meant_(meant), fallback_(fallback) {
        prepare();
    }

    layers::Stack draw(const base::View& view, int max_layers, WalkStats& stats, const std::stop_token& stop) override {
        if (scene_) {
            try {
                return scene_->draw(view, max_layers, stats, stop);
            } catch (const EngineObstacle& obstacle) {
                stats.fallback = obstacle.what();
            }
        } else {
            stats.fallback = obstacle_;
        }
        if (!other_) {
            other_ = fallback_.prepare(input_);
        }
        return other_->draw(view, max_layers, stats, stop);
    }

    bool update(const csg::solid::SceneChange& change) override {
        try {
            if (!scene_ || !scene_->update(change)) {
                prepare();
            }
        } catch (const EngineObstacle& obstacle) {
            scene_.reset();
            obstacle_ = obstacle.what();
        }
        if (other_ && !other_->update(change)) {
            other_.reset();
        }
        return true;
    }

  private:
    void prepare() {
        scene_.reset();  // Before the next is made: the two need not fit together.
        try {
            scene_ = meant_.prepare(input_);
        } catch (const EngineObstacle& obstacle) {
            obstacle_ = obstacle.what();
        }
    }

    EngineInput input_;
    Engine &meant_, &fallback_;
    std::unique_ptr<PreparedScene> scene_, other_;  ///< Null where there is an obstacle; made when first needed.
    std::string obstacle_;                          ///< To every picture of the scene.
};

}  // namespace

Engine& EngineSet::engine(const EngineInfo& info) {
    std::unique_ptr<Engine>& made = made_[info.name];
    if (!made) {
        made = make_engine(info, settings_);
    }
    return *made;
}

std::unique_ptr<PreparedScene> EngineSet::prepare(const EngineInput& input, Engine& meant) {
    Engine& fallback = engine(fallback_engine());
    if (&meant == &fallback) {
        return meant.prepare(input);
    }
    return std::make_unique<SceneWithFallback>(input, meant, fallback);
}

}  // namespace goldfeather

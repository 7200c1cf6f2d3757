#include "goldfeather/lists/lists_engine.h"

#include <optional>
#include <string>

#include "csg/solid/part_order.h"
#include "gl/error.h"
#include "goldfeather/lists/lists.h"

namespace goldfeather {
namespace {

class ListsEngine : public Engine {
  public:
    explicit ListsEngine(const EngineSettings& settings) : settings_(settings) {}
    std::unique_ptr<PreparedScene> prepare(const EngineInput& input) override {
        return std::make_unique<Scene>(*this, input);
    }

  private:
    class Scene : public PreparedScene {
      public:
        Scene(ListsEngine& engine, const EngineInput& input)
            : engine_(engine),
              geometry_(input.geometry),
              order_(csg::solid::part_order(input.scene, &input.geometry)),
              leaves_(*engine.settings_.gl, input.geometry),
              expressions_(*engine.settings_.gl, input.scene, order_) {}
        layers::Stack draw(const base::View& view, int max_layers, WalkStats& stats,
                           const std::stop_token& stop) override {
            Lists& lists = engine_.lists();
            try {
                return {nullptr, std::make_shared<layers::TextureStack>(
                                     lists.peel(view, geometry_, leaves_, expressions_, max_layers, stats, stop))};
            } catch (const gl::Error& error) {
                throw EngineObstacle(error.what());  // Of this picture.
            }
        }
        bool update(const csg::solid::SceneChange& change) override {
            if (change.structure || csg::solid::part_order(expressions_.scene, &geometry_) != order_) {
                return false;
            }
            leaves_.update(change);
            return true;
        }

      private:
        ListsEngine& engine_;
        const csg::solid::Geometry& geometry_;
        std::vector<csg::PartId> order_;
        LeafBuffers leaves_;
        ListsScene expressions_;
    };

    Lists& lists() {
        if (!lists_ && fault_.empty()) {
            try {
                lists_.emplace(*settings_.gl, settings_.memory_budget);
            } catch (const gl::Error& error) {
                fault_ = error.what();  // Nor will it be better the next time.
            }
        }
        if (!lists_) {
            throw EngineObstacle(fault_);
        }
        return *lists_;
    }

    EngineSettings settings_;
    std::optional<Lists> lists_;
    std::string fault_;  ///< Why there are no lists on this OpenGL.
};

}  // namespace

std::unique_ptr<Engine> ListsEntry::make(const EngineSettings& settings) {
    return std::make_unique<ListsEngine>(settings);
}

}  // namespace goldfeather

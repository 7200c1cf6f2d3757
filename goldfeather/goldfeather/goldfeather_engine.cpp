#include "goldfeather/goldfeather/goldfeather_engine.h"

#include <optional>

#include "goldfeather/goldfeather/goldfeather.h"
#include "goldfeather/parts_scene.h"

namespace goldfeather {
namespace {

class GoldfeatherEngine : public Engine {
  public:
    explicit GoldfeatherEngine(const EngineSettings& settings) : settings_(settings), merge_(*settings.gl) {}
    std::unique_ptr<PreparedScene> prepare(const EngineInput& input) override {
        return std::make_unique<Scene>(*this, input);
    }

  private:
    class Scene : public PreparedScene {
      public:
        Scene(GoldfeatherEngine& engine, const EngineInput& input)
            : engine_(engine), parts_(*engine.settings_.gl, input) {}
        layers::Stack draw(const base::View& view, int max_layers, WalkStats& stats,
                           const std::stop_token& stop) override {
            Goldfeather& walker = engine_.walker();
            const auto walk = [&](LeafBuffers& leaves, const PartProducts& part) {
                return walker.walk(view, leaves, part, max_layers, stats, stop);
            };
            return {nullptr,
                    std::make_shared<layers::TextureStack>(parts_.draw(walk, engine_.merge_, max_layers, stop))};
        }
        bool update(const csg::solid::SceneChange& change) override { return parts_.update(change); }

      private:
        GoldfeatherEngine& engine_;
        PartsScene parts_;
    };

    Goldfeather& walker() {
        if (!walker_) {
            walker_.emplace(*settings_.gl, settings_.memory_budget, settings_.minimal_fraction);
        }
        return *walker_;
    }

    EngineSettings settings_;
    std::optional<Goldfeather> walker_;
    peel::Merge merge_;
};

}  // namespace

std::unique_ptr<Engine> GoldfeatherEntry::make(const EngineSettings& settings) {
    return std::make_unique<GoldfeatherEngine>(settings);
}

}  // namespace goldfeather

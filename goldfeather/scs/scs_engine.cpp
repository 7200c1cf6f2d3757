#include "goldfeather/scs/scs_engine.h"

#include <optional>

#include "goldfeather/parts_scene.h"
#include "goldfeather/scs/scs.h"

namespace goldfeather {
namespace {

class ScsEngine : public Engine {
  public:
    explicit ScsEngine(const EngineSettings& settings) : settings_(settings), merge_(*settings.gl) {}
    std::unique_ptr<PreparedScene> prepare(const EngineInput& input) override {
        return std::make_unique<Scene>(*this, input);
    }

  private:
    class Scene : public PreparedScene {
      public:
        Scene(ScsEngine& engine, const EngineInput& input) : engine_(engine), parts_(*engine.settings_.gl, input) {}
        layers::Stack draw(const base::View& view, int max_layers, WalkStats& stats,
                           const std::stop_token& stop) override {
            const EngineInput& input = parts_.input();
            for (std::size_t part = 0; part < input.products.size(); ++part) {
                const std::string obstacle =
                    input.scene.parts[part].hidden
                        ? ""
                        : Scs::obstacle(view, input.geometry, input.products[part], max_layers);
                if (!obstacle.empty()) {
                    throw EngineObstacle(obstacle);
                }
            }
            Scs& scs = engine_.scs();
            const auto peel = [&](LeafBuffers& leaves, const PartProducts& part) {
                return scs.peel(view, leaves, part, stats, stop);
            };
            return {nullptr,
                    std::make_shared<layers::TextureStack>(parts_.draw(peel, engine_.merge_, max_layers, stop))};
        }
        bool update(const csg::solid::SceneChange& change) override { return parts_.update(change); }

      private:
        ScsEngine& engine_;
        PartsScene parts_;
    };

    Scs& scs() {
        if (!scs_) {
            scs_.emplace(*settings_.gl, settings_.memory_budget);
        }
        return *scs_;
    }

    EngineSettings settings_;
    std::optional<Scs> scs_;
    peel::Merge merge_;
};

}  // namespace

std::unique_ptr<Engine> ScsEntry::make(const EngineSettings& settings) {
    return std::make_unique<ScsEngine>(settings);
}

}  // namespace goldfeather

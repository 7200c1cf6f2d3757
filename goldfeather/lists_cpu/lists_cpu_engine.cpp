#include "goldfeather/lists_cpu/lists_cpu_engine.h"

#include "goldfeather/lists_cpu/lists_cpu.h"

namespace goldfeather {
namespace {

class ListsCpuEngine : public Engine {
  public:
    explicit ListsCpuEngine(const EngineSettings& settings) : settings_(settings) {}
    std::unique_ptr<PreparedScene> prepare(const EngineInput& input) override {
        return std::make_unique<Scene>(*this, input);
    }

  private:
    class Scene : public PreparedScene {
      public:
        Scene(ListsCpuEngine& engine, const EngineInput& input)
            : engine_(engine), model_(input.scene, input.geometry) {}
        layers::Stack draw(const base::View& view, int max_layers, WalkStats& stats,
                           const std::stop_token& stop) override {
            std::shared_ptr<layers::HostStack>& stack = engine_.stack_;
            if (!stack || stack.use_count() > 1) {
                stack = std::make_shared<layers::HostStack>();
            }
            ListsStats lists;
            peel_lists(model_, view, max_layers, engine_.settings_.threads, *stack, lists, stop);
            add(stats, lists);
            layers::leave_out_sparse_layers(*stack, engine_.settings_.minimal_fraction);
            return {stack, nullptr};
        }
        /// Expressions are all that is made of a scene.
        bool update(const csg::solid::SceneChange& change) override { return !change.structure; }

      private:
        ListsCpuEngine& engine_;
        ListsModel model_;
    };

    EngineSettings settings_;
    std::shared_ptr<layers::HostStack> stack_;  ///< Of the picture before, whichever scene's.
};

}  // namespace

std::unique_ptr<Engine> ListsCpuEntry::make(const EngineSettings& settings) {
    return std::make_unique<ListsCpuEngine>(settings);
}

}  // namespace goldfeather

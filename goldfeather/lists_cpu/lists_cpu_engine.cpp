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
            const bool own = engine_.filled_by_ == this && stack && stack.use_count() == 1;
            if (!stack || stack.use_count() > 1) {
                stack = std::make_shared<layers::HostStack>();
            }
            engine_.filled_by_ = this;
            ListsStats lists;
            const EngineSettings& settings = engine_.settings_;
            if (edited_ && !(settings.minimal_fraction > 0)) {
                if (!own) {
                    kept_.forget();
                }
                kept_.peel(model_, view, max_layers, settings.threads, *stack, lists, stop);
            } else {
                peel_lists(model_, view, max_layers, settings.threads, *stack, lists, stop);
            }
            add(stats, lists);
            layers::leave_out_sparse_layers(*stack, settings.minimal_fraction);
            return {stack, nullptr};
        }
        /// Expressions are all that is made of a scene.
        bool update(const csg::solid::SceneChange& change) override {
            edited_ = true;
            kept_.changed(change);
            return !change.structure;
        }
        ~Scene() override {
            if (engine_.filled_by_ == this) {
                engine_.filled_by_ = nullptr;
            }
        }
        Scene(const Scene&) = delete;
        Scene& operator=(const Scene&) = delete;

      private:
        ListsCpuEngine& engine_;
        ListsModel model_;
        bool edited_ = false;  ///< From then on pictures are kept.
        KeptLists kept_;
    };

    EngineSettings settings_;
    std::shared_ptr<layers::HostStack> stack_;  ///< Of the picture before, …
    const PreparedScene* filled_by_ = nullptr;  ///< … and whose that was.
};

}  // namespace

std::unique_ptr<Engine> ListsCpuEntry::make(const EngineSettings& settings) {
    return std::make_unique<ListsCpuEngine>(settings);
}

}  // namespace goldfeather

#include "tests/bench/drawer.h"

#include <limits>
#include <utility>

namespace bench {

namespace {

/// Models with more leaves, or literals over all products, take minutes with engines that need a pass a layer or a
/// literal.
constexpr std::size_t kMostLeavesOfPasses = 1500, kMostLiteralsOfPasses = 6000;

bool too_much_for_passes(const ui::Model& model) {
    return !model.over_budget.empty() || model.statistics.leaves > kMostLeavesOfPasses ||
           model.statistics.literals > kMostLiteralsOfPasses;
}

double distance(const base::View& view, float depth) {
    return depth > 0 ? view.distance(static_cast<double>(depth)) : std::numeric_limits<double>::infinity();
}

/// One of our engines. Stacks of those that need no OpenGL stay in main memory, where styles are painted from them.
class EngineDrawer final : public Drawer {
  public:
    EngineDrawer(gl::Context& context, goldfeather::EngineSet& engines, const ui::Model& model,
                 const goldfeather::EngineInfo& engine)
        : context_(context), scene_(engines.prepare({model.scene, model.geometry, model.products}, engine)) {}
    void prepare(const base::View& view) override {
        context_.make_current();
        view_.emplace(view);
    }
    bool draw(const base::View& view, int layers) override {
        context_.make_current();
        goldfeather::WalkStats stats;
        stack_ = {};  // Its memory is used again.
        stack_ = scene_->draw(view, layers, stats);
        context_.functions().Finish();
        return stats.fallback.empty();
    }
    std::vector<int> counts() override { return read()->counts; }
    std::vector<double> distances() override {
        const auto host = read();
        std::vector<double> result;
        for (const float depth : host->planes.front().depth) {
            result.push_back(distance(*view_, depth));
        }
        return result;
    }

  private:
    [[nodiscard]] std::shared_ptr<const layers::HostStack> read() {
        context_.make_current();
        return layers::in_main_memory(context_.functions(), stack_);
    }

    gl::Context& context_;
    std::unique_ptr<goldfeather::PreparedScene> scene_;
    layers::Stack stack_;
    std::optional<base::View> view_;
};

class OpenCsgDrawer final : public Drawer {
  public:
    OpenCsgDrawer(opencsg::OpenCsg& opencsg, const ui::Model& model, opencsg::Algorithm algorithm)
        : opencsg_(opencsg), model_(model), algorithm_(algorithm) {}
    void prepare(const base::View& view) override { opencsg_.load(model_.geometry, model_.products, view, algorithm_); }
    bool draw(const base::View& /*view*/, int layers) override {
        if (layers != 1) {
            return false;
        }
        opencsg_.draw();
        return true;
    }
    std::vector<int> counts() override {
        std::vector<int> result;
        for (const double d : distances()) {
            result.push_back(d < std::numeric_limits<double>::infinity() ? 1 : 0);
        }
        return result;
    }
    std::vector<double> distances() override { return opencsg_.read().distance; }

  private:
    opencsg::OpenCsg& opencsg_;
    const ui::Model& model_;
    opencsg::Algorithm algorithm_;
};

}  // namespace

DrawerSet::DrawerSet(gl::Context& context, int largest) : context_(context), engines_({&context.functions()}) {
    auto made = opencsg::create(glm::ivec2(largest));
    opencsg_ = std::move(made.engine);
    missing_ = opencsg_ ? "" : "OpenCSG: " + made.reason;
    context_.make_current();
}

const std::vector<std::string>& DrawerSet::names() {
    static const std::vector<std::string> all{"lists-cpu",           "lists",      "goldfeather", "scs",
                                              "OpenCSG Goldfeather", "OpenCSG SCS"};
    return all;
}

std::unique_ptr<Drawer> DrawerSet::make(const std::string& name, const ui::Model& model) {
    if (const goldfeather::EngineInfo* engine = goldfeather::find_engine(name)) {
        if (engine->capabilities.needs_products && too_much_for_passes(model)) {
            return nullptr;
        }
        context_.make_current();
        return std::make_unique<EngineDrawer>(context_, engines_, model, *engine);
    }
    if (!opencsg_ || too_much_for_passes(model)) {
        return nullptr;
    }
    return std::make_unique<OpenCsgDrawer>(
        *opencsg_, model, name == "OpenCSG SCS" ? opencsg::Algorithm::Scs : opencsg::Algorithm::Goldfeather);
}

}  // namespace bench

#include "tests/bench/drawer.h"

#include <limits>
#include <map>
#include <utility>

namespace bench {

namespace {

using goldfeather::EngineKind;

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

/// Lists on the CPU end in main memory, where styles are painted from them.
class CpuDrawer final : public Drawer {
  public:
    explicit CpuDrawer(const ui::Model& model) : lists_(model.scene, model.geometry) {}
    void prepare(const base::View& view) override { view_.emplace(view); }
    bool draw(const base::View& view, int layers) override {
        goldfeather::ListsStats stats;
        goldfeather::peel_lists(lists_, view, layers, 0, layers_, stats);
        return true;
    }
    std::vector<int> counts() override { return layers_.counts; }
    std::vector<double> distances() override {
        std::vector<double> result;
        for (const float depth : layers_.planes[0].depth) {
            result.push_back(distance(*view_, depth));
        }
        return result;
    }

  private:
    goldfeather::ListsModel lists_;
    layers::HostStack layers_;
    std::optional<base::View> view_;
};

class GlDrawer final : public Drawer {
  public:
    GlDrawer(gl::Context& context, peel::Peeler& peeler, const ui::Model& model, EngineKind kind)
        : context_(context),
          peeler_(peeler),
          model_(context.functions(), model.scene, model.geometry, model.products, kind) {}
    void prepare(const base::View& view) override {
        context_.make_current();
        view_.emplace(view);
    }
    bool draw(const base::View& view, int layers) override {
        context_.make_current();
        peel::WalkStats stats;
        peeler_.give_back(std::move(stack_));
        stack_ = peeler_.peel(view, model_, layers, stats);
        context_.functions().Finish();
        return stats.fallback.empty();
    }
    std::vector<int> counts() override {
        const layers::HostStack host = read();
        return host.counts;
    }
    std::vector<double> distances() override {
        const layers::HostStack host = read();
        std::vector<double> result;
        for (const float depth : host.planes.front().depth) {
            result.push_back(distance(*view_, depth));
        }
        return result;
    }

  private:
    [[nodiscard]] layers::HostStack read() {
        context_.make_current();
        return layers::read_back(context_.functions(), stack_);
    }

    gl::Context& context_;
    peel::Peeler& peeler_;
    peel::PeelModel model_;
    layers::TextureStack stack_;
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

DrawerSet::DrawerSet(gl::Context& context, int largest) : context_(context), peeler_(context.functions()) {
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
    if (name == "lists-cpu") {
        return std::make_unique<CpuDrawer>(model);
    }
    static const std::map<std::string, EngineKind> kinds{
        {"lists", EngineKind::Lists}, {"goldfeather", EngineKind::Goldfeather}, {"scs", EngineKind::Scs}};
    if (const auto kind = kinds.find(name); kind != kinds.end()) {
        if (goldfeather::needs_products(kind->second) && too_much_for_passes(model)) {
            return nullptr;
        }
        context_.make_current();
        return std::make_unique<GlDrawer>(context_, peeler_, model, kind->second);
    }
    if (!opencsg_ || too_much_for_passes(model)) {
        return nullptr;
    }
    return std::make_unique<OpenCsgDrawer>(
        *opencsg_, model, name == "OpenCSG SCS" ? opencsg::Algorithm::Scs : opencsg::Algorithm::Goldfeather);
}

}  // namespace bench

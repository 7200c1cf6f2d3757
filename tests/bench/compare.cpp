#include "tests/bench/compare.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/bench/floor.h"
#include "tests/truth/ray_caster.h"

namespace bench {

namespace {

/// Models with more leaves, or literals over all products, take minutes with engines that need a pass a layer or a
/// literal.
constexpr std::size_t kMostLeavesOfPasses = 1500, kMostLiteralsOfPasses = 6000;

bool too_much_for_passes(const ui::Model& model) {
    return !model.over_budget.empty() || model.statistics.leaves > kMostLeavesOfPasses ||
           model.statistics.literals > kMostLiteralsOfPasses;
}

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// The true distance of the first surface in some of a picture's pixels.
class FirstSurfaces {
  public:
    FirstSurfaces(const ui::Model& model, const gl::View& view) : diagonal_(model.geometry.box.diagonal()) {
        const truth::RayCaster caster(model.scene, model.geometry, view);
        // A step that is prime to the width visits all columns.
        const int pixels = view.size().x * view.size().y;
        const int step = std::max(1, pixels / 1500) | 1;
        for (int i = step / 2; i < pixels; i += step) {
            const truth::Ray ray = caster.cast(i % view.size().x, i / view.size().x);
            if (ray.decided) {
                samples_.emplace_back(static_cast<std::size_t>(i), ray.surfaces.empty()
                                                                       ? std::numeric_limits<double>::infinity()
                                                                       : ray.surfaces[0].distance);
            }
        }
    }
    /// `distance(pixel)`: what an engine found. Off by more than a thousandth of the scene is wrong.
    [[nodiscard]] double wrong_percent(const std::function<double(std::size_t)>& distance) const {
        const auto wrong = std::count_if(samples_.begin(), samples_.end(), [&](const auto& sample) {
            const double found = distance(sample.first), expected = sample.second;
            return std::isfinite(found) != std::isfinite(expected) ||
                   (std::isfinite(found) && std::abs(found - expected) > 1e-3 * diagonal_);
        });
        return samples_.empty() ? 0 : 100 * static_cast<double>(wrong) / static_cast<double>(samples_.size());
    }

  private:
    double diagonal_;
    std::vector<std::pair<std::size_t, double>> samples_;
};

}  // namespace

Comparison::Comparison(gl::Context& context, int largest, int repeat)
    : context_(context), repeat_(repeat), peeler_(context.functions()) {
    auto made = opencsg::create(glm::ivec2(largest));
    opencsg_ = std::move(made.engine);
    missing_ = opencsg_ ? "" : "OpenCSG: " + made.reason;
}

std::vector<Compared> Comparison::run(const Subject& subject, int side) {
    context_.make_current();
    const gl::Functions& gl = context_.functions();
    const ui::Model& model = *subject.model;
    const gl::View view(subject.camera, glm::ivec2(side), model.geometry.box.lo, model.geometry.box.hi);
    const FirstSurfaces truth(model, view);
    const Compared head{subject.name,
                        subject.size,
                        side,
                        model.statistics.leaves,
                        model.statistics.products,
                        model.statistics.triangles,
                        {},
                        false,
                        {},
                        0,
                        0};
    std::vector<Compared> rows;
    const auto add = [&](const std::string& engine) -> Compared& {
        rows.push_back(head);
        rows.back().engine = engine;
        return rows.back();
    };
    {
        Compared& row = add("floor");
        Floor floor(gl, model.geometry, glm::ivec2(side));
        row.time = median(4 * repeat_, [&] { floor.draw(view); });
        row.drawn = true;
        row.peak = peak_megabytes();
    }
    const auto peel = [&](const std::string& name, goldfeather::EngineKind kind, int layers) {
        Compared& row = add(name);
        const bool walk = goldfeather::needs_products(kind);
        if (walk && too_much_for_passes(model)) {
            return;
        }
        peel::PeelModel peel_model(gl, model.scene, model.geometry, model.products, kind);
        peel::WalkStats stats;
        goldfeather::LayerStack stack;
        row.time = median(repeat_, [&] {
            peeler_.give_back(std::move(stack));
            stack = peeler_.peel(view, peel_model, layers, stats);
            gl.Finish();
        });
        if (!stats.fallback.empty()) {
            return;  // Another engine has drawn.
        }
        row.drawn = true;
        row.peak = peak_megabytes();
        const goldfeather::HostLayers host = goldfeather::read_back(gl, stack);
        row.wrong = truth.wrong_percent([&](std::size_t i) {
            const auto depth = static_cast<double>(host.surfaces[i].depth);
            return depth > 0 ? view.distance(depth) : std::numeric_limits<double>::infinity();
        });
    };
    peel("lists-cpu", goldfeather::EngineKind::ListsCpu, 1);
    peel("lists-cpu all", goldfeather::EngineKind::ListsCpu, peel::kAllLayers);
    peel("lists", goldfeather::EngineKind::Lists, 1);
    peel("lists all", goldfeather::EngineKind::Lists, peel::kAllLayers);
    peel("goldfeather", goldfeather::EngineKind::Goldfeather, 1);
    peel("scs", goldfeather::EngineKind::Scs, 1);
    if (!opencsg::built()) {
        return rows;
    }
    for (const auto& [name, algorithm] : {std::pair("OpenCSG Goldfeather", opencsg::Algorithm::Goldfeather),
                                          std::pair("OpenCSG SCS", opencsg::Algorithm::Scs)}) {
        Compared& row = add(name);
        if (!opencsg_ || too_much_for_passes(model)) {
            continue;
        }
        opencsg_->load(model.geometry, model.products, view, algorithm);
        row.time = median(repeat_, [&] { opencsg_->draw(); });
        row.drawn = true;
        row.peak = peak_megabytes();
        const opencsg::Picture picture = opencsg_->read();
        row.wrong = truth.wrong_percent([&](std::size_t i) { return picture.distance[i]; });
    }
    context_.make_current();
    return rows;
}

}  // namespace bench

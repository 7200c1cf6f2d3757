#include "tests/bench/compare.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bench/floor.h"
#include "tests/truth/ray_caster.h"

namespace bench {

namespace {

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// The true distance of the first surface in some of a picture's pixels.
class FirstSurfaces {
  public:
    FirstSurfaces(const ui::Model& model, const base::View& view) : diagonal_(model.geometry.box.diagonal()) {
        const truth::RayCaster caster(model.scene, model.geometry, view);
        // A step that is prime to the width visits all columns. A ray costs as many steps as there are leaves.
        const int pixels = view.size().x * view.size().y;
        const std::size_t rays =
            std::clamp<std::size_t>(3'000'000 / std::max<std::size_t>(1, model.statistics.leaves), 60, 1500);
        const int step = std::max(1, pixels / static_cast<int>(rays)) | 1;
        for (int i = step / 2; i < pixels; i += step) {
            const truth::Ray ray = caster.cast(i % view.size().x, i / view.size().x);
            if (ray.decided) {
                samples_.emplace_back(static_cast<std::size_t>(i), ray.surfaces.empty()
                                                                       ? std::numeric_limits<double>::infinity()
                                                                       : ray.surfaces[0].distance);
            }
        }
    }
    /// `distances`: what an engine found, by pixel. Off by more than a thousandth of the scene is wrong.
    [[nodiscard]] double wrong_percent(const std::vector<double>& distances) const {
        const auto wrong = std::count_if(samples_.begin(), samples_.end(), [&](const auto& sample) {
            const double found = distances[sample.first], expected = sample.second;
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
    : context_(context), repeat_(repeat), drawers_(context, largest) {}

std::vector<Compared> Comparison::run(const Subject& subject, int side) {
    context_.make_current();
    const ui::Model& model = *subject.model;
    const base::View view(subject.camera, glm::ivec2(side), model.geometry.box.lo, model.geometry.box.hi);
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
    const auto drawn = [&](Compared& row, const Time& time, Drawer& drawer) {
        row.drawn = true;
        row.time = time;
        row.peak = peak_megabytes();
        row.wrong = truth.wrong_percent(drawer.distances());
    };
    {
        // The floor and the quickest engine in turn: their ratios are what counts most.
        Floor floor(context_.functions(), model.geometry, glm::ivec2(side));
        const auto one = drawers_.make("lists-cpu", model), all = drawers_.make("lists-cpu", model);
        one->prepare(view);
        all->prepare(view);
        const std::vector<Time> times =
            interleaved(2 * repeat_, {[&] { floor.draw(view); }, [&] { (void)one->draw(view, 1); },
                                      [&] { (void)all->draw(view, goldfeather::kAllLayers); }});
        Compared& row = add("floor");
        row.drawn = true;
        row.time = times[0];
        drawn(add("lists-cpu"), times[1], *one);
        drawn(add("lists-cpu all"), times[2], *all);
    }
    for (const std::string& name : DrawerSet::names()) {
        if (name == "lists-cpu" || (name.starts_with("OpenCSG") && !opencsg::built())) {
            continue;
        }
        const auto drawer = drawers_.make(name, model);
        for (const int layers : {1, goldfeather::kAllLayers}) {
            if (layers != 1 && name != "lists") {
                continue;
            }
            Compared& row = add(layers == 1 ? name : name + " all");
            if (!drawer) {
                continue;
            }
            drawer->prepare(view);
            bool whole = true;
            const Time time = median(repeat_, [&] { whole = drawer->draw(view, layers) && whole; });
            if (whole) {
                drawn(row, time, *drawer);
            }
        }
    }
    context_.make_current();
    return rows;
}

}  // namespace bench

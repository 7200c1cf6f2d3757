// The knobs of pictures: resolution, samples, layers, tessellation.
#include <algorithm>
#include <limits>
#include <numeric>

#include "npr/accumulate.h"
#include "tests/bench/coverage.h"
#include "tests/bench/knobs.h"
#include "tests/stability/family.h"

namespace bench {

namespace {

base::View view_of(const Subject& subject, int side, glm::dvec2 jitter = glm::dvec2(0)) {
    return {subject.camera, glm::ivec2(side), subject.model->geometry.box.lo, subject.model->geometry.box.hi, jitter};
}

/// Draws and times; gives false where the engine leaves the picture to another.
bool measure(Drawer& drawer, const base::View& view, int layers, int repeat, double& cpu) {
    drawer.prepare(view);
    bool whole = true;
    cpu = median(repeat, [&] { whole = drawer.draw(view, layers) && whole; }).cpu;
    return whole;
}

std::vector<double> hits(Drawer& drawer) {
    const std::vector<int> counts = drawer.counts();
    std::vector<double> result(counts.size());
    std::transform(counts.begin(), counts.end(), result.begin(), [](int count) { return count > 0 ? 1.0 : 0.0; });
    return result;
}

/// A ball with three bores and a collar: every leaf is curved.
Subject curved(double sides) {
    stability::Maker m;
    using Id = stability::Maker::Id;
    const Id ball = m.sphere({0, 0, 0}, 4, sides);
    const Id collar = m.cylinder({0, 0, -1}, 2, 4.6, sides);
    const auto bore = [&] { return m.cylinder({0, 0, -6}, 12, 1.8, sides); };
    const Id body =
        m.subtract({m.unite({ball, collar}), bore(), m.turn(90, {1, 0, 0}, bore()), m.turn(90, {0, 1, 0}, bore())});
    auto shown = m.seen(body, {13, -17, 12}, {0, 0, 0});
    return from_tree("ball", sides, std::move(shown.tree), shown.camera);
}

}  // namespace

void turn_resolution(DrawerSet& drawers, const Subject& subject, const KnobOptions& options,
                     std::vector<KnobRow>& rows) {
    const ExactCoverage exact(*subject.model, subject.camera);
    for (const std::string& engine : DrawerSet::names()) {
        const auto drawer = drawers.make(engine, *subject.model);
        for (int side = options.side / 8; drawer && side <= 2 * options.side; side *= 2) {
            double cpu = 0;
            if (measure(*drawer, view_of(subject, side), 1, options.repeat, cpu)) {
                rows.push_back({"resolution", subject.name, engine, static_cast<double>(side), cpu,
                                exact.error_percent(side, hits(*drawer))});
            }
        }
    }
}

void turn_samples(DrawerSet& drawers, const Subject& subject, const KnobOptions& options, std::vector<KnobRow>& rows) {
    const int side = options.side / 2;
    const ExactCoverage exact(*subject.model, subject.camera);
    for (const std::string engine : {"lists-cpu", "lists", "goldfeather", "scs"}) {
        const auto drawer = drawers.make(engine, *subject.model);
        for (const int samples : npr::kSampleCounts) {
            if (!drawer) {
                continue;
            }
            std::vector<double> shown(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
            double sum = 0;
            bool whole = true;
            for (const glm::dvec2& offset : npr::sample_offsets(samples)) {
                double cpu = 0;
                whole = measure(*drawer, view_of(subject, side, offset), 1, options.repeat, cpu) && whole;
                sum += cpu;
                const std::vector<double> hit = hits(*drawer);
                std::transform(hit.begin(), hit.end(), shown.begin(), shown.begin(),
                               [&](double h, double s) { return s + h / samples; });
            }
            if (whole) {
                rows.push_back({"samples", subject.name, engine, static_cast<double>(samples), sum,
                                exact.error_percent(side, shown)});
            }
        }
    }
}

void turn_layers(DrawerSet& drawers, const Subject& subject, const KnobOptions& options, std::vector<KnobRow>& rows) {
    const base::View view = view_of(subject, options.side);
    for (const std::string engine : {"lists-cpu", "lists", "goldfeather"}) {
        const auto drawer = drawers.make(engine, *subject.model);
        if (!drawer) {
            continue;
        }
        double cpu = 0;
        if (!measure(*drawer, view, goldfeather::kAllLayers, options.repeat, cpu)) {
            continue;
        }
        const std::vector<int> all = drawer->counts();
        const auto most = *std::max_element(all.begin(), all.end());
        const auto whole = static_cast<double>(std::accumulate(all.begin(), all.end(), std::int64_t{0}));
        rows.push_back({"layers", subject.name, engine, std::numeric_limits<double>::infinity(), cpu, 0});
        for (const int layers : {1, 2, 3, 4, 6, 8}) {
            if (layers < most && measure(*drawer, view, layers, options.repeat, cpu)) {
                const std::vector<int> counts = drawer->counts();
                const auto found = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
                rows.push_back({"layers", subject.name, engine, static_cast<double>(layers), cpu,
                                100 * (whole - found) / std::max(whole, 1.0)});
            }
        }
    }
}

void turn_tessellation(DrawerSet& drawers, const KnobOptions& options, std::vector<KnobRow>& rows) {
    const Subject finest = curved(512);
    const ExactCoverage exact(*finest.model, finest.camera);
    for (const double sides : {8, 16, 32, 64, 128, 256}) {
        const Subject subject = curved(sides);
        // Drawn without edges of pixels: what differs is the shape.
        const ExactCoverage coverage(*subject.model, finest.camera);
        const double error = coverage.difference_percent(exact);
        for (const std::string& engine : DrawerSet::names()) {
            const auto drawer = drawers.make(engine, *subject.model);
            double cpu = 0;
            if (drawer && measure(*drawer, view_of(subject, options.side), 1, options.repeat, cpu)) {
                rows.push_back({"tessellation", subject.name, engine, sides, cpu, error});
            }
        }
    }
}

}  // namespace bench

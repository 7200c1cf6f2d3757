#include "tests/goldfeather/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace comparison {
namespace {

std::string text(const truth::Surface& s) {
    return fmt::format("[depth {:.8f} ±{:.2g} leaf {} reversed {} plane {} {}]", s.depth, s.depth_error,
                       fmt::join(s.leaves, "|"), fmt::join(s.reversed, "|"), fmt::join(s.planes, "|"),
                       s.leaving ? "leaving" : "entering");
}

std::string text(const layers::Surface& s) {
    return fmt::format("[depth {:.8f} leaf {}{} plane {} {}]", s.depth, s.leaf, s.reversed ? " reversed" : "", s.plane,
                       s.leaving ? "leaving" : "entering");
}

}  // namespace

bool same(const truth::Surface& expected, const layers::Surface& actual) {
    const auto holds = [](const std::vector<std::uint32_t>& ids, std::uint32_t id) {
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    return holds(expected.leaves, actual.leaf) && holds(expected.reversed, actual.leaf) == actual.reversed &&
           actual.leaving == expected.leaving &&
           std::abs(static_cast<double>(actual.depth) - expected.depth) <= expected.depth_error &&
           holds(expected.planes, actual.plane);
}

Subject::Subject(const csg::Tree& tree, bool with_products, const csg::PartRule& rule)
    : scene(csg::make_scene(tree, csg::Showing::Preview, rule)) {
    csg::solid::SolidCache cache;
    geometry = csg::solid::place(tree, scene, cache);
    std::vector<csg::Box> boxes;
    for (const auto& leaf : geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    if (!with_products) {
        return;
    }
    for (const csg::Part& part : scene.parts) {
        goldfeather::NormalizationStats stats;
        auto normalized = goldfeather::normalize(scene, part, boxes, {}, stats);
        auto* sum = std::get_if<goldfeather::SumOfProducts>(&normalized);
        products.push_back(sum ? std::move(sum->products) : std::vector<goldfeather::Product>{});
        const bool over = std::holds_alternative<goldfeather::OverBudget>(normalized);
        part_enabled.push_back(over ? 0 : 1);
        over_budget += over ? 1 : 0;
    }
}

layers::HostStack peel_all(const gl::Functions& gl, goldfeather::Engine& engine, const Subject& subject,
                           const base::View& view, int max_layers) {
    goldfeather::WalkStats ignored;
    return *layers::in_main_memory(gl, engine.prepare(subject.input())->draw(view, max_layers, ignored));
}

std::vector<layers::Surface> padded(const layers::HostStack& stack, int layers) {
    std::vector<layers::Surface> surfaces = stack.surfaces();
    surfaces.resize(static_cast<std::size_t>(layers) * static_cast<std::size_t>(stack.size.x) *
                    static_cast<std::size_t>(stack.size.y));
    return surfaces;
}

std::string difference(const Subject& subject, const base::View& view, const layers::HostStack& stack, Count& count,
                       int most) {
    const truth::RayCaster caster(subject.scene, subject.geometry, view, subject.part_enabled);
    std::string first;
    int wrong = 0;
    for (int y = 0; y < view.size().y; ++y) {
        for (int x = 0; x < view.size().x; ++x) {
            truth::Ray ray = caster.cast(x, y);
            count.pixels += ray.hit ? 1 : 0;
            count.undecided += ray.decided ? 0 : 1;
            if (!ray.decided) {
                continue;
            }
            if (most != goldfeather::kAllLayers && ray.surfaces.size() > static_cast<std::size_t>(most)) {
                ray.surfaces.resize(static_cast<std::size_t>(most));
            }
            std::vector<layers::Surface> actual;
            for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
                actual.push_back(stack.at(layer, x, y));
            }
            count.surfaces += actual.size();
            if (std::equal(ray.surfaces.begin(), ray.surfaces.end(), actual.begin(), actual.end(), same)) {
                continue;
            }
            if (wrong++ > 0) {
                continue;
            }
            first = fmt::format("pixel {}, {}, {:.5f} pixels from an edge:\n  expected", x, y,
                                caster.band().edge_distance(x, y));
            for (const truth::Surface& s : ray.surfaces) {
                first += "\n    " + text(s);
            }
            first += "\n  found";
            for (const layers::Surface& s : actual) {
                first += "\n    " + text(s);
            }
        }
    }
    return wrong == 0 ? "" : fmt::format("{} pixels differ; {}\n", wrong, first);
}

}  // namespace comparison

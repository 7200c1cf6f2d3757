#include "tests/goldfeather/edited_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace edited_scene {

using csg::ExpressionKind;

csg::OccurrenceId occurrence_at(const csg::Scene& scene, const Path& path) {
    csg::OccurrenceId at = 0;
    for (const std::uint32_t child : path) {
        csg::OccurrenceId next = 0;
        while (next < scene.occurrences.size() &&
               (scene.occurrences[next].parent != at || scene.occurrences[next].child != child)) {
            ++next;
        }
        if (next == scene.occurrences.size()) {
            return csg::kNoOccurrence;
        }
        at = next;
    }
    return at;
}

Subject::Subject(const random_tree::Model& model, csg::solid::SolidCache& cache, const csg::solid::Room& room)
    : tree(random_tree::make_tree(model)), scene(csg::make_scene(tree)) {
    geometry = csg::solid::place(tree, scene, cache, 1, {}, room);
    normalize();
}

void Subject::normalize() {
    std::vector<csg::Box> boxes;
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    products.resize(scene.parts.size());
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        goldfeather::NormalizationStats stats;
        auto sum = goldfeather::normalize(scene, scene.parts[i], boxes, {}, stats);
        const auto* found = std::get_if<goldfeather::SumOfProducts>(&sum);
        products[i] = found != nullptr ? found->products : std::vector<goldfeather::Product>{};
    }
}

std::vector<std::uint32_t> numbers_of_planes(const csg::solid::Geometry& geometry) {
    std::vector<std::uint32_t> numbers(geometry.planes.planes().size(), kUnused);
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        for (const csg::solid::PlaneRef& plane : leaf.planes) {
            numbers[plane.index] = 0;
        }
    }
    std::uint32_t next = 0;
    for (std::uint32_t& number : numbers) {
        if (number != kUnused) {
            number = next++;
        }
    }
    return numbers;
}

std::string difference(const csg::Scene& edited, const csg::Scene& made) {
    if (edited.leaves.size() != made.leaves.size() || edited.expressions.size() != made.expressions.size() ||
        edited.parts.size() != made.parts.size()) {
        return "sizes of scenes";
    }
    for (std::size_t i = 0; i < edited.leaves.size(); ++i) {
        if (edited.leaves[i].to_world != made.leaves[i].to_world || edited.leaves[i].part != made.leaves[i].part) {
            return fmt::format("leaf {} of the scene", i);
        }
    }
    for (std::size_t i = 0; i < edited.expressions.size(); ++i) {
        const csg::Expression &a = edited.expressions[i], &b = made.expressions[i];
        const auto of_a = edited.children(a), of_b = made.children(b);
        if (a.kind != b.kind || (a.kind == ExpressionKind::Leaf && a.leaf != b.leaf) ||
            !std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end())) {
            return fmt::format("expression {}", i);
        }
    }
    for (std::size_t i = 0; i < edited.parts.size(); ++i) {
        const csg::Part &a = edited.parts[i], &b = made.parts[i];
        if (a.first_expression != b.first_expression || a.root != b.root || a.first_leaf != b.first_leaf ||
            a.leaf_count != b.leaf_count) {
            return fmt::format("part {}", i);
        }
    }
    return {};
}

std::string difference(const csg::solid::Geometry& edited, const csg::solid::Geometry& made) {
    if (edited.box != made.box || edited.center != made.center ||
        edited.planes.tolerance() != made.planes.tolerance()) {
        return "bounds";
    }
    const std::vector<std::uint32_t> numbers = numbers_of_planes(edited);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] != kUnused && (numbers[i] >= made.planes.planes().size() ||
                                      edited.planes.planes()[i] != made.planes.planes()[numbers[i]])) {
            return fmt::format("plane {}", i);
        }
    }
    for (std::size_t i = 0; i < edited.leaves.size(); ++i) {
        const csg::solid::PlacedLeaf &a = edited.leaves[i], &b = made.leaves[i];
        if (a.points != b.points || a.triangles != b.triangles || a.box != b.box) {
            return fmt::format("mesh of leaf {}", i);
        }
        for (std::size_t t = 0; t < a.planes.size(); ++t) {
            if (numbers[a.planes[t].index] != b.planes[t].index || a.planes[t].flipped != b.planes[t].flipped) {
                return fmt::format("plane of triangle {} of leaf {}", t, i);
            }
        }
    }
    return {};
}

std::string difference(const csg::solid::Geometry& geometry, const layers::HostStack& edited,
                       const layers::HostStack& made) {
    if (edited.layers != made.layers) {
        return fmt::format("{} layers instead of {}", edited.layers, made.layers);
    }
    const std::vector<std::uint32_t> numbers = numbers_of_planes(geometry);
    for (int layer = 0; layer < edited.layers; ++layer) {
        for (int y = 0; y < edited.size.y; ++y) {
            for (int x = 0; x < edited.size.x; ++x) {
                layers::Surface a = edited.at(layer, x, y);
                a.plane = a.depth > 0 ? numbers[a.plane] : a.plane;
                if (a != made.at(layer, x, y)) {
                    return fmt::format("pixel {}, {} of layer {}", x, y, layer);
                }
            }
        }
    }
    return {};
}

}  // namespace edited_scene

#include "goldfeather/lists/list_self_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "csg/solid/part_order.h"
#include "goldfeather/lists_cpu/pixel_walk.h"

namespace goldfeather {
namespace {

constexpr std::uint32_t kLeaves = 24;
constexpr std::uint32_t kPixels = 96;
constexpr int kLayers = 48;

/// As in goldfeather/triangles.glsl.
struct TriangleRow {
    glm::vec4 plane_depth{0.0F};
    glm::vec2 depth_limits{0.0F};
    std::uint32_t plane = 0, leaf = 0;
};

/// A linear congruential generator: the same numbers everywhere.
class Numbers {
  public:
    std::uint32_t next() {
        state_ = state_ * 1664525U + 1013904223U;
        return state_ >> 8;
    }

  private:
    std::uint32_t state_ = 1;
};

/// Adds a node over expressions that have no parent yet.
std::uint32_t add(csg::Scene& scene, csg::ExpressionKind kind, const std::vector<std::uint32_t>& children) {
    const auto first = static_cast<std::uint32_t>(scene.expression_children.size());
    scene.expression_children.insert(scene.expression_children.end(), children.begin(), children.end());
    scene.expressions.push_back({kind, 0, first, static_cast<std::uint32_t>(children.size())});
    return static_cast<std::uint32_t>(scene.expressions.size() - 1);
}

/// A part of eight leaves: ((a ∪ b) − c) ∪ (d ∩ (e − (f ∩ (g ∪ h)))), or its like with other operations.
void add_part(csg::Scene& scene, csg::PartKind kind) {
    using enum csg::ExpressionKind;
    csg::Part part;
    part.kind = kind;
    part.first_expression = static_cast<std::uint32_t>(scene.expressions.size());
    part.first_leaf = static_cast<csg::LeafId>(scene.leaves.size());
    part.leaf_count = kLeaves / 3;
    std::vector<std::uint32_t> leaf;
    for (csg::LeafId i = 0; i < part.leaf_count; ++i) {
        csg::LeafInstance instance;
        instance.part = static_cast<csg::PartId>(scene.parts.size());
        scene.leaves.push_back(instance);
        scene.expressions.push_back({Leaf, part.first_leaf + i, 0, 0});
        leaf.push_back(part.first_expression + i);
    }
    const std::uint32_t left = add(scene, Difference, {add(scene, Union, {leaf[0], leaf[1]}), leaf[2]});
    const std::uint32_t cut = add(scene, Intersection, {leaf[5], add(scene, Union, {leaf[6], leaf[7]})});
    const std::uint32_t right = add(scene, Intersection, {leaf[3], add(scene, Difference, {leaf[4], cut})});
    part.root = add(scene, kind == csg::PartKind::Background ? Difference : Union, {left, right});
    scene.parts.push_back(part);
}

csg::Scene make_scene() {
    csg::Scene scene;
    for (const csg::PartKind kind : {csg::PartKind::Solid, csg::PartKind::Background, csg::PartKind::Highlight}) {
        add_part(scene, kind);
    }
    return scene;
}

/// KnownLists with known layers.
class KnownLists {
  public:
    explicit KnownLists(bool windings) : scene(make_scene()), windings_(windings) {
        Numbers random;
        const ExpressionTree tree(scene);
        for (csg::LeafId leaf = 0; leaf < kLeaves; ++leaf) {
            behind.push_back(leaf % 5 == 1 ? 1 : 0);
            wound.push_back(windings && leaf % 3 != 2 ? 1 : 0);
            flags.push_back((behind[leaf] != 0 ? BlistBuffer::kBehind : 0U) |
                            (wound[leaf] != 0 ? BlistBuffer::kWound : 0U));
            triangles.push_back({{}, {}, 7 * leaf % kLeaves, leaf});
        }
        const std::vector<std::uint32_t> ranks = csg::solid::ranks_of(csg::solid::part_order(scene, nullptr));
        PixelWalk walk(tree, scene, ranks, behind, wound, kLayers);
        for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
            add_pixel(pixel, walk, random);
        }
        jobs.resize(kListClasses * kPixels);
    }

    csg::Scene scene;
    std::vector<char> behind, wound;
    std::vector<std::uint32_t> flags;
    std::vector<TriangleRow> triangles;
    std::vector<PixelList> pixels;
    std::vector<glm::uvec2> entries;
    std::vector<glm::uvec2> jobs = std::vector<glm::uvec2>(kListClasses * kPixels);
    ListStatus status;
    std::vector<std::vector<layers::Surface>> expected;

  private:
    void add_pixel(std::uint32_t pixel, PixelWalk& walk, Numbers& random) {
        // Lengths of all classes, their limits among them.
        static constexpr std::array<std::uint32_t, 8> kLengths{1, 3, 7, 8, 9, 20, 32, 33};
        const std::uint32_t count = pixel % 12 < 8 ? kLengths[pixel % 12] : 34 + random.next() % 60;
        std::vector<Fragment> fragments;
        const auto first = static_cast<std::uint32_t>(entries.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t leaf = random.next() % kLeaves;
            const float depth = static_cast<float>(1 + random.next() % (count + count / 2)) / 256.0F;
            const std::uint32_t from_behind = windings_ ? random.next() % 2 : 0;
            entries.emplace_back(std::bit_cast<std::uint32_t>(depth), leaf | (from_behind != 0 ? kFromBehind : 0U));
            fragments.push_back({static_cast<double>(depth), leaf << 1 | from_behind, triangles[leaf].plane, 0});
        }
        const std::size_t list_class = count <= kShortLists[0] ? 0 : count <= kShortLists[1] ? 1 : 2;
        jobs[list_class * kPixels + status.class_sizes[list_class]++] = {pixel, first};
        pixels.push_back({count, first + count});
        entries.resize(first + list_room(count));

        std::stable_sort(fragments.begin(), fragments.end(),
                         [](const Fragment& a, const Fragment& b) { return a.depth > b.depth; });
        std::vector<layers::Surface>& layers = expected.emplace_back();
        for (const FoundSurface& s : walk.walk(fragments)) {
            std::uint32_t plane = ~0U;
            for (std::uint32_t i = s.first; i < s.end; ++i) {
                plane = std::min(plane, fragments[i].plane);
            }
            layers.push_back({static_cast<float>(fragments[s.first].depth), s.leaf, plane, s.reversed, s.leaving});
        }
    }

    bool windings_;
};

}  // namespace

std::string self_test(const gl::Functions& gl, ListResolver& resolver, bool windings) {
    const KnownLists lists(windings);
    ListBuffers buffers(gl);
    buffers.pixels.upload<PixelList>(lists.pixels);
    buffers.entries.upload<glm::uvec2>(lists.entries);
    buffers.jobs.upload<glm::uvec2>(lists.jobs);
    gl::Buffer triangles(gl);
    triangles.upload<TriangleRow>(lists.triangles);
    triangles.bind(GL_SHADER_STORAGE_BUFFER, 8);
    BlistBuffer blist(gl, Blist(lists.scene, csg::solid::part_order(lists.scene, nullptr)));
    blist.set_flags(lists.flags);
    for (const std::uint32_t pause_after : {0U, 1U}) {  // In as few goes as may be, and event by event.
        layers::TextureStack stack;
        stack.size = {static_cast<int>(kPixels), 1};
        grow(gl, stack, kLayers);
        buffers.status.upload_bytes(&lists.status, sizeof lists.status, GL_DYNAMIC_COPY);
        buffers.bind();
        (void)resolver.resolve(buffers, blist, {stack, 0, stack.size, kLayers, true, windings, pause_after},
                               lists.status.class_sizes, kPixels);
        const layers::HostStack found = read_back(gl, stack);
        for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
            std::vector<layers::Surface> expected = lists.expected[pixel];
            expected.resize(kLayers);
            for (int layer = 0; layer < kLayers; ++layer) {
                if (found.at(layer, static_cast<int>(pixel), 0) != expected[static_cast<std::size_t>(layer)]) {
                    return fmt::format("layer {} of a list of {} surfaces", layer + 1, lists.pixels[pixel].count);
                }
            }
        }
    }
    return {};
}

}  // namespace goldfeather

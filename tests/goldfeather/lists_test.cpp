// What only the engine `lists` has: its memory, its check of itself, and what happens where that fails.
#include "goldfeather/lists/lists.h"

#include <cmath>

#include "csg/solid/part_order.h"
#include "goldfeather/engine_set.h"
#include "goldfeather/lists/list_self_test.h"
#include "tests/goldfeather/engine_test.h"
#include "tests/random/build_model.h"

namespace {

using comparison::Subject;
using goldfeather::Lists;
using layers::HostStack;

constexpr glm::ivec2 kSize{48, 48};

/// As many slabs above each other, seen from above.
random_tree::Model slabs(int count) {
    std::vector<random_tree::Model> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(random_tree::box({0, 0, 2.0 * i}, {4, 4, 1}));
    }
    return random_tree::combine(csg::Operation::Union, all);
}

base::Camera from_above(double height) {
    base::Camera camera = base::camera_between({2.1, 1.9, 3 * height}, {2.1, 1.9, 0});
    camera.projection = base::Projection::Orthographic;
    camera.fov = 2 * glm::degrees(std::atan(3 / camera.distance));  // Six units high.
    return camera;
}

class ListsOnOpenGl : public test_support::GlTest {
  protected:
    layers::HostStack peel(Lists& lists, const Subject& subject, const base::View& view, int max_layers,
                           goldfeather::WalkStats& stats) {
        goldfeather::LeafBuffers leaves(gl(), subject.geometry);
        goldfeather::ListsScene scene(gl(), subject.scene, csg::solid::part_order(subject.scene, &subject.geometry));
        return layers::read_back(gl(), lists.peel(view, subject.geometry, leaves, scene, max_layers, stats));
    }
};

Subject random_subject(std::uint64_t seed, base::Camera& camera) {
    std::mt19937_64 random(seed);
    const random_tree::Options options{seed % 4 == 0 ? 60 : 14, 6, true};
    Subject subject(random_tree::make_tree(random_tree::make_model(random, options)), false);
    camera = random_tree::make_camera(random, subject.geometry.box.lo, subject.geometry.box.hi);
    return subject;
}

/// Splitting the picture, down to single pixels, is only a matter of memory.
TEST_P(ListsOnOpenGl, PiecesDoNotShow) {
    Lists whole(gl()), split(gl(), 20000), tiny(gl(), 1);
    int most_pieces = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        base::Camera camera;
        const Subject subject = random_subject(seed, camera);
        const base::View view = subject.view(camera, kSize), small = subject.view(camera, {7, 5});
        goldfeather::WalkStats stats, split_stats, tiny_stats, ignored;
        const layers::HostStack a = peel(whole, subject, view, 0, stats),
                                b = peel(split, subject, view, 0, split_stats);
        ASSERT_EQ(a.layers, b.layers) << "seed " << seed;
        ASSERT_EQ(a.surfaces(), b.surfaces()) << "seed " << seed;
        EXPECT_EQ(stats.fragments, split_stats.fragments);
        EXPECT_LE(stats.bands, 1);
        most_pieces = std::max(most_pieces, split_stats.bands);
        ASSERT_EQ(peel(whole, subject, small, 0, ignored).surfaces(),
                  peel(tiny, subject, small, 0, tiny_stats).surfaces());
    }
    EXPECT_GE(most_pieces, 16);
}

TEST_P(ListsOnOpenGl, KeepTheBudget) {
    constexpr std::size_t kBudget = 200000;
    Lists lists(gl(), kBudget);
    const Subject subject(random_tree::make_tree(slabs(60)), false);
    goldfeather::WalkStats stats;
    (void)peel(lists, subject, subject.view(from_above(120), {100, 100}), 0, stats);
    EXPECT_GT(stats.bands, 4);
    EXPECT_GT(stats.memory, kBudget / 4);
    EXPECT_LE(stats.memory, kBudget);
}

/// More surfaces than the short lists hold, and more layers than are allocated at first.
TEST_P(ListsOnOpenGl, AnyNumberOfSurfacesAndLayers) {
    Lists lists(gl());
    for (const int count : {1, 4, 5, 16, 17, 150}) {
        const Subject subject(random_tree::make_tree(slabs(count)), false);
        const base::View view = subject.view(from_above(2 * count), {33, 33});
        goldfeather::WalkStats stats;
        const layers::HostStack all = peel(lists, subject, view, 0, stats);
        EXPECT_EQ(all.layers, 2 * count);
        EXPECT_EQ(stats.longest_list, static_cast<std::uint32_t>(2 * count));
        EXPECT_EQ(stats.layers, 2 * count);
        comparison::Count compared;
        EXPECT_EQ(comparison::difference(subject, view, all, compared), "");
        for (const int few : {1, 3, 7}) {
            const layers::HostStack first = peel(lists, subject, view, few, stats);
            EXPECT_LE(first.layers, few);
            EXPECT_EQ(comparison::padded(first, 2 * count).size(), all.surfaces().size());
            EXPECT_EQ(comparison::padded(first, few), comparison::padded(all, few));
        }
    }
}

/// The same depths from the same triangles: the two engines agree to the last bit.
TEST_P(ListsOnOpenGl, AgreeWithGoldfeather) {
    Lists lists(gl());
    const auto walk = goldfeather::make_engine(*goldfeather::find_engine("goldfeather"), {&gl()});
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        base::Camera camera;
        const Subject without = random_subject(seed, camera);
        std::mt19937_64 random(seed);
        const random_tree::Options options{seed % 4 == 0 ? 60 : 14, 6, true};
        const Subject subject(random_tree::make_tree(random_tree::make_model(random, options)));
        if (subject.over_budget > 0) {
            continue;
        }
        const base::View view = subject.view(camera, kSize);
        goldfeather::WalkStats stats;
        const layers::HostStack a = peel(lists, subject, view, 0, stats);
        const layers::HostStack b = comparison::peel_all(gl(), *walk, subject, view);
        const int layers = std::max(a.layers, b.layers);
        const auto found = comparison::padded(a, layers), expected = comparison::padded(b, layers);
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i].depth, expected[i].depth) << "seed " << seed;
            ASSERT_EQ(found[i].leaving, expected[i].leaving) << "seed " << seed;
        }
    }
}

/// A driver that computes the shader wrong is found out, whatever it gets wrong.
TEST_P(ListsOnOpenGl, SelfTestSeesAWrongShader) {
    const gl::ShaderLibrary right = goldfeather::ListResolver::shaders();
    const auto found_wrong = [&](const gl::ShaderLibrary& library, bool windings) {
        goldfeather::ListResolver resolver(gl(), library);
        return goldfeather::self_test(gl(), resolver, windings);
    };
    EXPECT_EQ(found_wrong(right, false), "");
    EXPECT_EQ(found_wrong(right, true), "");
    struct Fault {
        std::string_view file, from, to;
        bool windings = false;  ///< Of what is done for winding numbers.
    };
    for (const Fault& fault :
         {Fault{"goldfeather/lists/list_short.glsl", "next = max(next, list_depths[i])", "next = list_depths[i]"},
          Fault{"goldfeather/lists/list_long.glsl", "if (other.x > below.x)", "if (other.x < below.x)"},

          Fault{"goldfeather/lists/blist.glsl", ".w & 1u) != 0u", ".w & 4u) != 0u"},
          Fault{"goldfeather/lists/list_long.glsl", "== back ? 1u : 0xffffffffu", "== back ? 1u : 1u", true},
          Fault{"goldfeather/lists/list_long.glsl", "].y + by : 0u", "].y : 0u", true},
          Fault{"goldfeather/lists/list_short.glsl", "passed - all", "passed", true},
          Fault{"goldfeather/lists/list_short.glsl", "? -1 : 1;", "? 1 : 1;", true},
          Fault{"goldfeather/lists/resolve_lists.glsl", "list_switches(smallest, odd, after)", "odd", true},
          Fault{"goldfeather/lists/list_short.glsl", "bit = 1u << other;", ";"},

          Fault{"goldfeather/lists/blist.glsl", "== (nearer == group.z)", "!= (nearer == group.z)"},
          Fault{"goldfeather/lists/resolve_lists.glsl", "odd = !odd;", ";"},
          Fault{"goldfeather/lists/resolve_lists.glsl", "    if (leaving)\n", "    if (!leaving)\n"},

          Fault{"goldfeather/lists/resolve_lists.glsl", "if (of_leaf >= from)", "if (of_leaf > from)"}}) {
        std::string text(right.find(fault.file).text);
        const std::size_t at = text.find(fault.from);
        ASSERT_NE(at, std::string::npos) << fault.from;
        for (std::size_t i = at; i != std::string::npos; i = text.find(fault.from, i + fault.to.size())) {
            text.replace(i, fault.from.size(), fault.to);
        }
        const gl::ShaderFile wrong{fault.file, text};
        gl::ShaderLibrary library;
        library.add({&wrong, 1});  // Before the right one.
        library.add(right.files());
        EXPECT_NE(found_wrong(library, fault.windings), "") << fault.from << " -> " << fault.to;
    }
}

class FallBack : public ListsOnOpenGl {
  protected:
    /// Draws with a table of functions that has a fault; gives the reason for drawing on the CPU.
    std::string reason(const gl::Functions& faulty) {
        const Subject subject(random_tree::make_tree(slabs(3)), false);
        const base::View view = subject.view(from_above(6), {33, 33});
        goldfeather::EngineSet engines({&faulty});
        const auto scene = engines.prepare(subject.input(), *goldfeather::find_engine("lists"));
        std::string reason;
        for (int picture = 0; picture < 2; ++picture) {  // The second does not try again.
            goldfeather::WalkStats stats;
            const auto layers = layers::in_main_memory(faulty, scene->draw(view, 0, stats));
            EXPECT_EQ(layers->layers, 6);
            comparison::Count count;
            EXPECT_EQ(comparison::difference(subject, view, *layers, count), "");
            reason = stats.fallback;
        }
        return reason;
    }
};

TEST_P(FallBack, WhereShadersComputeWrong) {
    gl::Functions faulty = gl();
    faulty.DispatchCompute = [](GLuint, GLuint, GLuint) {};
    EXPECT_NE(reason(faulty).find("computes wrong on this OpenGL"), std::string::npos);
    EXPECT_EQ(reason(gl()), "");
}

/// What lies behind the end of a storage block would be lost without a word.
TEST_P(FallBack, WhereTheTrianglesHaveNoRoom) {
    static PFNGLGETINTEGERVPROC get = nullptr;
    get = gl().GetIntegerv;
    gl::Functions faulty = gl();
    faulty.GetIntegerv = [](GLenum name, GLint* value) {
        get(name, value);
        if (name == GL_MAX_SHADER_STORAGE_BLOCK_SIZE) {
            *value = 35 * 3 * 16;  // Three slabs have 36 triangles.
        }
    };
    EXPECT_EQ(reason(faulty), "its leaves have 36 triangles, and this OpenGL takes 35");
}

/// A list that is not filled to its end is not taken for a shorter one.
TEST_P(FallBack, WhereTwoPassesDisagree) {
    static PFNGLMULTIDRAWARRAYSINDIRECTPROC draw = nullptr;
    static int passes = 0;
    draw = gl().MultiDrawArraysIndirect;
    passes = 0;
    gl::Functions faulty = gl();
    faulty.MultiDrawArraysIndirect = [](GLenum mode, const void* at, GLsizei count, GLsizei stride) {
        draw(mode, at, ++passes % 2 == 0 ? count - 1 : count, stride);
    };
    // Without its middle slab the scene is drawn in two pieces, of which the second pass forgets one.
    const Subject subject(
        random_tree::make_tree(random_tree::combine(
            csg::Operation::Union, {random_tree::box({0, 0, 0}, {4, 4, 1}), random_tree::box({1000, 0, 2}, {4, 4, 1}),
                                    random_tree::box({0, 0, 4}, {4, 4, 1})})),
        false);
    const base::View view = subject.view(from_above(6), {33, 33});
    goldfeather::EngineSet engines({&faulty});
    const auto scene = engines.prepare(subject.input(), *goldfeather::find_engine("lists"));
    goldfeather::WalkStats stats;
    const auto layers = layers::in_main_memory(faulty, scene->draw(view, 0, stats));
    EXPECT_NE(stats.fallback.find("different per-pixel lists"), std::string::npos) << stats.fallback;
    EXPECT_EQ(layers->layers, 4);
    // That was one picture's fault: the next is tried again.
    faulty.MultiDrawArraysIndirect = draw;
    goldfeather::WalkStats after;
    (void)scene->draw(view, 0, after);
    EXPECT_EQ(after.fallback, "");
}

INSTANTIATE_TEST_SUITE_P(Contexts, ListsOnOpenGl, testing::Values(gl::ContextKind::Egl), test_support::context_name);
INSTANTIATE_TEST_SUITE_P(Contexts, FallBack, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace

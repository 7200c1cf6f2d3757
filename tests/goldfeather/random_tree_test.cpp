// Random models against the ray caster.
#include <fmt/format.h>

#include <cstdlib>

#include "goldfeather/goldfeather/goldfeather.h"
#include "goldfeather/parts_scene.h"
#include "tests/goldfeather/engine_test.h"
#include "tests/random/build_model.h"

namespace {

using comparison::Subject;

constexpr glm::ivec2 kSize{48, 48};

struct Sample {
    random_tree::Model model;
    base::Camera camera;
};

Sample make_sample(std::uint64_t seed, bool wound = false) {
    std::mt19937_64 random(seed);
    random_tree::Options options;
    if (seed % 16 == 0) {
        options = {60, 8, true};  // more leaves than parity bits in a word
    }
    options.wound = wound;
    Sample sample{random_tree::make_model(random, options), {}};
    // Some are tiny, huge, or far from the origin.
    glm::dmat4 placed(1.0);
    if (seed % 16 == 1) {
        placed = glm::dmat4(glm::dmat3(1e6));
    } else if (seed % 16 == 2) {
        placed = glm::dmat4(glm::dmat3(1e-4));
    } else if (seed % 16 == 3) {
        placed[3] = {1000, -2000, 300, 1};
    }
    if (seed % 16 >= 1 && seed % 16 <= 3) {
        sample.model = random_tree::matrix(placed, std::move(sample.model));
    }
    const Subject subject(random_tree::make_tree(sample.model), false);
    sample.camera = random_tree::make_camera(random, subject.geometry.box.lo, subject.geometry.box.hi);
    return sample;
}

int environment(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

/// What is wrong with the picture of a sample; empty if nothing is.
class Check {
  public:
    explicit Check(comparison::Engine& engine) : engine_(engine) {}

    std::string run(const Sample& sample, comparison::Count& count, std::size_t& over_budget) {
        const Subject subject(random_tree::make_tree(sample.model), engine_.capabilities().needs_products);
        over_budget += subject.over_budget;
        const base::View view = subject.view(sample.camera, kSize);
        return comparison::difference(subject, view, engine_.peel(subject, view), count);
    }

    /// The smallest model found for which something is still wrong.
    Sample shrink(Sample sample) {
        for (bool smaller = true; smaller;) {
            smaller = false;
            for (random_tree::Model& model : random_tree::simpler(sample.model)) {
                const Sample candidate{std::move(model), sample.camera};
                comparison::Count count;
                std::size_t over_budget = 0;
                if (!run(candidate, count, over_budget).empty()) {
                    sample = candidate;
                    smaller = true;
                    break;
                }
            }
        }
        return sample;
    }

  private:
    comparison::Engine& engine_;
};

class RandomTrees : public comparison::EngineTest {};

/// So many random models, from CSGSCOPE_TEST_SEED on.
void compare_with_truth(comparison::Engine& engine, int otherwise, bool wound) {
    Check check(engine);
    comparison::Count count;
    std::size_t over_budget = 0;
    const int first = environment("CSGSCOPE_TEST_SEED", 1);
    const int trees = environment("CSGSCOPE_TEST_TREES", otherwise);
    int failures = 0, not_drawn = 0;
    for (int i = 0; i < trees && failures < 5; ++i) {
        const auto seed = static_cast<std::uint64_t>(first + i);
        const Sample sample = make_sample(seed, wound);
        try {
            if (check.run(sample, count, over_budget).empty()) {
                continue;
            }
        } catch (const goldfeather::EngineObstacle&) {
            ++not_drawn;  // Where many parts meet, loops end early on OpenGL in software; the program takes another
                          // engine.
            continue;
        }
        ++failures;
        const Sample small = check.shrink(sample);
        comparison::Count again;
        ADD_FAILURE() << "seed " << seed << ": " << check.run(small, again, over_budget)
                      << random_tree::camera_text(small.camera) << random_tree::scad_text(small.model);
    }
    const double band =
        static_cast<double>(count.undecided) / static_cast<double>(std::max<std::size_t>(1, count.pixels));
    std::cout << fmt::format(
        "{} trees, {} pixels with something along the ray, {} of them in the band ({:.2f} %), {} "
        "surfaces compared, {} parts over budget\n",
        trees, count.pixels, count.undecided, 100 * band, count.surfaces, over_budget);
    EXPECT_LT(band, 0.05);
    EXPECT_LE(not_drawn, 1 + trees / 500);
}

TEST_P(RandomTrees, AgreeWithTheRayCaster) {
    compare_with_truth(engine(), 1000, false);
}

class WoundTrees : public comparison::EngineTest {};

/// Leaves of shells that overlap, are reversed, doubled, or cross themselves: inside is a winding number.
TEST_P(WoundTrees, AgreeWithTheRayCaster) {
    compare_with_truth(engine(), 500, true);
}

/// The first k layers are the first k of all.
TEST_P(RandomTrees, FewLayersAreTheFirstOfAll) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        const Sample sample = make_sample(seed);
        const Subject subject = this->subject(sample.model);
        const base::View view = subject.view(sample.camera, kSize);
        const auto all = engine().peel(subject, view);
        for (const int k : {1, 2}) {
            const auto few = engine().peel(subject, view, k);
            ASSERT_LE(few.layers, k);
            ASSERT_TRUE(few.surfaces() == comparison::padded(all, few.layers))
                << "seed " << seed << ", " << k << " layers\n"
                << random_tree::scad_text(sample.model);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, RandomTrees, testing::ValuesIn(comparison::engine_names({gl::ContextKind::Egl})),
                         comparison::engine_name);
INSTANTIATE_TEST_SUITE_P(Engines, WoundTrees, testing::ValuesIn(comparison::engine_names({gl::ContextKind::Egl})),
                         comparison::engine_name);

class Bands : public test_support::GlTest {};

/// Walking the picture in bands is only a matter of memory.
TEST_P(Bands, DoNotShow) {
    goldfeather::Goldfeather whole(gl()), split(gl(), 48 * 24 * 5);
    int most_bands = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Sample sample = make_sample(seed);
        const Subject subject(random_tree::make_tree(sample.model));
        if (subject.products.empty()) {
            continue;
        }
        goldfeather::PartsScene scene(gl(), subject.input());
        const base::View view = subject.view(sample.camera, kSize);
        const goldfeather::PartProducts part = scene.part(subject.products[0]);
        goldfeather::WalkStats stats, split_stats;
        const auto a = layers::read_back(gl(), whole.walk(view, scene.leaves(), part, 0, stats));
        const auto b = layers::read_back(gl(), split.walk(view, scene.leaves(), part, 0, split_stats));
        ASSERT_EQ(a.layers, b.layers) << "seed " << seed;
        ASSERT_EQ(a.surfaces(), b.surfaces()) << "seed " << seed;
        most_bands = std::max(most_bands, split_stats.bands);
    }
    EXPECT_GE(most_bands, 8);
}

INSTANTIATE_TEST_SUITE_P(Contexts, Bands, testing::Values(gl::ContextKind::Egl), test_support::context_name);

/// Both software renderers give the same stacks to the last bit.
TEST(RandomTreesOnTwoContexts, AreTheSame) {
    std::vector<std::vector<layers::Surface>> stacks[2];
    const char* const names[2]{"goldfeather_egl", "goldfeather_osmesa"};
    for (int i = 0; i < 2; ++i) {
        const auto made = comparison::make_engine(names[i]);
        if (!made.engine) {
            test_support::skip_or_fail("no OpenGL: " + made.reason);
            return;
        }
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const Sample sample = make_sample(seed);
            const Subject subject(random_tree::make_tree(sample.model));
            stacks[i].push_back(made.engine->peel(subject, subject.view(sample.camera, kSize)).surfaces());
        }
    }
    for (std::size_t i = 0; i < stacks[0].size(); ++i) {
        ASSERT_EQ(stacks[0][i], stacks[1][i]) << "seed " << i + 1;
    }
}

}  // namespace

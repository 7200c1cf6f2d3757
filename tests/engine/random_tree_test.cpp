// Random models against the ray caster.
#include <fmt/format.h>

#include <cstdlib>

#include "tests/engine/comparison.h"
#include "tests/support/gl_test.h"

namespace {

using comparison::Subject;

constexpr glm::ivec2 kSize{48, 48};

struct Sample {
    random_tree::Model model;
    gl::Camera camera;
};

Sample make_sample(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    random_tree::Options options;
    if (seed % 16 == 0)
        options = {60, 8, true};  // more leaves than parity bits in a word
    Sample sample{random_tree::make_model(random, options), {}};
    // Some are tiny, huge, or far from the origin.
    glm::dmat4 placed(1.0);
    if (seed % 16 == 1)
        placed = glm::dmat4(glm::dmat3(1e6));
    else if (seed % 16 == 2)
        placed = glm::dmat4(glm::dmat3(1e-4));
    else if (seed % 16 == 3)
        placed[3] = {1000, -2000, 300, 1};
    if (seed % 16 >= 1 && seed % 16 <= 3)
        sample.model = {csg::Operation::Transform, {}, {}, placed, {}, {sample.model}};
    const Subject subject(random_tree::make_tree(sample.model));
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
    explicit Check(const gl::Functions& gl) : gl_(gl), peeler_(gl) {}

    std::string run(const Sample& sample, comparison::Count& count, std::size_t& over_budget) {
        const Subject subject(random_tree::make_tree(sample.model));
        over_budget += subject.over_budget;
        const gl::View view = subject.view(sample.camera, kSize);
        return comparison::difference(subject, view, comparison::peel_all(gl_, peeler_, subject, view), count);
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
    const gl::Functions& gl_;
    peel::Peeler peeler_;
};

class RandomTrees : public test_support::GlTest {};

TEST_P(RandomTrees, AgreeWithTheRayCaster) {
    Check check(gl());
    comparison::Count count;
    std::size_t over_budget = 0;
    const int first = environment("CSGSCOPE_TEST_SEED", 1);
    const int trees = environment("CSGSCOPE_TEST_TREES", 1000);
    int failures = 0;
    for (int i = 0; i < trees && failures < 5; ++i) {
        const auto seed = static_cast<std::uint64_t>(first + i);
        const Sample sample = make_sample(seed);
        if (check.run(sample, count, over_budget).empty())
            continue;
        ++failures;
        const Sample small = check.shrink(sample);
        comparison::Count again;
        ADD_FAILURE() << "seed " << seed << ": " << check.run(small, again, over_budget)
                      << random_tree::camera_text(small.camera) << random_tree::scad_text(small.model);
    }
    const double band = static_cast<double>(count.undecided) / static_cast<double>(std::max<std::size_t>(1, count.pixels));
    std::cout << fmt::format("{} trees, {} pixels with something along the ray, {} of them in the band ({:.2f} %), {} "
                             "surfaces compared, {} parts over budget\n",
                             trees, count.pixels, count.undecided, 100 * band, count.surfaces, over_budget);
    EXPECT_LT(band, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Contexts, RandomTrees, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace

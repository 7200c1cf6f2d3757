// Triangles blended back to front: sorting by insertion, OpenGL's blending, and what the picture shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "npr/painter/cpu_accumulate.h"
#include "npr/sorted/sorted_painter.h"
#include "npr/sorted/sorted_settings.h"
#include "npr/style.h"

namespace {

using npr::BlendEquation;
using npr::BlendFactor;

TEST(IndexSort, BeginsWithTheLastOrder) {
    std::mt19937 random(11);
    std::vector<double> keys(500);
    for (double& key : keys) {
        key = static_cast<double>(random() % 300);
    }
    npr::IndexSort sort;
    const auto sorted = [&] {
        const auto& order = sort.order();
        for (std::size_t i = 1; i < order.size(); ++i) {
            const double a = keys[order[i - 1]], b = keys[order[i]];
            if (a < b || (a == b && order[i - 1] > order[i])) {
                return false;
            }
        }
        return order.size() == keys.size();
    };
    npr::SortCount count = sort.sort(keys);
    EXPECT_TRUE(sorted());
    EXPECT_EQ(count.swaps, count.from_nothing) << "the first time";
    count = sort.sort(keys);
    EXPECT_EQ(count.swaps, 0U);
    std::swap(keys[sort.order()[100]], keys[sort.order()[101]]);
    keys[sort.order()[300]] += 1e-9;
    count = sort.sort(keys);
    EXPECT_TRUE(sorted());
    EXPECT_LT(count.swaps, 20U);
    EXPECT_GT(count.from_nothing, 10'000U);
    std::reverse(keys.begin(), keys.end());
    EXPECT_GT(sort.sort(keys).swaps, 64 * keys.size()) << "so many that it is sorted anew";
    EXPECT_TRUE(sorted());
}

TEST(IndexSort, CountsEveryPairThatStandsTheWrongWayRound) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> keys(1 + random() % 60);
        std::vector<std::uint32_t> order(keys.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            keys[i] = static_cast<double>(random() % 40);
            order[i] = i;
        }
        std::shuffle(order.begin(), order.end(), random);
        std::uint64_t expected = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const double a = keys[order[i]], b = keys[order[j]];
                expected += b > a || (a == b && order[j] < order[i]) ? 1 : 0;
            }
        }
        EXPECT_EQ(npr::inversions(order, keys), expected);
    }
}

TEST(Blending, IsOpenGls) {
    const glm::vec4 src(0.2F, 0.4F, 0.6F, 0.8F), dst(0.7F, 0.5F, 0.3F, 0.25F), constant(0.1F, 0.9F, 0.5F, 0.4F);
    // Each factor on the source, with nothing of the destination; red and alpha.
    const std::vector<std::pair<float, float>> expected{{0, 0},         {1, 1},         {0.2F, 0.8F}, {0.8F, 0.2F},
                                                        {0.7F, 0.25F},  {0.3F, 0.75F},  {0.8F, 0.8F}, {0.2F, 0.2F},
                                                        {0.25F, 0.25F}, {0.75F, 0.75F}, {0.1F, 0.4F}, {0.9F, 0.6F},
                                                        {0.4F, 0.4F},   {0.6F, 0.6F},   {0.75F, 1.0F}};
    ASSERT_EQ(expected.size(), npr::blend_factor_names().size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto factor = static_cast<BlendFactor>(i);
        npr::Blending b{factor,  BlendFactor::Zero, BlendEquation::Add, factor, BlendFactor::Zero, BlendEquation::Add,
                        constant};
        const glm::vec4 color = npr::blend(b, src, dst);
        EXPECT_NEAR(color.r, 0.2F * expected[i].first, 1e-6) << npr::blend_factor_names()[i];
        EXPECT_NEAR(color.a, 0.8F * expected[i].second, 1e-6) << npr::blend_factor_names()[i];
    }
    const auto red = [&](BlendEquation equation) {
        npr::Blending b;
        b.src = b.dst = BlendFactor::One;
        b.equation = equation;
        return npr::blend(b, src, dst).r;
    };
    EXPECT_FLOAT_EQ(red(BlendEquation::Add), 0.9F);
    EXPECT_FLOAT_EQ(red(BlendEquation::Subtract), 0) << "source minus destination, clamped";
    EXPECT_FLOAT_EQ(red(BlendEquation::ReverseSubtract), 0.5F);
    EXPECT_FLOAT_EQ(red(BlendEquation::Min), 0.2F);
    EXPECT_FLOAT_EQ(red(BlendEquation::Max), 0.7F);
    npr::Blending straight, premultiplied;
    premultiplied.src = BlendFactor::One;
    premultiplied.premultiplied = true;
    EXPECT_EQ(npr::blend(straight, src, dst), npr::blend(premultiplied, src, dst));
}

/// Two panes of two triangles each, one above the other, seen from above.
npr::ColoredMesh panes(double lower, double upper) {
    npr::ColoredMesh mesh;
    for (const double z : {upper, lower}) {
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (const auto& p : {glm::dvec2(-9, -9), glm::dvec2(9, -9), glm::dvec2(9, 9), glm::dvec2(-9, 9)}) {
            mesh.points.emplace_back(p, z);
        }
        for (const auto& t : {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)}) {
            mesh.triangles.push_back(t + first);
            mesh.colors.emplace_back(z == upper ? glm::vec4(1, 0, 0, 0.5F) : glm::vec4(0, 0, 1, 0.5F));
            mesh.parts.push_back(first / 4);
        }
    }
    return mesh;
}

glm::vec3 seen(npr::ColoredMesh mesh, const std::map<std::string, std::string>& settings) {
    npr::Picture p = npr::default_picture();
    p.scheme.background = p.scheme.background_stop = glm::vec3(0);
    p.camera.rotation = {0, 0, 0};
    p.camera.projection = base::Projection::Orthographic;
    p.size = {9, 9};
    p.samples = 1;
    p.see_through_as(*npr::find_transparency("sorted"));
    for (const auto& [name, value] : settings) {
        p.transparency_parameters.read(name, value);
    }
    npr::SortedPainter painter(std::move(mesh));
    npr::CpuAccumulator accumulator;
    layers::HostStack none;
    accumulator.paint_sample(
        [&](const npr::CpuFrame& frame) { painter.paint(frame, true); }, p, 0,
        {glm::dvec3(-9), glm::dvec3(9), [&](const base::View&) -> const layers::HostStack& { return none; }});
    const base::Image image = accumulator.image();
    const std::uint8_t* const c = image.pixel(4, 4);
    return glm::vec3(c[0], c[1], c[2]) / 255.0F;
}

TEST(Sorted, DrawsBackToFront) {
    const float light = 0.2F + 1 / std::sqrt(3.0F);
    const glm::vec3 expected(0.5F * light, 0, 0.25F * light);
    const auto near = [](const glm::vec3& a, const glm::vec3& b) { return glm::length(a - b) < 0.005F; };
    for (const char* order : {"triangles", "objects", "parts"}) {
        EXPECT_TRUE(near(seen(panes(-2, 2), {{"order", order}}), expected)) << order;
        EXPECT_TRUE(near(seen(panes(-2, 2), {{"order", order}, {"depth", "on"}}), expected)) << order;
    }
    // As they come the upper one is first: blended over by the lower one, or hiding it.
    EXPECT_TRUE(near(seen(panes(-2, 2), {{"order", "none"}}), glm::vec3(expected.z, 0, expected.x)));
    EXPECT_TRUE(near(seen(panes(-2, 2), {{"order", "none"}, {"depth", "on"}}), glm::vec3(expected.x, 0, 0)));
    EXPECT_TRUE(near(seen(panes(-2, 2), {{"dst", "one"}}), glm::vec3(expected.x, 0, 0.5F * light))) << "light adds up";
}

/// Each pixel belongs to one of two triangles at an edge.
TEST(Sorted, EdgesAreBlendedOnce) {
    npr::ColoredMesh mesh = panes(-2, 2);
    mesh.triangles.resize(2), mesh.colors.resize(2), mesh.parts.resize(2);
    const float light = 0.2F + 1 / std::sqrt(3.0F);
    EXPECT_NEAR(seen(mesh, {}).r, 0.5F * light, 0.005F) << "in the middle, on the diagonal";
}

}  // namespace

#include "goldfeather/products.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <chrono>

#include "csg/solid/placed.h"
#include "tests/random/build_model.h"
#include "tests/random/rapidcheck_models.h"

namespace {

using csg::ExpressionKind;
using csg::Operation;
using goldfeather::Product;
using random_tree::box;
using random_tree::combine;
using random_tree::Model;

struct Subject {
    explicit Subject(const csg::Tree& tree) : scene(csg::make_scene(tree)) {
        csg::solid::SolidCache cache;
        for (const auto& leaf : csg::solid::place(tree, scene, cache).leaves) {
            boxes.push_back(leaf.box);
        }
    }
    explicit Subject(const Model& model) : Subject(random_tree::make_tree(model)) {}

    goldfeather::Normalized normalize(const csg::Part& part, const goldfeather::Budget& budget = {}) {
        return goldfeather::normalize(scene, part, boxes, budget, stats);
    }

    csg::Scene scene;
    std::vector<csg::Box> boxes;
    goldfeather::NormalizationStats stats;
};

bool value(const std::vector<Product>& products, const std::vector<char>& inside) {
    return std::any_of(products.begin(), products.end(), [&](const Product& p) {
        return std::all_of(p.literals.begin(), p.literals.end(),
                           [&](const goldfeather::Literal& l) { return (inside[l.leaf] != 0) != l.complement; });
    });
}

std::vector<Product> products_of(goldfeather::Normalized normalized) {
    if (auto* sum = std::get_if<goldfeather::SumOfProducts>(&normalized)) {
        return std::move(sum->products);
    }
    EXPECT_TRUE(std::holds_alternative<goldfeather::Empty>(normalized)) << "over budget";
    return {};
}

std::string text(const std::vector<Product>& products) {
    std::string result;
    for (const Product& p : products) {
        result += result.empty() ? "" : " + ";
        for (const auto& l : p.literals) {
            result += fmt::format("{}{}", l.complement ? "-" : "", static_cast<char>('a' + l.leaf));
        }
    }
    return result;
}

std::string products_text(const Model& model) {
    Subject subject(model);
    return text(products_of(subject.normalize(subject.scene.parts.at(0))));
}

/// Every set of leaves that can hold one point: those whose boxes hold it may, the others may not.
bool same_everywhere(const Model& model) {
    Subject subject(model);
    std::mt19937_64 random(5);
    std::vector<char> values;
    for (const csg::Part& part : subject.scene.parts) {
        const std::vector<Product> products = products_of(subject.normalize(part));
        for (int round = 0; round < 300; ++round) {
            // Points off the grid, so that none lies on a face.
            glm::dvec3 p;
            for (int axis = 0; axis < 3; ++axis) {
                p[axis] = static_cast<double>(random() % 1201) / 100 - 6.0037;
            }
            std::vector<char> inside(subject.boxes.size(), 0);
            for (std::size_t i = 0; i < inside.size(); ++i) {
                const csg::Box& b = subject.boxes[i];
                const bool can = !b.empty() && glm::all(glm::lessThan(b.lo, p)) && glm::all(glm::lessThan(p, b.hi));
                inside[i] = can && random() % 4 != 0;
            }
            const bool expected = csg::evaluate(
                subject.scene, part, [&](csg::LeafId leaf) { return inside[leaf] != 0; }, values);
            if (value(products, inside) != expected) {
                return false;
            }
            for (const Product& product : products) {
                if (value({product}, inside) &&
                    !(glm::all(glm::lessThan(product.box.lo, p)) && glm::all(glm::lessThan(p, product.box.hi)))) {
                    return false;
                }
            }
        }
    }
    return true;
}

TEST(Products, MeanTheExpression) {
    EXPECT_TRUE(rc::check("the sum of products has the value of the expression at every point",
                          [] { RC_ASSERT(same_everywhere(*random_tree::arbitrary_model())); }));
}

/// Without boxes to prune by, the products are equal to the expression for every set of leaves.
TEST(Products, TruthTable) {
    std::mt19937_64 random(3);
    std::size_t sums = 0;
    for (int round = 0; round < 400; ++round) {
        Subject subject(random_tree::make_model(random, {8, 5, false}));
        const csg::Box everywhere{glm::dvec3(-10), glm::dvec3(10)};
        subject.boxes.assign(subject.boxes.size(), everywhere);
        std::vector<char> values, inside(subject.boxes.size());
        for (const csg::Part& part : subject.scene.parts) {
            const std::vector<Product> products = products_of(subject.normalize(part));
            sums += products.empty() ? 0 : 1;
            ASSERT_TRUE(std::is_sorted(products.begin(), products.end(),
                                       [](const auto& a, const auto& b) { return a.literals < b.literals; }));
            for (std::size_t set = 0; set < std::size_t{1} << inside.size(); ++set) {
                for (std::size_t i = 0; i < inside.size(); ++i) {
                    inside[i] = static_cast<char>(set >> i & 1);
                }
                const bool expected = csg::evaluate(
                    subject.scene, part, [&](csg::LeafId leaf) { return inside[leaf] != 0; }, values);
                ASSERT_EQ(value(products, inside), expected) << "round " << round << ", set " << set;
            }
        }
    }
    EXPECT_GT(sums, 200U);
}

TEST(Products, GoldenText) {
    const Model a = box({0, 0, 0}, {4, 4, 4}), b = box({1, 1, 1}, {4, 4, 4}), c = box({2, 2, 2}, {4, 4, 4});
    const Model far = box({100, 0, 0}, {1, 1, 1});
    using enum Operation;
    EXPECT_EQ(products_text(combine(Union, {a, b, c})), "a + b + c");
    EXPECT_EQ(products_text(combine(Intersection, {a, b, c})), "abc");
    EXPECT_EQ(products_text(combine(Difference, {a, b, c})), "a-b-c");
    EXPECT_EQ(products_text(combine(Difference, {combine(Union, {a, b}), c})), "a-c + b-c");
    EXPECT_EQ(products_text(combine(Difference, {a, combine(Difference, {b, c})})), "a-b + ac");
    EXPECT_EQ(products_text(combine(Difference, {a, combine(Intersection, {b, c})})), "a-b + a-c");
    EXPECT_EQ(products_text(combine(Intersection, {combine(Union, {a, b}), combine(Union, {c, c})})),
              "ac + ad + bc + bd");
    // What cannot touch is left out.
    EXPECT_EQ(products_text(combine(Difference, {a, far})), "a");
    EXPECT_EQ(products_text(combine(Intersection, {combine(Union, {a, far}), b})), "ac");
    EXPECT_EQ(products_text(combine(Difference, {combine(Union, {a, far}), b})), "a-c + b");
    EXPECT_EQ(products_text(combine(Intersection, {a, far})), "");
    // A touching face may give the surface its color, but has no volume in common.
    EXPECT_EQ(products_text(combine(Difference, {a, box({4, 0, 0}, {1, 4, 4})})), "a-b");
    EXPECT_EQ(products_text(combine(Intersection, {a, box({4, 0, 0}, {1, 4, 4})})), "");
    EXPECT_EQ(products_text(combine(Difference, {combine(Union, {}), a})), "");
}

TEST(Products, PolyhedraThatAreFlatAndOpenAreSeen) {
    const auto products = [](csg::LeafShape first, csg::LeafShape second) {
        csg::TreeBuilder builder;
        const csg::NodeId both[2]{builder.leaf(std::move(first), {0, 1, 1}),
                                  builder.leaf(std::move(second), {0, 2, 1})};
        Subject subject(builder.finish(builder.combine(Operation::Union, both, {0, 3, 1})));
        return text(products_of(subject.normalize(subject.scene.parts.at(0))));
    };
    const auto polyhedron = [](std::vector<std::vector<std::uint32_t>> faces) {
        return std::make_shared<const csg::Polyhedron>(
            csg::Polyhedron{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, std::move(faces)});
    };

    const csg::Cube cube{{1, 1, 1}, false};
    EXPECT_EQ(products(polyhedron({{0, 1, 2}}), cube), "a + b");
    EXPECT_EQ(products(polyhedron({{0, 1, 2}, {2, 1, 0}}), cube), "b");
}

TEST(Products, BudgetIsAnAnswerNotATrap) {
    // (a1 + … + a40) ∩ … 40 times: 40^40 products.
    std::vector<Model> factors;
    for (int i = 0; i < 40; ++i) {
        std::vector<Model> terms;
        for (int j = 0; j < 40; ++j) {
            terms.push_back(box({0.001 * i, 0.001 * j, 0}, {5, 5, 5}));
        }
        factors.push_back(combine(Operation::Union, std::move(terms)));
    }
    Subject subject(combine(Operation::Intersection, std::move(factors)));
    const auto start = std::chrono::steady_clock::now();
    const auto answer = subject.normalize(subject.scene.parts[0]);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    EXPECT_TRUE(std::holds_alternative<goldfeather::OverBudget>(answer));
    EXPECT_EQ(subject.stats.products_unpruned, 1e18);
}

TEST(Products, BudgetCountsProductsAndLiterals) {
    std::vector<Model> terms;
    for (int i = 0; i < 10; ++i) {
        terms.push_back(box({2.0 * i, 0, 0}, {1, 1, 1}));
    }
    Subject subject(combine(Operation::Union, terms));
    const csg::Part& part = subject.scene.parts[0];
    EXPECT_EQ(products_of(subject.normalize(part, {10, 10})).size(), 10U);
    EXPECT_TRUE(std::holds_alternative<goldfeather::OverBudget>(subject.normalize(part, {9, 1000})));
    EXPECT_TRUE(std::holds_alternative<goldfeather::OverBudget>(subject.normalize(part, {1000, 9})));
}

/// a - (b - (c - …)) and ((a - b) - c) …: as deep as a script can make it.
TEST(Products, DeepChainsDoNotOverflowTheStack) {
    constexpr int kDepth = 100000;
    for (const bool left : {true, false}) {
        csg::TreeBuilder builder;
        std::uint32_t line = 0;
        const auto leaf = [&](double x) { return builder.leaf(csg::Cube{{x, 1, 1}, false}, {0, ++line, 1}); };
        csg::NodeId node = leaf(1);
        for (int i = 0; i < kDepth; ++i) {
            const csg::NodeId other = leaf(1 + 1e-6 * i);
            const csg::NodeId pair[2]{left ? node : other, left ? other : node};
            node = builder.combine(Operation::Difference, pair, {0, ++line, 1});
        }
        Subject subject(builder.finish(node));
        const auto start = std::chrono::steady_clock::now();
        const auto answer = subject.normalize(subject.scene.parts.at(0));
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << left;
        if (left) {
            EXPECT_EQ(products_of(answer).at(0).literals.size(), kDepth + 1U);
        }
    }
}

}  // namespace

// Layers over each other, as styles see through them.
#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <vector>

namespace {

using namespace glm;  // As shader files do.

struct Shader {
#include "peel/composite.glsl"
};

struct Layer {
    bool hit;
    vec4 color;
};

/// Walks the layers, and counts those that are looked at.
Shader::Composite seen(const std::vector<Layer>& layers, float least = 0) {
    Shader shader;
    Shader::Composite c = shader.nothing_seen();
    while (shader.goes_on(c, static_cast<int>(layers.size()), least)) {
        const Layer& next = layers[static_cast<std::size_t>(c.layer)];
        c = shader.behind(c, next.hit, next.color);
    }
    return c;
}

const vec4 kRed(1, 0, 0, 1), kHalfGreen(0, 1, 0, 0.5F), kNothing(0);

TEST(Composite, NearColorsAreOverFarOnes) {
    const Shader::Composite c = seen({{true, kHalfGreen}, {true, kHalfGreen}, {true, kRed}});
    EXPECT_EQ(c.color, vec3(0.25F, 0.75F, 0));
    EXPECT_EQ(c.through, 0.0F);
}

TEST(Composite, EndsWhereNothingComesThrough) {
    EXPECT_EQ(seen({{true, kRed}, {true, kHalfGreen}}).layer, 1);
    EXPECT_EQ(seen({{true, kHalfGreen}, {true, kHalfGreen}, {true, kRed}}, 0.5F).layer, 1);
}

/// Behind the last surface there may still be the outer half of a line.
TEST(Composite, OneLayerWithoutASurfaceIsLookedAt) {
    const Shader::Composite c = seen({{true, kHalfGreen}, {false, kRed}, {true, kHalfGreen}});
    EXPECT_EQ(c.layer, 2);
    EXPECT_EQ(c.color, vec3(0.5F, 0.5F, 0));
    const Shader::Composite bare = seen({{false, kNothing}, {true, kRed}});
    EXPECT_EQ(bare.through, 1.0F);
    EXPECT_EQ(bare.color, vec3(0));
}

TEST(Composite, NoLayersAreNothing) {
    EXPECT_EQ(seen({}).through, 1.0F);
}

}  // namespace

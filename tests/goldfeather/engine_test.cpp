#include "tests/goldfeather/engine_test.h"

#include <algorithm>
#include <utility>

namespace comparison {

namespace {

std::string suffix(gl::ContextKind kind) {
    return kind == gl::ContextKind::Egl ? "_egl" : "_osmesa";
}

/// Names of tests hold letters, digits and underlines only.
std::string test_name(const goldfeather::EngineInfo& info) {
    std::string name(info.name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace

Engine::Engine(const goldfeather::EngineInfo& info, std::unique_ptr<gl::Context> context)
    : info_(info),
      context_(std::move(context)),
      engine_(goldfeather::make_engine(info, {.gl = context_ ? &context_->functions() : nullptr, .threads = 2})) {}

layers::HostStack Engine::peel(const Subject& subject, const base::View& view, int max_layers) {
    goldfeather::WalkStats ignored;
    if (!context_) {
        return *engine_->prepare(subject.input())->draw(view, max_layers, ignored).host;
    }
    context_->make_current();  // Another engine's may have been since.
    const gl::Functions& gl = context_->functions();
    auto layers = peel_all(gl, *engine_, subject, view, max_layers);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return layers;
}

MaybeEngine make_engine(const goldfeather::EngineInfo& info, gl::ContextKind kind) {
    if (!info.capabilities.needs_opengl) {
        return {std::make_unique<Engine>(info, nullptr), {}};
    }
    auto made = test_support::try_context(kind);
    if (!made.context) {
        return {nullptr, made.reason};
    }
    return {std::make_unique<Engine>(info, std::move(made.context)), {}};
}

MaybeEngine make_engine(const std::string& name) {
    for (const goldfeather::EngineInfo& info : goldfeather::engines()) {
        for (const gl::ContextKind kind : {gl::ContextKind::Egl, gl::ContextKind::Osmesa}) {
            if (name == test_name(info) + (info.capabilities.needs_opengl ? suffix(kind) : "")) {
                return make_engine(info, kind);
            }
        }
    }
    return {nullptr, "no such engine"};
}

std::vector<std::string> engine_names(std::initializer_list<gl::ContextKind> kinds) {
    std::vector<std::string> names;
    for (const goldfeather::EngineInfo& info : goldfeather::engines()) {
        if (info.capabilities.most_layers != goldfeather::kAllLayers) {
            continue;
        }
        if (!info.capabilities.needs_opengl) {
            names.push_back(test_name(info));
            continue;
        }
        for (const gl::ContextKind kind : kinds) {
            names.push_back(test_name(info) + suffix(kind));
        }
    }
    return names;
}

void EngineTest::SetUp() {
    MaybeEngine made = make_engine(GetParam());
    engine_ = std::move(made.engine);
    if (!engine_) {
        test_support::skip_or_fail("no OpenGL: " + made.reason);
    }
}

std::string engine_name(const testing::TestParamInfo<std::string>& info) {
    return info.param;
}

}  // namespace comparison

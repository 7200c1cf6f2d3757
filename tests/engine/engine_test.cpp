#include "tests/engine/engine_test.h"

namespace comparison {

namespace {

class OnOpenGl : public Engine {
  public:
    OnOpenGl(std::unique_ptr<gl::Context> context, peel::EngineKind kind)
        : context_(std::move(context)), kind_(kind), peeler_(context_->functions()) {}
    layers::HostStack peel(const Subject& subject, const base::View& view, int max_layers) override {
        context_->make_current();  // Another engine's may have been since.
        auto layers = peel_all(context_->functions(), peeler_, subject, view, max_layers, kind_);
        EXPECT_EQ(context_->functions().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        return layers;
    }
    int most_layers() const override { return kind_ == peel::EngineKind::Scs ? 1 : peel::kAllLayers; }
    bool needs_products() const override { return goldfeather::needs_products(kind_); }

  private:
    std::unique_ptr<gl::Context> context_;
    peel::EngineKind kind_;
    peel::Peeler peeler_;
};

class ListsCpu : public Engine {
  public:
    layers::HostStack peel(const Subject& subject, const base::View& view, int max_layers) override {
        const goldfeather::ListsModel model(subject.scene, subject.geometry);
        goldfeather::ListsStats stats;
        goldfeather::peel_lists(model, view, max_layers, 2, layers_, stats);
        return layers_;
    }
    bool needs_products() const override { return false; }

  private:
    layers::HostStack layers_;  ///< From the picture before, as in the program.
};

}  // namespace

MaybeEngine make_engine(const std::string& name) {
    if (name == "lists_cpu") {
        return {std::make_unique<ListsCpu>(), {}};
    }
    auto made = test_support::try_context(name.ends_with("_egl") ? gl::ContextKind::Egl : gl::ContextKind::Osmesa);
    if (!made.context) {
        return {nullptr, made.reason};
    }
    const auto kind = name.starts_with("lists") ? peel::EngineKind::Lists
                      : name.starts_with("scs") ? peel::EngineKind::Scs
                                                : peel::EngineKind::Goldfeather;
    return {std::make_unique<OnOpenGl>(std::move(made.context), kind), {}};
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

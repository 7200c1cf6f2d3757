// A fixture for tests that every engine must pass.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/goldfeather/comparison.h"
#include "tests/support/gl_test.h"

namespace comparison {

/// An engine with what it needs.
class Engine {
  public:
    /// `context`: null where the engine needs none.
    Engine(const goldfeather::EngineInfo& info, std::unique_ptr<gl::Context> context);
    /// Throws goldfeather::EngineObstacle.
    [[nodiscard]] layers::HostStack peel(const Subject& subject, const base::View& view,
                                         int max_layers = goldfeather::kAllLayers);
    [[nodiscard]] const goldfeather::EngineCapabilities& capabilities() const { return info_.capabilities; }

  private:
    const goldfeather::EngineInfo& info_;
    std::unique_ptr<gl::Context> context_;
    std::unique_ptr<goldfeather::Engine> engine_;
};

/// Null and a reason where there is no such context for it.
struct MaybeEngine {
    std::unique_ptr<Engine> engine;
    std::string reason;
};
[[nodiscard]] MaybeEngine make_engine(const goldfeather::EngineInfo& info, gl::ContextKind kind);
/// By one of `engine_names`.
[[nodiscard]] MaybeEngine make_engine(const std::string& name);

/// Every engine that finds all layers, on every one of the kinds of contexts if it needs any: "lists_egl", "lists_cpu".
[[nodiscard]] std::vector<std::string> engine_names(std::initializer_list<gl::ContextKind> kinds);

/// Runs once per name. Where the engine cannot be had: test_support::skip_or_fail.
class EngineTest : public testing::TestWithParam<std::string> {
  protected:
    void SetUp() override;
    [[nodiscard]] Engine& engine() { return *engine_; }
    [[nodiscard]] Subject subject(const random_tree::Model& model) const {
        return Subject(random_tree::make_tree(model), engine_->capabilities().needs_products);
    }

  private:
    std::unique_ptr<Engine> engine_;
};

[[nodiscard]] std::string engine_name(const testing::TestParamInfo<std::string>& info);

}  // namespace comparison

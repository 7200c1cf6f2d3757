// A fixture for tests that every engine must pass.
#pragma once

#include <memory>
#include <string>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "tests/engine/comparison.h"
#include "tests/support/gl_test.h"

namespace comparison {

/// An engine with what it needs.
class Engine {
  public:
    virtual ~Engine() = default;
    [[nodiscard]] virtual layers::HostStack peel(const Subject& subject, const base::View& view,
                                                 int max_layers = peel::kAllLayers) = 0;
    /// Layers that it finds; kAllLayers where it finds all.
    [[nodiscard]] virtual int most_layers() const { return peel::kAllLayers; }
    /// A part over the budget of products is left out by engines that need them.
    [[nodiscard]] virtual bool needs_products() const = 0;
};

/// "goldfeather_egl", "goldfeather_osmesa", "lists_egl", "lists_osmesa", "scs_egl" or "lists_cpu"; null and a reason
/// where there is no OpenGL for it.
struct MaybeEngine {
    std::unique_ptr<Engine> engine;
    std::string reason;
};
[[nodiscard]] MaybeEngine make_engine(const std::string& name);

/// Runs once per name. Where the engine cannot be had: test_support::skip_or_fail.
class EngineTest : public testing::TestWithParam<std::string> {
  protected:
    void SetUp() override;
    [[nodiscard]] Engine& engine() { return *engine_; }
    [[nodiscard]] Subject subject(const random_tree::Model& model) const {
        return Subject(random_tree::make_tree(model), engine_->needs_products());
    }

  private:
    std::unique_ptr<Engine> engine_;
};

[[nodiscard]] std::string engine_name(const testing::TestParamInfo<std::string>& info);

}  // namespace comparison

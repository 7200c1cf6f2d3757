// A fixture for tests that need OpenGL.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gl/context.h"

namespace test_support {

/// Makes a context of the kind, or gives null and the reason.
struct MaybeContext {
    std::unique_ptr<gl::Context> context;
    std::string reason;
};
[[nodiscard]] MaybeContext try_context(gl::ContextKind kind);

/// Runs once per kind of context (INSTANTIATE_TEST_SUITE_P over gl::ContextKind). Where the kind cannot be had the test
/// is skipped visibly; with CSGSCOPE_REQUIRE_GL=1 in the environment, as in CI, it fails instead.
class GlTest : public testing::TestWithParam<gl::ContextKind> {
  protected:
    void SetUp() override;
    void TearDown() override;
    [[nodiscard]] const gl::Functions& gl() const { return context_->functions(); }

    std::unique_ptr<gl::Context> context_;
};

/// For INSTANTIATE_TEST_SUITE_P: "egl" or "osmesa".
[[nodiscard]] std::string context_name(const testing::TestParamInfo<gl::ContextKind>& info);

}  // namespace test_support

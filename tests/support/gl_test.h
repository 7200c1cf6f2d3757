// A fixture for tests that need OpenGL.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "gl/context.h"

namespace test_support {

/// Makes a context of the kind, or gives null and the reason.
struct MaybeContext {
    std::unique_ptr<gl::Context> context;
    std::string reason;
};
[[nodiscard]] MaybeContext try_context(gl::ContextKind kind);

/// Skips the test visibly; with CSGSCOPE_REQUIRE_GL=1 in the environment, as in CI, it fails instead. Return after it.
void skip_or_fail(const std::string& reason);

/// Runs once per kind of context (INSTANTIATE_TEST_SUITE_P over gl::ContextKind). Where the kind cannot be had:
/// skip_or_fail.
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

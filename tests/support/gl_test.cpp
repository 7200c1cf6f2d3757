#include "tests/support/gl_test.h"

#include <cstdlib>

#include "gl/error.h"

namespace test_support {

MaybeContext try_context(gl::ContextKind kind) {
    try {
        return {gl::create_context(kind), {}};
    } catch (const gl::Error& e) {
        return {nullptr, e.what()};
    }
}

void skip_or_fail(const std::string& reason) {
    const char* required = std::getenv("CSGSCOPE_REQUIRE_GL");
    if (required != nullptr && *required == '1') {
        FAIL() << reason;
    }
    GTEST_SKIP() << reason;
}

void GlTest::SetUp() {
    MaybeContext made = try_context(GetParam());
    if (made.context) {
        context_ = std::move(made.context);
        return;
    }
    skip_or_fail("no OpenGL: " + made.reason);
}

void GlTest::TearDown() {
    if (!context_ || HasFailure()) {
        return;
    }
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

std::string context_name(const testing::TestParamInfo<gl::ContextKind>& info) {
    return gl::name(info.param);
}

}  // namespace test_support

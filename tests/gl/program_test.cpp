#include "gl/program.h"

#include "gl/error.h"
#include "tests/support/gl_test.h"

namespace {

using ProgramTest = test_support::GlTest;

const gl::ShaderFile kFiles[] = {
    {"t/half.glsl", "float half_of(float x) {\n    return 0.5 * x;\n}\n"},
    {"t/good.vert", "void main() {\n    gl_Position = vec4(0.0);\n}\n"},
    {"t/good.frag", "#include \"t/half.glsl\"\nout vec4 c;\nvoid main() {\n    c = vec4(half_of(1.0));\n}\n"},
    {"t/set.frag",
     "uniform float used;\nlayout(location = 9) uniform vec3 unused;\nout vec4 c;\n"
     "void main() {\n    c = vec4(used);\n}\n"},
    {"t/bad.frag", "#include \"t/half.glsl\"\nout vec4 c;\nvoid main() {\n    c = nonsense;\n}\n"},
};

gl::ShaderLibrary library() {
    gl::ShaderLibrary l;
    l.add(kFiles);
    return l;
}

TEST_P(ProgramTest, LinksWithIncludes) {
    const gl::Program program(gl(), library(), {"t/good.vert", "t/good.frag"});
    EXPECT_TRUE(program);
}

TEST_P(ProgramTest, AnErrorNamesFileAndLine) {
    try {
        const gl::Program program(gl(), library(), {"t/good.vert", "t/bad.frag"});
        FAIL() << "it compiled";
    } catch (const gl::Error& e) {
        EXPECT_NE(std::string(e.what()).find("t/bad.frag:4"), std::string::npos) << e.what();
    }
}

TEST_P(ProgramTest, AMissingFileIsAnError) {
    EXPECT_THROW(gl::Program(gl(), library(), {"t/none.vert"}), gl::Error);
}

TEST_P(ProgramTest, AUniformThatNobodyDeclaresIsAnErrorEachTime) {
    const gl::Program program(gl(), library(), {"t/good.vert", "t/set.frag"});
    EXPECT_NO_THROW(program.set("used", 1.0F));
    EXPECT_NO_THROW(program.set("unused", glm::vec3(1)));
    for (int i = 0; i < 2; ++i) {
        try {
            program.set("usde", 1.0F);
            FAIL() << "it was taken";
        } catch (const std::logic_error& e) {
            EXPECT_EQ(std::string(e.what()), "t/good.vert t/set.frag declares no uniform 'usde'");
        }
    }
}

TEST_P(ProgramTest, IsOpenGl45Core) {
    GLint major = 0, minor = 0;
    gl().GetIntegerv(GL_MAJOR_VERSION, &major);
    gl().GetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(major * 10 + minor, 45) << context_->version();
}

INSTANTIATE_TEST_SUITE_P(Contexts, ProgramTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace

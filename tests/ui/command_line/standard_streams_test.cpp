// Streams that are full, closed or non-blocking.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>

#include "tests/support/program_test.h"

namespace {

class StandardStreams : public test_support::ProgramTest {
  protected:
    StandardStreams() : ProgramTest(60) {
        folder_.write("echo.scad", "for (i = [0:99]) echo(i);\necho(undeclared);\nsquare(3);\n");
        folder_.write("warn.scad", "cube(1);\ncolor(\"nocolor\") cube(2);\nimport(\"none.stl\");\n");
        folder_.write("bad.scad", "cube(;\n");
    }
    [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_.path(name)); }
};

TEST_F(StandardStreams, MessagesThatNobodyCanReadAreDropped) {
    for (const char* const where : {"2>/dev/full", "2>&-", "2>&- >&- <&-", "2>/dev/full >/dev/full"}) {
        SCOPED_TRACE(where);
        EXPECT_EQ(status_of("echo.scad -o x.csg", where), 0);
        EXPECT_TRUE(exists("x.csg"));
        EXPECT_EQ(status_of("warn.scad -o x.png --imgsize 20,20 --summary all", where), 0);
        EXPECT_TRUE(exists("x.png"));
        EXPECT_EQ(status_of("m.scad -o x.stl", where), 0);
        EXPECT_TRUE(exists("x.stl"));
        // What would have failed fails.
        EXPECT_EQ(status_of("bad.scad -o y.csg", where), 1);
        EXPECT_EQ(status_of("warn.scad -o y.stl", where), 1);
        EXPECT_EQ(status_of("--nonsense", where), 1);
        EXPECT_EQ(status_of("none.scad -o y.csg", where), 1);
        EXPECT_FALSE(exists("y.csg") || exists("y.stl"));
        for (const char* const name : {"x.csg", "x.png", "x.stl"}) {
            folder_.remove(name);
        }
    }
}

TEST_F(StandardStreams, NoOutputTakesTheNumberOfAClosedOne) {
    // Messages are in no file: the picture and the text are what they are with open streams.
    ASSERT_EQ(run("echo.scad -o a.csg").status, 0);
    ASSERT_EQ(status_of("echo.scad -o b.csg", "<&- >&- 2>&-"), 0);
    EXPECT_EQ(folder_.read("a.csg"), folder_.read("b.csg"));
}

TEST_F(StandardStreams, AReaderThatIsGoneOrSlowCostsNothing) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    const std::string much(65536, 'x');
    while (write(ends[1], much.data(), much.size()) > 0) {
    }
    EXPECT_EQ(status_with_standard_error("echo.scad -o x.csg", ends[1]), 0) << "full, and nobody reads";
    EXPECT_TRUE(exists("x.csg"));
    close(ends[0]);
    EXPECT_EQ(status_with_standard_error("echo.scad -o y.csg", ends[1]), 0) << "nobody is there";
    EXPECT_TRUE(exists("y.csg"));
    close(ends[1]);
}

TEST_F(StandardStreams, WhatIsWrittenThereMustArrive) {
    for (const char* const where : {">/dev/full 2>/dev/null", ">&- 2>/dev/null"}) {
        EXPECT_EQ(status_of("echo.scad -o - --export-format csg", where), 1) << where;
        EXPECT_EQ(status_of("--help", where), 1) << where;
        EXPECT_EQ(status_of("m.scad -o x.png --imgsize 20,20 --stats -", where), 1) << where;
        EXPECT_EQ(status_of("compare m.scad --imgsize 20", where), 1) << where;
    }
    EXPECT_EQ(status_of("- -o x.csg", "<&- 2>/dev/null"), 1) << "nothing to read";
    EXPECT_EQ(status_of("m.scad -o /dev/stdout --export-format csg", ">out.csg"), 0);
    EXPECT_NE(folder_.read("out.csg").find("cube"), std::string::npos);
}

TEST_F(StandardStreams, ASlowReaderGetsEverything) {
    folder_.write("long.scad", "for (i = [0:20000]) translate([i, 0, 0]) cube(1);\n");
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    const pid_t reader = fork();
    if (reader == 0) {
        close(ends[1]);
        usleep(300'000);
        dup2(ends[0], STDIN_FILENO);
        execlp("sh", "sh", "-c", ("cat > '" + folder_.path("read.csg") + "'").c_str(), nullptr);
        _exit(1);
    }
    EXPECT_EQ(status_of("long.scad -o - --export-format csg", ">&" + std::to_string(ends[1])), 0);
    close(ends[0]);
    close(ends[1]);
    int status = 0;
    ASSERT_EQ(waitpid(reader, &status, 0), reader);
    ASSERT_EQ(run("long.scad -o long.csg").status, 0);
    EXPECT_EQ(folder_.read("read.csg"), folder_.read("long.csg"));
}

}  // namespace

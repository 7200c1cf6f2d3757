// Memory that is not there: told with what it was for, and never more than asked for.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>

#include "tests/support/program_test.h"
#include "tests/support/sanitizer.h"

namespace {

class MemoryLimit : public test_support::ProgramTest {
  protected:
    MemoryLimit() : ProgramTest(100) {}

    /// The largest resident set of a run, in MiB, and how it ended.
    struct Peak {
        double mebibytes;
        int status;
        std::string err;
    };
    [[nodiscard]] Peak peak_of(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder_.path("") + "' && exec '" CSGSCOPE_PROGRAM "' " + arguments + " >out.txt 2>err.txt";
        const pid_t child = fork();
        if (child == 0) {
            execlp("sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
        int status = 0;
        rusage usage{};
        if (wait4(child, &status, 0, &usage) != child) {
            return {};
        }
        return {static_cast<double>(usage.ru_maxrss) / 1024, WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                folder_.read("err.txt")};
    }
};

TEST_F(MemoryLimit, IsSaidFromEveryThreadWithTheStage) {
    const std::string told = test_support::kAddressSanitizer ? "--memory-limit: the evaluation needs more than"
                                                             : "out of memory for drawing: --memory-limit is too low";
    folder_.write("x.scad", "sphere(10, $fn = 200);\n");
    for (const char* const limit : {"200", "400", "800"}) {
        const Result result = run(std::string("x.scad -o x.png --imgsize 8192,8192 --memory-limit ") + limit);
        EXPECT_EQ(result.status, 1) << limit << result.err;
        EXPECT_NE(result.err.find(told), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder_.path("x.png")));
    }
    for (const char* const engine : {"goldfeather", "lists"}) {  // Their memory is OpenGL's.
        const Result result = run(
            std::string("m.scad -o x.png --imgsize 3000,3000 --context osmesa --memory-limit 220 --engine ") + engine);
        EXPECT_EQ(result.status, 1) << engine;
        EXPECT_NE(result.err.find(told), std::string::npos) << engine << ": " << result.err;
    }
    for (const char* const limit : {"300000", "600000", "1000000"}) {
        const Result result =
            run("x.scad -o x.png --imgsize 8192,8192 --context none", std::string("ulimit -v ") + limit + ";");
        EXPECT_EQ(result.status, test_support::kAddressSanitizer ? -1 : 1) << limit << result.err;  // It has no shadow.
        EXPECT_FALSE(std::filesystem::exists(folder_.path("x.png")));
    }
}

TEST_F(MemoryLimit, IsWhatWasAskedFor) {
    folder_.write("list.scad", "x = [for (i = [0:20000000]) [i, i]];\necho(len(x));\ncube(1);\n");
    folder_.write("hull.scad", "minkowski() { sphere(10, $fn = 300); sphere(1, $fn = 300); }\n");
    for (const char* const what : {"m.scad -o x.png --imgsize 8192,8192 --context none", "list.scad -o x.csg",
                                   "list.scad -o x.stl", "hull.scad -o x.stl"}) {
        for (const int limit : {150, 300, 500}) {
            if (test_support::kAddressSanitizer && limit < 300) {
                continue;  // The shadow of the program alone is as large.
            }
            const Peak peak = peak_of(what + std::string(" --memory-limit ") + std::to_string(limit));
            EXPECT_LE(peak.mebibytes, limit) << what << " " << peak.err;
            EXPECT_TRUE(peak.status == 0 || (peak.status == 1 && peak.err.find("emory") != std::string::npos) ||
                        peak.err.find("Lists hold") != std::string::npos)
                << what << " " << limit << ": " << peak.status << " " << peak.err;
        }
    }
}

}  // namespace

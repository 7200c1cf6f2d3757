// Files as they are written: signals, links, modes, long names, pipes where files are expected.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "base/file.h"
#include "tests/support/program_test.h"

namespace {

namespace fs = std::filesystem;

class Writing : public test_support::ProgramTest {
  protected:
    Writing() : ProgramTest(60) {}
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_.path("")), fs::directory_iterator()));
    }
    /// Of the process whose number is in the file, which goes: within some seconds.
    [[nodiscard]] bool has_ended(const std::string& file) const {
        const std::string process = "/proc/" + std::to_string(std::stoi(folder_.read(file))) + "/cmdline";
        folder_.remove(file);
        for (int i = 0; i < 100 && !test_support::read_file(process).empty(); ++i) {
            usleep(50'000);
        }
        return test_support::read_file(process).empty();
    }
    [[nodiscard]] static mode_t mode_of(const std::string& path) {
        struct stat there {};
        return stat(path.c_str(), &there) == 0 ? there.st_mode & 07777U : 0;
    }
};

TEST_F(Writing, ASignalLeavesNoTemporaryFile) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGXCPU}) {
        const pid_t child = fork();
        if (child == 0) {
            base::remove_temporary_names_at_signals();
            base::FileWriter kept(folder_.path("kept.stl"));
            kept.write("all");
            kept.finish();
            base::FileWriter writer(folder_.path("x.stl"));
            writer.write("half");
            raise(signal);
            _exit(0);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
        EXPECT_EQ(files(), 2U) << "m.scad and kept.stl, after signal " << signal;
    }
}

TEST_F(Writing, TheProgramRemovesWhatItWasWritingWhenItIsEnded) {
    // Both programs: a text by one, a mesh by the other. Each is ended at many moments, in the writing too.
    folder_.write("long.scad", "for (i = [0:60000]) translate([i, 0, 0]) cube(1);\n");
    for (const char* const run_of : {"long.scad -o x.csg", "m.scad -o x.stl"}) {
        for (const char* const signal : {"TERM", "INT", "HUP"}) {
            for (int moment = 1; moment <= 8; ++moment) {
                (void)std::system(("cd '" + folder_.path("") + "' && timeout -s " + signal + " 0.0" +
                                   std::to_string(moment) + " '" CSGSCOPE_PROGRAM "' " + run_of + " 2>&-")
                                      .c_str());
                fs::remove(folder_.path("x.csg"));
                fs::remove(folder_.path("x.stl"));
                ASSERT_EQ(files(), 2U) << run_of << " " << signal << " " << moment;
            }
        }
    }
    (void)std::system(("cd '" + folder_.path("") + "' && nohup '" CSGSCOPE_PROGRAM "' m.scad -o x.csg 2>&-").c_str());
}

TEST_F(Writing, OtherProgramsEndWithThisOneAndLeaveNothing) {
    // Stand-ins: openscad answers from files and is not done with one of them; an X server that is there at once.
    ASSERT_EQ(run("m.scad -o mesh.off -o tree.csg").status, 0);
    for (const char* const made : {"bin", "temporary"}) {
        fs::create_directory(folder_.path(made));
    }
    const auto write_program = [&](const std::string& name, const std::string& text) {
        fs::permissions(folder_.write("bin/" + name, "#!/bin/sh\n" + text), fs::perms::owner_all);
    };
    write_program("Xvfb", "echo $$ >Xvfb.pid; echo 7; exec sleep 60\n");
    for (const std::string waits_for : {"off", "csg", "png"}) {
        write_program("openscad", "case \"$*\" in\n*' " + waits_for +
                                      " '*) echo $$ >openscad.pid; exec sleep 60 ;;\n"
                                      "*' off '*) cat mesh.off ;;\n*) cat tree.csg ;;\nesac\n");
        for (const std::string signal : {"TERM", "KILL"}) {
            const std::string command =
                "cd '" + folder_.path("") +
                "' || exit; env -u DISPLAY PATH=\"$PWD/bin:$PATH\" TMPDIR=\"$PWD/temporary\" '" +
                CSGSCOPE_PROGRAM
                "' compare m.scad --against openscad --views 1 --imgsize 32 >out.txt 2>err.txt & "
                "for i in $(seq 600); do [ -s openscad.pid ] && break; sleep 0.05; done; kill -s " +
                signal + " $!; wait $! 2>err.txt";
            (void)std::system(command.c_str());
            const int display = waits_for == "png" ? 1 : 0;
            ASSERT_EQ(fs::exists(folder_.path("Xvfb.pid")), display == 1) << folder_.read("err.txt");
            EXPECT_TRUE(has_ended("openscad.pid")) << waits_for << " " << signal;
            EXPECT_TRUE(display == 0 || has_ended("Xvfb.pid")) << signal;
            EXPECT_TRUE(fs::is_empty(folder_.path("temporary"))) << waits_for << " " << signal;
        }
    }
}

TEST_F(Writing, TheCommandForMissingFilesEndsWithTheTimeLimit) {
    fs::permissions(folder_.write("wait", "#!/bin/sh\necho $$ >wait.pid; exec sleep 60\n"), fs::perms::owner_all);
    folder_.write("x.scad", "import(\"none.stl\");");
    EXPECT_EQ(run("x.scad -o x.stl -m ./wait --time-limit 0.5").status, 1);
    EXPECT_TRUE(has_ended("wait.pid"));
    fs::permissions(folder_.write("make", "#!/bin/sh\necho made \"$1\"; cp m.stl \"$1\"; exit 3\n"),
                    fs::perms::owner_all);
    ASSERT_EQ(run("m.scad -o m.stl").status, 0);
    const Result made = run("x.scad -o x.stl -m ./make");
    EXPECT_EQ(made.status, 0);
    EXPECT_EQ(made.out, "made none.stl\n");
    EXPECT_NE(made.err.find("./make 'none.stl' ended with status 3"), std::string::npos) << made.err;
}

TEST_F(Writing, TheModelIsNotWrittenThroughALink) {
    fs::create_symlink("m.scad", folder_.path("m.csg"));
    fs::create_directory_symlink(".", folder_.path("here"));
    for (const char* const outputs :
         {"-o m.csg", "-o here/m.csg", "-o x.csg -d here/x.csg", "-o x.csg --stats m.csg"}) {
        EXPECT_EQ(run(std::string("m.scad ") + outputs).status, 1) << outputs;
        EXPECT_TRUE(folder_.read("m.scad").starts_with("difference() { cube"));
        EXPECT_FALSE(fs::exists(folder_.path("x.csg")));
    }
}

TEST_F(Writing, ALinkStaysAndItsTargetIsWritten) {
    fs::create_directory(folder_.path("elsewhere"));
    folder_.write("elsewhere/real.stl", "old");
    fs::create_symlink("elsewhere/real.stl", folder_.path("link.stl"));
    fs::create_symlink("link.stl", folder_.path("second.stl"));
    fs::create_symlink("elsewhere/new.stl", folder_.path("dangling.stl"));
    ASSERT_EQ(run("m.scad -o second.stl -o dangling.stl").status, 0);
    EXPECT_TRUE(fs::is_symlink(folder_.path("second.stl")) && fs::is_symlink(folder_.path("link.stl")));
    EXPECT_TRUE(fs::is_symlink(folder_.path("dangling.stl")));
    EXPECT_EQ(folder_.read("elsewhere/real.stl"), folder_.read("elsewhere/new.stl"));
    EXPECT_TRUE(folder_.read("elsewhere/real.stl").starts_with("solid"));
    fs::create_symlink("a.csg", folder_.path("b.csg"));
    fs::create_symlink("b.csg", folder_.path("a.csg"));
    EXPECT_EQ(run("m.scad -o a.csg").status, 1);
    EXPECT_TRUE(fs::is_symlink(folder_.path("a.csg")));
}

TEST_F(Writing, TheModeOfAFileIsKept) {
    for (const mode_t mode : {0600U, 0640U, 0666U, 0755U}) {
        folder_.write("x.csg", "old");
        chmod(folder_.path("x.csg").c_str(), mode);
        ASSERT_EQ(run("m.scad -o x.csg", "umask 027;").status, 0);
        EXPECT_EQ(mode_of(folder_.path("x.csg")), mode);
    }
    ASSERT_EQ(run("m.scad -o new.csg", "umask 027;").status, 0);
    EXPECT_EQ(mode_of(folder_.path("new.csg")), 0640U);
    if (geteuid() != 0) {
        chmod(folder_.path("x.csg").c_str(), 0444);
        EXPECT_EQ(run("m.scad -o x.csg").status, 1) << "a file that nobody may write";
    }
}

TEST_F(Writing, NamesMayBeAsLongAsTheSystemAllows) {
    for (const std::string& letter : {std::string("x"), std::string("é"), std::string("語")}) {
        std::string name;
        while (name.size() + letter.size() <= 251) {
            name += letter;
        }
        name += ".csg";
        EXPECT_EQ(run("m.scad -o " + name).status, 0) << name;
        EXPECT_TRUE(fs::exists(folder_.path(name)));
    }
    EXPECT_EQ(run("m.scad -o " + std::string(252, 'x') + ".csg").status, 1) << "one too long";
}

TEST_F(Writing, PipesWhereFilesAreExpectedDoNotHang) {
    ASSERT_EQ(run("m.scad -o a.off --cache kept").status, 0);
    const fs::path entry = fs::directory_iterator(folder_.path("kept"))->path();
    fs::remove(entry);
    ASSERT_EQ(mkfifo(entry.c_str(), 0600), 0);
    const Result result = run("m.scad -o b.off --cache kept");
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("no regular file"), std::string::npos) << result.err;
    EXPECT_EQ(folder_.read("a.off"), folder_.read("b.off"));
    ASSERT_EQ(mkfifo(folder_.path("folder").c_str(), 0600), 0);
    EXPECT_EQ(run("m.scad -o c.off --cache folder").status, 0);
    for (const char* const name : {"against.stl", "against.png"}) {
        ASSERT_EQ(mkfifo(folder_.path(name).c_str(), 0600), 0);
        EXPECT_EQ(run(std::string("compare m.scad --against ") + name).status, 1) << name;
    }
    EXPECT_EQ(run("compare against.png --against against.png").status, 1);
    for (const char* const name : {"p.stl", "p.3mf", "p.svg", "p.dxf", "p.png"}) {
        ASSERT_EQ(mkfifo(folder_.path(name).c_str(), 0600), 0);
        folder_.write("x.scad",
                      std::string(name) == "p.png" ? "surface(\"p.png\");" : "import(\"" + std::string(name) + "\");");
        EXPECT_EQ(run("x.scad -o x.png --imgsize 20,20").status, 0) << name;
    }
}

TEST_F(Writing, WhatCannotBeWrittenIsSaidAndNothingIsLeft) {
    fs::create_directory(folder_.path("folder.csg"));
    EXPECT_EQ(run("m.scad -o folder.csg").status, 1);
    EXPECT_EQ(run("m.scad -o none/x.csg").status, 1);
    EXPECT_EQ(run("m.scad -o m.scad/x.csg").status, 1) << "below a file";
    EXPECT_EQ(run("m.scad -o x.csg -o ./x.csg").status, 1) << "twice the same";
    EXPECT_EQ(run("m.scad -o x.csg -d x.csg").status, 1);
    EXPECT_EQ(run("m.scad -o m.scad --export-format csg").status, 1) << "over the model";
    EXPECT_TRUE(folder_.read("m.scad").starts_with("difference"));
    // A file size limit: an error, not a signal.
    folder_.write("long.scad", "for (i = [0:60000]) translate([i, 0, 0]) cube(1);\n");
    const Result result = run("long.scad -o x.csg", "ulimit -f 8;");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("x.csg: cannot be written: File too large"), std::string::npos) << result.err;
    if (geteuid() != 0) {
        chmod(folder_.path("").c_str(), 0500);
        EXPECT_EQ(status_of("m.scad -o x.csg", "2>/dev/null"), 1);
        chmod(folder_.path("").c_str(), 0700);
    }
    EXPECT_FALSE(fs::exists(folder_.path("x.csg")));
}

}  // namespace

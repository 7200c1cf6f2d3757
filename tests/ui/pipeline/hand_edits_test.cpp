// Texts that are edited by hand: statements found, edits merged, steps undone, and what a killed program leaves.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include "tests/support/temporary_folder.h"
#include "ui/pipeline/editing/recovery.h"
#include "ui/pipeline/editing/statement_edits.h"
#include "ui/pipeline/editing/text_document.h"

namespace ui {
namespace {

/// What the statement at the first '@' is, which is taken out before.
std::string at_mark(std::string text) {
    const std::size_t at = text.find('@');
    text.erase(at, 1);
    const auto found = statement_at(text, at);
    return found
               ? text.substr(found->bytes.begin, found->bytes.end - found->bytes.begin) + (found->sole ? " (sole)" : "")
               : "nothing";
}

TEST(StatementPieces, FindsTheInnermostStatement) {
    EXPECT_EQ(at_mark("cube(1); translate([1, 2, 3]) @sphere(2); cube(3);"), "translate([1, 2, 3]) sphere(2);");
    EXPECT_EQ(at_mark("difference() {\n  cube(1);\n  #@sphere(2); // b\n}"), "#sphere(2);");
    EXPECT_EQ(at_mark("diff@erence() {\n  cube(1);\n}\nsphere(2);"), "difference() {\n  cube(1);\n}");
    EXPECT_EQ(at_mark("module lid(a, b = [1, (2)]) cu@be(1);\nlid();"), "cube(1); (sole)");
    EXPECT_EQ(at_mark("module lid() { cube(1); cu@be(2); }"), "cube(2);");
    EXPECT_EQ(at_mark("if (a) { cube(1); } else cu@be(2);"), "cube(2); (sole)");
    EXPECT_EQ(at_mark("if (a) cu@be(1); else if (b) cube(2); else { cube(3); } sphere(1);"),
              "if (a) cube(1); else if (b) cube(2); else { cube(3); }");
    EXPECT_EQ(at_mark("a = \"};{\"; /* ; */ for (i = [0:2]) translate([i, 0]) @cube(1); // ;"),
              "for (i = [0:2]) translate([i, 0]) cube(1);");
    EXPECT_EQ(at_mark("use <a;b.scad>\ncu@be(1);"), "cube(1);");
    EXPECT_EQ(at_mark("cube(1); // @here"), "nothing");
    EXPECT_EQ(at_mark("cube(1); } @sphere(1);"), "sphere(1);") << "a brace too many";
    EXPECT_TRUE(at_mark(std::string(100'000, '{') + "@cube(1);").ends_with("{cube(1);")) << "no deeper than the parser";
}

TEST(StatementPieces, AreAllOfTheText) {
    const std::string text =
        "include <a.scad> // a\nx = [for (i = 0; i < 3; i = i + 1) i]; // x\ncube(x) {\n} sphere(1)";
    std::size_t at = 0;
    std::vector<std::string> pieces;
    for (const csg::scad::ByteRange& bytes : statement_pieces(text)) {
        EXPECT_EQ(bytes.begin, at);
        at = bytes.end;
        pieces.push_back(text.substr(bytes.begin, bytes.end - bytes.begin));
    }
    EXPECT_EQ(at, text.size());
    EXPECT_EQ(pieces,
              (std::vector<std::string>{"include <a.scad> // a\n", "x = [for (i = 0; i < 3; i = i + 1) i]; // x\n",
                                        "cube(x) {\n", "}", " sphere(1)"}));
}

std::string after(const std::string& text, const StatementEdit& edit) {
    const std::string result = edited(text, {edit.edit});
    const auto [begin, end] = edit.added;
    return result.substr(0, begin) + "«" + result.substr(begin, end - begin) + "»" + result.substr(end);
}

StatementText statement_with(const std::string& text, const std::string& part) {
    return *statement_at(text, text.find(part));
}

TEST(StatementEdits, KeepCommentsAndLayout) {
    const std::string text = "// a box\ndifference() {\n\tcube(3); // outside\n\tsphere(1);  // inside\n}\n// end";
    EXPECT_EQ(after(text, append_statement(text, "cube(1);")), text + "\n«cube(1);»\n");
    EXPECT_EQ(after("a = 1;\r\n", append_statement("a = 1;\r\n", "cube(1);")), "a = 1;\r\n«cube(1);»\r\n");
    EXPECT_EQ(after(text, double_statement(text, statement_with(text, "cube"))),
              "// a box\ndifference() {\n\tcube(3);\n\t«cube(3);» // outside\n\tsphere(1);  // inside\n}\n// end");
    EXPECT_EQ(after(text, delete_statement(text, statement_with(text, "sphere"))),
              "// a box\ndifference() {\n\tcube(3); // outside\n\t«»  // inside\n}\n// end");
    EXPECT_EQ(after("cube(1);\n  sphere(1);\t\ncube(2);",
                    delete_statement("cube(1);\n  sphere(1);\t\ncube(2);", {{11, 21}, false})),
              "cube(1);\n«»cube(2);");
    EXPECT_EQ(
        after(text, subtract_from_statement(text, statement_with(text, "difference"), "cylinder(1);")),
        "// a box\ndifference() {\n\tcube(3); // outside\n\tsphere(1);  // inside\n    «cylinder(1);»\n}\n// end");
    EXPECT_EQ(after(text, subtract_from_statement(text, statement_with(text, "cube"), "cylinder(1);")),
              "// a box\ndifference() {\n\tdifference() {\n\t    cube(3);\n\t    «cylinder(1);»\n\t} // outside\n"
              "\tsphere(1);  // inside\n}\n// end");
    const std::string sole = "module m() cube(1);\nm();";
    EXPECT_EQ(after(sole, delete_statement(sole, statement_with(sole, "cube"))), "module m() «»;\nm();");
    EXPECT_EQ(after(sole, double_statement(sole, statement_with(sole, "cube"))),
              "module m() {\n    cube(1);\n    «cube(1);»\n}\nm();");
}

TEST(StatementEdits, ArrangeWhatIsThere) {
    const std::string text = "// a box\ndifference() {\n    cube(3); // outside\n    #sphere(i);\n}\n";
    const StatementText all = statement_with(text, "difference"), ball = statement_with(text, "sphere");
    EXPECT_EQ(after(text, put_before_statement(all, "mirror([1, 0, 0]) ")),
              "// a box\n«mirror([1, 0, 0]) difference() {\n    cube(3); // outside\n    #sphere(i);\n}»\n");
    EXPECT_EQ(after(text, group_statement(text, ball, "union()")),
              "// a box\ndifference() {\n    cube(3); // outside\n    «union() {\n        #sphere(i);\n    }»\n}\n");
    ASSERT_TRUE(ungroup_statement(text, all));
    EXPECT_EQ(after(text, *ungroup_statement(text, all)), "// a box\n«cube(3); // outside\n#sphere(i);»\n");
    EXPECT_FALSE(ungroup_statement(text, ball));
    const std::string grouped = edited(text, {group_statement(text, ball, "union()").edit});
    EXPECT_EQ(edited(grouped, {ungroup_statement(grouped, statement_with(grouped, "union"))->edit}), text)
        << "there and back";
    ASSERT_TRUE(change_operation(text, all, "hull"));
    EXPECT_EQ(after(text, *change_operation(text, all, "hull")),
              "// a box\n«hull() {\n    cube(3); // outside\n    #sphere(i);\n}»\n");
    EXPECT_FALSE(change_operation(text, all, "difference"));
    EXPECT_FALSE(change_operation(text, ball, "hull"));
    EXPECT_EQ(after(text, toggle_modifier(text, ball, '#')),
              "// a box\ndifference() {\n    cube(3); // outside\n    «sphere(i);»\n}\n");
    EXPECT_EQ(after(text, toggle_modifier(text, ball, '%')),
              "// a box\ndifference() {\n    cube(3); // outside\n    «%#sphere(i);»\n}\n");
    EXPECT_EQ(loop_variable(text, all), "j");
    EXPECT_EQ(loop_variable(text, statement_with(text, "cube")), "i");
    EXPECT_EQ(loop_variable("m(i, j, k, n);", {{0, 14}, false}), "i2");
}

TEST(MergeTexts, PutsChangesOfDifferentStatementsTogether) {
    const std::string base = "a = 1; // one\nb = 2;\ndifference() {\n    cube(a);\n    sphere(b);\n}\n";
    const auto with = [&](std::string from, const std::string& to, std::string text) {
        return text.replace(text.find(from), from.size(), to);
    };
    const std::string ours = with("cube(a)", "translate([1, 0, 0]) cube(a)", base) + "cube(7);\n";
    const std::string theirs = with("a = 1", "a = 5", with("sphere(b)", "sphere(d = b)", base)) + "cube(8);\n";
    const Merged both = merged(base, ours, theirs);
    EXPECT_TRUE(both.conflicts.empty());
    EXPECT_EQ(both.text,
              "a = 5; // one\nb = 2;\ndifference() {\n    translate([1, 0, 0]) cube(a);\n    sphere(d = b);\n}\n"
              "cube(8);\ncube(7);\n");
    EXPECT_EQ(merged(base, with("b = 2;\n", "", base), with("a = 1;", "a = 3;", base)).text,
              "a = 3; // one\ndifference() {\n    cube(a);\n    sphere(b);\n}\n");
    const Merged same = merged(base, base + "cube(7);\n", base + "cube(7);\n");
    EXPECT_EQ(same.text, base + "cube(7);\n") << "what both have put in stands there once";
}

TEST(MergeTexts, ATrueConflictShowsBoth) {
    const std::string base = "a = 1;\ncube(a);\nsphere(2);\n";
    const Merged both = merged(base, "a = 1;\ncube(a + 1);\nsphere(2);\n", "a = 2;\ncube(a + 2);\nsphere(2);\n");
    EXPECT_EQ(both.text, "a = 2;\ncube(a + 1);\nsphere(2);\n");
    ASSERT_EQ(both.conflicts.size(), 1U);
    EXPECT_EQ(both.conflicts[0], (MergeConflict{{7, 20}, "cube(a);\n", "cube(a + 1);\n", "cube(a + 2);\n"}));
    EXPECT_EQ(merged(base, "a = 1;\nsphere(2);\n", "a = 1;\ncube(9);\nsphere(2);\n").conflicts.size(), 1U)
        << "one has taken away what the other has changed";
}

TEST(MergeTexts, OfRandomEditsEachSideIsFound) {
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        std::string base, ours, theirs, expected;
        const int count = static_cast<int>(random() % 20) + 1;
        for (int i = 0; i < count; ++i) {
            const std::string line = "cube(" + std::to_string(random() % 4) + "); // " + std::to_string(i) + "\n";
            const std::string other = "sphere(" + std::to_string(random() % 100) + "); // " + std::to_string(i) + "\n";
            const auto what = random() % 6;
            base += line;
            ours += what == 0 ? other : what == 1 ? "" : line;
            theirs += what == 2 ? other : what == 3 ? "" : line;
            expected += what == 0 || what == 2 ? other : what == 1 || what == 3 ? "" : line;
        }
        const Merged both = merged(base, ours, theirs);
        EXPECT_EQ(both.text, expected) << base << "---\n" << ours << "---\n" << theirs;
        EXPECT_TRUE(both.conflicts.empty());
    }
}

TEST(TextDocument, UndoesToTheStartAndDoesAgainToTheEnd) {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        const std::string first = "cube(1);\ntranslate([1, 2, 3]) sphere(4);\n";
        TextDocument document(first);
        std::vector<std::string> texts{first};
        for (int i = 0; i < 60; ++i) {
            std::string text = document.text();
            const std::size_t at = random() % (text.size() + 1), length = random() % 5;
            const std::string put(random() % 4, static_cast<char>('a' + random() % 26));
            switch (random() % 4) {
                case 0:
                    document.edit({{{at, std::min(at + length, text.size())}, put}, {{text.size(), text.size()}, put}},
                                  "edit");
                    break;
                case 1:
                    document.set_text(text.insert(at, put), "type", true);
                    break;
                case 2:
                    document.set_text(text.erase(at, length), "erase", random() % 2 == 0);
                    break;
                default:
                    (void)document.take_from_disk(text.insert(at, put));
            }
            if (document.steps() == texts.size()) {
                texts.push_back(document.text());
            } else {
                ASSERT_EQ(document.steps() + 1, texts.size()) << "typing goes on";
                texts.back() = document.text();
            }
        }
        for (std::size_t i = texts.size(); i-- > 1;) {
            EXPECT_EQ(document.text(), texts[i]);
            ASSERT_TRUE(document.undo());
        }
        EXPECT_EQ(document.text(), first);
        EXPECT_FALSE(document.undo());
        for (std::size_t i = 1; i < texts.size(); ++i) {
            ASSERT_TRUE(document.redo());
            EXPECT_EQ(document.text(), texts[i]);
        }
        EXPECT_FALSE(document.redo());
    }
}

TEST(TextDocument, AWordThatIsTypedIsOneStep) {
    TextDocument document("cube(1);");
    for (const char* text : {"cube(12);", "cube(123);", "cube(12);"}) {
        document.set_text(text, "type", true);
    }
    EXPECT_EQ(document.steps(), 1U);
    document.pause();
    document.set_text("cube(124);", "type", true);
    document.set_text("cube(124); ", "type", true);
    EXPECT_EQ(document.steps(), 3U) << "elsewhere";
    EXPECT_EQ(document.undo_what(), "type");
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), "cube(12);");
    EXPECT_EQ(document.redo_what(), "type");
    document.edit({{{0, 4}, "sphere"}}, "change");
    EXPECT_EQ(document.redo_what(), "") << "another step takes their place";
}

TEST(TextDocument, WhatOthersWriteIsMerged) {
    using FromDisk = TextDocument::FromDisk;
    TextDocument document("cube(1);\nsphere(2);\n");
    EXPECT_EQ(document.take_from_disk("cube(1);\nsphere(2);\n"), FromDisk::Same);
    EXPECT_EQ(document.take_from_disk("cube(2);\nsphere(2);\n"), FromDisk::Taken);
    EXPECT_FALSE(document.unsaved());
    document.edit({{{5, 6}, "3"}}, "edit");
    EXPECT_EQ(document.take_from_disk("cube(2);\nsphere(4);\n"), FromDisk::Merged);
    EXPECT_EQ(document.text(), "cube(3);\nsphere(4);\n");
    EXPECT_TRUE(document.unsaved());
    EXPECT_EQ(document.take_from_disk("cube(9);\nsphere(4);\n"), FromDisk::Conflict);
    EXPECT_EQ(document.text(), "cube(3);\nsphere(4);\n") << "nothing is overwritten";
    ASSERT_EQ(document.conflicts().size(), 1U);
    EXPECT_EQ(document.conflicts()[0].theirs, "cube(9);\n");
    EXPECT_EQ(document.take_from_disk("cube(8);\nsphere(4);\n"), FromDisk::Conflict);
    ASSERT_EQ(document.conflicts().size(), 1U) << "it goes on as another";
    document.edit({{{0, 0}, "// new\n"}}, "edit");
    document.resolve(0, true);
    EXPECT_EQ(document.text(), "// new\ncube(8);\nsphere(4);\n");
    EXPECT_TRUE(document.conflicts().empty());
    while (document.undo()) {
    }
    EXPECT_EQ(document.text(), "cube(1);\nsphere(2);\n");
}

TEST(Recovery, KeepsWhatIsNotSaved) {
    const test_support::TemporaryFolder folder;
    const Recovery recovery(folder.path("kept"), "/home/me/a.scad");
    recovery.keep("old\n", "new\n");
    EXPECT_FALSE(recovery.left()) << "this process goes on";
    recovery.drop();
    EXPECT_TRUE(std::filesystem::is_empty(folder.path("kept")));
    Recovery({}, "/home/me/a.scad").keep("old", "new");
    EXPECT_FALSE(Recovery({}, "/home/me/a.scad").left());
}

/// Of texts that are kept one after the other there is always a whole one, no older than the last that was done.
TEST(Recovery, OutlivesAProgramThatIsKilledAtAnyMoment) {
    const test_support::TemporaryFolder folder;
    const Recovery recovery(folder.path("kept"), "/home/me/a.scad");
    std::mt19937 random(3);
    for (int kill_number = 0; kill_number < 100; ++kill_number) {
        int done[2];
        ASSERT_EQ(pipe(done), 0);
        const pid_t child = fork();
        if (child == 0) {
            for (char step = 0;; ++step) {
                recovery.keep("saved",
                              std::string(static_cast<std::size_t>(50'000 + step), static_cast<char>('a' + step % 26)));
                if (write(done[1], &step, 1) != 1) {
                    _exit(1);
                }
            }
        }
        close(done[1]);
        char first = 0;
        ASSERT_EQ(read(done[0], &first, 1), 1);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 4000));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        char last = first;
        while (read(done[0], &last, 1) == 1) {
        }
        close(done[0]);
        const auto left = recovery.left();
        ASSERT_TRUE(left);
        EXPECT_EQ(left->saved, "saved");
        const auto is = [&](char step) {
            return left->text ==
                   std::string(static_cast<std::size_t>(50'000 + step), static_cast<char>('a' + step % 26));
        };
        EXPECT_TRUE(is(last) || is(static_cast<char>(last + 1))) << "a step that was done is lost";
        Recovery::forget(*left);
        EXPECT_FALSE(recovery.left());
    }
}

}  // namespace
}  // namespace ui

// Evaluates programs that are given as text.
#pragma once

#include <map>
#include <string>

#include "csg/scad/program/program_cache.h"
#include "csg/scad/scad.h"

namespace test {

struct Run {
    csg::scad::Evaluation evaluation;
    std::string console;  ///< Line by line, as OpenSCAD prints it.
    std::string csg;      ///< The .csg text; empty where there is no tree.
};

/// The main file's name in messages.
inline constexpr const char* kMainFile = "case.scad";

/// `files`: what include and use find, by name. Nothing is read from disk.
[[nodiscard]] Run run(const std::string& text, const std::map<std::string, std::string>& files = {},
                      csg::scad::Request request = {});
/// The same with what `cache` keeps.
[[nodiscard]] Run run_kept(csg::scad::ProgramCache& cache, const std::string& text,
                           const std::map<std::string, std::string>& files = {}, csg::scad::Request request = {});

/// Fails where two runs differ in anything that one can see.
void expect_same(const Run& run, const Run& expected);

}  // namespace test

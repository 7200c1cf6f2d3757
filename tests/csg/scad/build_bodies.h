// Lazy bodies, built all at once.
#pragma once

#include "csg/scad/syntax/parser.h"

namespace test {

/// As many definitions as there are at the end: a body may define more.
inline void build_bodies(csg::scad::Program& program) {
    for (std::uint32_t f = 0; f < program.functions.size(); ++f) {
        csg::scad::build_function_body(program, f);
    }
    for (std::uint32_t m = 0; m < program.modules.size(); ++m) {
        csg::scad::build_module_body(program, m);
    }
}

}  // namespace test

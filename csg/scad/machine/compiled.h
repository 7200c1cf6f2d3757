// What runs of a program have found out about it, for the runs that come.
#pragma once

#include <deque>
#include <vector>

#include "csg/scad/machine/code_table.h"
#include "csg/scad/machine/resolver.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

/// What names mean, and the code of all that was evaluated: neither depends on what variables hold.
struct Compiled {
    /// Bodies of the program that are lazy are built when they are needed; nothing else of it changes. It must outlive
    /// this.
    explicit Compiled(Program& program);
    Compiled(const Compiled&) = delete;
    Compiled& operator=(const Compiled&) = delete;

    /// The main file's block has other assignments now, to variables of the same names.
    void redefine(const Program& program);

    Resolver resolver;
    std::vector<Value> strings;  ///< Literals by symbol, once they are used.
    std::deque<Code> codes;
    std::vector<const Code*> function_codes, literal_codes;  ///< Null until they are called.
    CodeTable statement_codes;

  private:
    const Argument* arguments_;  ///< Where the parameters of all code lie.
};

}  // namespace csg::scad

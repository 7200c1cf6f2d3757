// Bodies of definitions that have been read but not built. A library that is included defines a thousand functions and
// modules, of which a program calls a few: of the others it is enough to know that they are well formed.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "csg/scad/value/symbols.h"

namespace csg::scad {

/// A piece of source text: what follows the parameters of a definition.
struct LazyBody {
    std::uint32_t file = 0;  ///< Index into Program::sources.
    std::uint32_t begin = 0, end = 0;
    std::uint32_t line = 0, column = 0;  ///< Of `begin`.
};

/// Numbers of nodes of a syntax tree, by kind.
struct NodeCounts {
    std::size_t expressions = 0;
    std::size_t elements = 0;
    std::size_t arguments = 0;
    std::size_t assignments = 0;
    std::size_t functions = 0;
    std::size_t modules = 0;
    std::size_t instantiations = 0;
    std::size_t blocks = 0;
    std::size_t names = 0;  ///< Occurrences of names and strings.
};

struct LazyBodies {
    std::vector<LazyBody> bodies;
    NodeCounts most;  ///< What building them all may add at most.
    /// Of the calls of modules in them: the module, and the name of an argument that is no `$` variable.
    std::vector<std::pair<Symbol, Symbol>> passed;
};

}  // namespace csg::scad

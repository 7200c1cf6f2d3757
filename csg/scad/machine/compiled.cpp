#include "csg/scad/machine/compiled.h"

namespace csg::scad {

Compiled::Compiled(Program& program)
    : resolver(program),
      function_codes(program.functions.size() + program.lazy.most.functions, nullptr),
      arguments_(program.arguments.data()) {
    strings.reserve(program.symbols.size() + program.lazy.most.names);
}

void Compiled::redefine(const Program& program) {
    resolver.redefine();
    if (const std::size_t size = program.symbols.size() + program.lazy.most.names; strings.capacity() < size) {
        strings.reserve(size + size / 4);
    }
    if (arguments_ != program.arguments.data()) {
        arguments_ = program.arguments.data();
        for (Code& code : codes) {
            code.parameters = {arguments_ + code.first_parameter, code.parameters.size()};
        }
    }
}

}  // namespace csg::scad

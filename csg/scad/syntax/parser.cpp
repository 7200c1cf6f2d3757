#include "csg/scad/syntax/parser.h"

#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {

Parser::Parser(Files& files, UnitId unit, bool lazy)
    : files_(&files), program_(files.program()), unit_(unit), lazy_(lazy) {
    tokens_.emplace(files, program_.units[unit].file, unit);
}

namespace {

/// The unit's block, or kNone and a message.
BlockId parse_unit(Files& files, UnitId unit, bool lazy) {
    Parser parser(files, unit, lazy);
    try {
        return parser.unit();
    } catch (SyntaxError& error) {
        if (parser.at_piece()) {
            throw PieceMisfit();
        }
        report(files.sink(), {Severity::Error, error.where, std::move(error.text), true});
        return kNone;
    }
}

}  // namespace

void make_room(Program& program, bool again) {
    const NodeCounts& most = program.lazy.most;
    const auto keep_room = [again](auto& array, std::size_t more) {
        const std::size_t size = array.size() + more;
        if (more != 0 && size > array.capacity()) {
            array.reserve(again ? size + size / 4 : size);
        }
    };
    keep_room(program.expressions, most.expressions);
    keep_room(program.elements, most.elements);
    keep_room(program.arguments, most.arguments);
    keep_room(program.assignments, most.assignments);
    keep_room(program.functions, most.functions);
    keep_room(program.modules, most.modules);
    keep_room(program.instantiations, most.instantiations);
    keep_room(program.blocks, most.blocks);
}

Parsed parse(const ParseRequest& request) {
    Parsed parsed;
    Program& program = parsed.program;
    const MessageSink sink = [&](const Message& message) { parsed.messages.push_back(message); };
    Files files(request, program, sink);
    program.units[0].block = parse_unit(files, 0, request.lazy);
    parsed.ok = program.units[0].block != kNone;
    parsed.main_messages = parsed.messages.size();
    parsed.main_sources = program.sources.size();
    if (parsed.ok) {
        parsed.definitions = Definitions(program);
        parsed.ok = parsed.definitions.set(program, request.definitions, sink, &files);
        parsed.definition_messages = parsed.messages.size() - parsed.main_messages;
    }
    for (UnitId unit = 1; parsed.ok && unit < program.units.size(); ++unit) {  // Units bring in more units.
        program.units[unit].block = parse_unit(files, unit, request.lazy);
    }
    for (Unit& unit : program.units) {
        for (Use& use : unit.uses) {
            use.unit = use.unit != kNone && program.units[use.unit].block == kNone ? kNone : use.unit;
        }
    }
    make_room(program);
    return parsed;
}

void build_function_body(Program& program, std::uint32_t function) {
    const FunctionDefinition f = program.functions[function];
    if (f.lazy != kNone && f.body == kNone) {
        program.functions[function].body = Parser(program).function_body(program.lazy.bodies[f.lazy]);
    }
}

void build_module_body(Program& program, std::uint32_t module) {
    const ModuleDefinition m = program.modules[module];
    if (m.lazy != kNone && m.body == kNone) {
        const BlockId body = Parser(program).module_body(program.lazy.bodies[m.lazy]);
        program.modules[module].body = body;
    }
}

}  // namespace csg::scad

#include "csg/scad/parser.h"

#include "csg/scad/parser_impl.h"

namespace csg::scad {

Parser::Parser(Files& files, UnitId unit) : files_(files), program_(files.program()), unit_(unit) {
    tokens_.emplace(files, program_.units[unit].file, unit);
}

namespace {

/// The unit's block, or kNone and a message.
BlockId parse_unit(Files& files, UnitId unit, std::span<const std::string> definitions) {
    try {
        return Parser(files, unit).unit(definitions);
    } catch (SyntaxError& error) {
        report(files.sink(), {Severity::Error, error.where, std::move(error.text), true});
        return kNone;
    }
}

}  // namespace

Parsed parse(const ParseRequest& request) {
    Parsed parsed;
    Program& program = parsed.program;
    const MessageSink sink = [&](const Message& message) { parsed.messages.push_back(message); };
    Files files(request, program, sink);
    program.units[0].block = parse_unit(files, 0, request.definitions);
    parsed.ok = program.units[0].block != kNone;
    for (UnitId unit = 1; parsed.ok && unit < program.units.size(); ++unit) {  // Units bring in more units.
        program.units[unit].block = parse_unit(files, unit, {});
    }
    for (Unit& unit : program.units) {
        for (Use& use : unit.uses) {
            use.unit = use.unit != kNone && program.units[use.unit].block == kNone ? kNone : use.unit;
        }
    }
    return parsed;
}

}  // namespace csg::scad

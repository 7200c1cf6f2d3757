#include "csg/scad/syntax/piece.h"

#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {

std::shared_ptr<const Piece> make_piece(const SharedSource& file) {
    auto piece = std::make_shared<Piece>();
    piece->part.sources.add(file);
    bool silent = true;
    const MessageSink sink = [&silent](const Message&) { silent = false; };
    try {
        Parser(piece->part, 0, sink).piece(*piece);
    } catch (const SyntaxError&) {
        return nullptr;
    }
    return silent ? piece : nullptr;
}

PlacedPiece::PlacedPiece(const Piece& piece, Program& program, std::uint32_t file)
    : file_(file),
      expressions_(static_cast<std::uint32_t>(program.expressions.size())),
      elements_(static_cast<std::uint32_t>(program.elements.size())),
      arguments_(static_cast<std::uint32_t>(program.arguments.size())),
      assignments_(static_cast<std::uint32_t>(program.assignments.size())),
      functions_(static_cast<std::uint32_t>(program.functions.size())),
      modules_(static_cast<std::uint32_t>(program.modules.size())),
      instantiations_(static_cast<std::uint32_t>(program.instantiations.size())),
      blocks_(static_cast<std::uint32_t>(program.blocks.size())),
      bodies_(static_cast<std::uint32_t>(program.lazy.bodies.size())) {
    const SymbolTable& symbols = piece.part.symbols;
    symbols_.reserve(symbols.size());
    for (Symbol symbol = 0; symbol < symbols.size(); ++symbol) {
        symbols_.push_back(program.symbols.intern(symbols.text(symbol)));
    }
    add_nodes(piece.part, program);
    add_lazy(piece.part.lazy, program.lazy);
}

void PlacedPiece::add_nodes(const Program& part, Program& program) const {
    const auto add = [this](const auto& from, auto& to) {
        for (const auto& node : from) {
            to.push_back(placed(node));
        }
    };
    add(part.expressions, program.expressions);
    for (const ExprId element : part.elements) {
        program.elements.push_back(moved(element, expressions_));
    }
    add(part.arguments, program.arguments);
    add(part.assignments, program.assignments);
    add(part.functions, program.functions);
    add(part.modules, program.modules);
    add(part.instantiations, program.instantiations);
    add(part.blocks, program.blocks);
    for (const auto& [loop, update] : part.updates) {
        program.updates.emplace(loop + expressions_, moved(update, arguments_));
    }
    for (const auto& [assignment, first] : part.first_places) {
        program.first_places.emplace(assignment + assignments_, placed(first));
    }
}

void PlacedPiece::add_lazy(const LazyBodies& part, LazyBodies& lazy) const {
    for (LazyBody body : part.bodies) {
        body.file = file_;
        lazy.bodies.push_back(body);
    }
    lazy.most.expressions += part.most.expressions;
    lazy.most.elements += part.most.elements;
    lazy.most.arguments += part.most.arguments;
    lazy.most.assignments += part.most.assignments;
    lazy.most.functions += part.most.functions;
    lazy.most.modules += part.most.modules;
    lazy.most.instantiations += part.most.instantiations;
    lazy.most.blocks += part.most.blocks;
    lazy.most.names += part.most.names;
    for (const auto& [module, argument] : part.passed) {
        lazy.passed.emplace_back(placed(module), placed(argument));
    }
}

Expr PlacedPiece::placed(Expr e) const {
    e.name = placed(e.name);
    for (ExprId& operand : e.operands) {
        operand = moved(operand, expressions_);
    }
    switch (e.kind) {
        case ExprKind::Vector:
            e.list = moved(e.list, elements_);
            break;
        case ExprKind::Call:
        case ExprKind::Let:
        case ExprKind::Assert:
        case ExprKind::Echo:
        case ExprKind::Function:
        case ExprKind::ListFor:
        case ExprKind::ListForC:
        case ExprKind::ListLet:
            e.list = moved(e.list, arguments_);
            break;
        default:
            break;
    }
    e.where = placed(e.where);
    return e;
}

Argument PlacedPiece::placed(Argument a) const {
    return {placed(a.name), moved(a.value, expressions_), placed(a.where)};
}

FunctionDefinition PlacedPiece::placed(FunctionDefinition f) const {
    f.name = placed(f.name);
    f.parameters = moved(f.parameters, arguments_);
    f.body = moved(f.body, expressions_);
    f.lazy = moved(f.lazy, bodies_);
    f.where = placed(f.where);
    return f;
}

ModuleDefinition PlacedPiece::placed(ModuleDefinition m) const {
    m.name = placed(m.name);
    m.parameters = moved(m.parameters, arguments_);
    m.body = moved(m.body, blocks_);
    m.lazy = moved(m.lazy, bodies_);
    m.where = placed(m.where);
    return m;
}

Instantiation PlacedPiece::placed(Instantiation i) const {
    i.name = placed(i.name);
    i.arguments = moved(i.arguments, arguments_);
    i.children = moved(i.children, blocks_);
    i.otherwise = moved(i.otherwise, blocks_);
    i.where = placed(i.where);
    return i;
}

Block PlacedPiece::placed(Block b) const {
    b.assignments = moved(b.assignments, assignments_);
    b.functions = moved(b.functions, functions_);
    b.modules = moved(b.modules, modules_);
    b.instantiations = moved(b.instantiations, instantiations_);
    return b;
}

}  // namespace csg::scad

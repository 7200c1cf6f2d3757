#include "csg/scad/syntax/call_text.h"

#include <algorithm>
#include <utility>

namespace csg::scad {

namespace {

bool is_literal_text(const Program& program, const Expr& e) {
    return is_literal_kind(e.kind) ||
           (e.kind == ExprKind::Unary && e.op == Operator::Negate && program[e.operand(0)].kind == ExprKind::Number);
}

void add_values(std::span<const Argument> arguments, std::vector<ExprId>& left) {
    for (const Argument& a : arguments) {
        left.push_back(a.value);
    }
}

/// The expressions that one consists of, whatever its kind.
void add_parts(const Program& program, const Expr& e, std::vector<ExprId>& left) {
    left.insert(left.end(), e.operands.begin(), e.operands.end());
    switch (e.kind) {
        case ExprKind::Vector:
            left.insert(left.end(), program.elements_of(e).begin(), program.elements_of(e).end());
            break;
        case ExprKind::ListForC:
            add_values(program.update_of(e), left);
            [[fallthrough]];
        case ExprKind::Call:
        case ExprKind::Let:
        case ExprKind::Assert:
        case ExprKind::Echo:
        case ExprKind::Function:
        case ExprKind::ListFor:
        case ExprKind::ListLet:
            add_values(program.arguments_of(e), left);
            break;
        default:
            break;
    }
}

/// Calls `visit` with the expression and all that it consists of; it says whether to go into one.
template <typename Visit>
void walk(const Program& program, ExprId value, const Visit& visit) {
    std::vector<ExprId> left{value};
    while (!left.empty()) {
        const ExprId id = left.back();
        left.pop_back();
        if (id != kNone && visit(id)) {
            add_parts(program, program[id], left);
        }
    }
}

std::vector<LiteralText> literals_in(const Program& program, ExprId value, std::uint32_t file) {
    std::vector<LiteralText> literals;
    walk(program, value, [&](ExprId id) {
        const Expr& e = program[id];
        const bool literal = is_literal_text(program, e);
        if (literal && e.where.file == file) {
            literals.push_back({id, program.sources.bytes_of(e.where)});
        }
        return !literal;
    });
    std::sort(literals.begin(), literals.end(),
              [](const LiteralText& a, const LiteralText& b) { return a.bytes.begin < b.bytes.begin; });
    return literals;
}

/// Adds the names of variables in an expression, each once.
void add_names(const Program& program, ExprId value, std::vector<Symbol>& names) {
    walk(program, value, [&](ExprId id) {
        const Expr& e = program[id];
        if (e.kind == ExprKind::Identifier && std::find(names.begin(), names.end(), e.name) == names.end()) {
            names.push_back(e.name);
        }
        return true;
    });
}

/// Null where no call begins there.
const Instantiation* instantiation_at(const Program& program, const SourceLocation& place) {
    const auto found = std::find_if(program.instantiations.begin(), program.instantiations.end(),
                                    [&](const Instantiation& each) { return each.where.begin() == place; });
    return found == program.instantiations.end() ? nullptr : &*found;
}

void add_numbers(const Program& program, ExprId value, std::vector<LiteralText>& numbers) {
    for (const LiteralText& literal : literals_in(program, value, program.units[0].file)) {
        const ExprKind kind = program[literal.expression].kind;
        if (kind == ExprKind::Number || kind == ExprKind::Unary) {
            numbers.push_back(literal);
        }
    }
}

}  // namespace

std::vector<NumberSource> numbers_behind(const Program& program, const SourceLocation& place) {
    std::vector<NumberSource> sources;
    const Instantiation* const call = instantiation_at(program, place);
    if (call == nullptr) {
        return sources;
    }
    std::vector<Symbol> names;
    NumberSource own;
    for (const Argument& a : program.arguments_of(*call)) {
        add_numbers(program, a.value, own.numbers);
        add_names(program, a.value, names);
    }
    sources.push_back(std::move(own));
    const auto assignments = program.assignments_of(program.blocks[program.units[0].block]);
    for (std::size_t i = 0; i < names.size(); ++i) {  // Grows by the names in what they are assigned.
        for (const Argument& a : assignments) {
            if (a.name == names[i] && a.value != kNone && a.where.file == program.units[0].file) {
                NumberSource source{program.symbols.text(a.name), {}};
                add_numbers(program, a.value, source.numbers);
                add_names(program, a.value, names);
                sources.push_back(std::move(source));
            }
        }
    }
    std::erase_if(sources, [](const NumberSource& source) { return source.numbers.empty(); });
    return sources;
}

std::optional<CallText> call_at(const Program& program, const SourceLocation& place) {
    const Instantiation* const i = instantiation_at(program, place);
    if (i == nullptr) {
        return std::nullopt;
    }
    CallText call{place.file, program.symbols.text(i->name), program.sources.bytes_of(i->where), {}};
    for (const Argument& a : program.arguments_of(*i)) {
        const SourceRange& value = program[a.value].where;
        if (a.where.file != place.file || value.file != place.file) {
            return std::nullopt;
        }
        call.arguments.push_back({a.name == kNoSymbol ? std::string() : program.symbols.text(a.name),
                                  program.sources.bytes_of(a.where), program.sources.bytes_of(value),
                                  literals_in(program, a.value, place.file)});
    }
    return call;
}

std::optional<LiteralText> literal_at(const Program& program, std::uint32_t file, std::size_t offset) {
    std::optional<LiteralText> best;
    const SourceLocation place = program.sources[file].place(offset);
    for (ExprId id = 0; id < program.expressions.size(); ++id) {
        const Expr& e = program[id];
        const SourceRange& where = e.where;
        const bool around = where.file == file &&
                            std::pair(where.line, where.column) <= std::pair(place.line, place.column) &&
                            std::pair(place.line, place.column) <= std::pair(where.end_line, where.end_column);
        if (!around || !is_literal_text(program, e)) {
            continue;
        }
        const LiteralText literal{id, program.sources.bytes_of(where)};
        // Of a number and its sign the sign; of two that touch the one behind.
        if (!best || literal.bytes.begin >= best->bytes.end || literal.bytes.end > best->bytes.end ||
            literal.bytes.begin < best->bytes.begin) {
            best = literal;
        }
    }
    return best;
}

}  // namespace csg::scad

#include "csg/scad/text/expression_text.h"

#include "csg/scad/text/expression_writer.h"
#include "csg/scad/value/quoted.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

void ExpressionWriter::expression(ExprId id) {
    stack_.emplace_back(id);
    run();
}

void ExpressionWriter::arguments(std::span<const Argument> arguments) {
    later_arguments(arguments);
    stack_.insert(stack_.end(), gathered_.rbegin(), gathered_.rend());
    gathered_.clear();
    run();
}

void ExpressionWriter::run() {
    while (!stack_.empty()) {
        const Piece piece = stack_.back();
        stack_.pop_back();
        if (const auto* const text = std::get_if<std::string_view>(&piece)) {
            out_ += *text;
            continue;
        }
        write(std::get<ExprId>(piece));
        stack_.insert(stack_.end(), gathered_.rbegin(), gathered_.rend());
        gathered_.clear();
    }
}

void ExpressionWriter::literal(const Expr& e) {
    switch (e.kind) {
        case ExprKind::Boolean:
            out_ += e.number != 0 ? "true" : "false";
            break;
        case ExprKind::Number:
            out_ += number_text(e.number);
            break;
        case ExprKind::String:
            out_ += quoted(p_.symbols.text(e.name));
            break;
        case ExprKind::Identifier:
            out_ += p_.symbols.text(e.name);
            break;
        default:
            out_ += "undef";
    }
}

/// Gathers the pieces of an expression, or writes it where it has none.
void ExpressionWriter::write(ExprId id) {
    const Expr& e = p_[id];
    switch (e.kind) {
        case ExprKind::Undef:
        case ExprKind::Boolean:
        case ExprKind::Number:
        case ExprKind::String:
        case ExprKind::Identifier:
            literal(e);
            return;
        case ExprKind::Vector: {
            std::string_view separator = "[";
            for (const ExprId element : p_.elements_of(e)) {
                later(separator);
                later(element);
                separator = ", ";
            }
            later(e.list.count == 0 ? "[]" : "]");
            return;
        }
        case ExprKind::Range:
            later("[");
            later(e.operand(0));
            later(" : ");
            if (e.operand(1) != kNone) {
                later(e.operand(1));
                later(" : ");
            }
            later(e.operand(2));
            later("]");
            return;
        case ExprKind::Unary:
            later(operator_text(e.op));
            later(e.operand(0));
            return;
        case ExprKind::Binary:
            later("(");
            later(e.operand(0));
            later(" ");
            later(operator_text(e.op));
            later(" ");
            later(e.operand(1));
            later(")");
            return;
        case ExprKind::Conditional:
            later("(");
            later(e.operand(0));
            later(" ? ");
            later(e.operand(1));
            later(" : ");
            later(e.operand(2));
            later(")");
            return;
        case ExprKind::Call:
            if (p_[e.operand(0)].kind == ExprKind::Identifier) {
                later(e.operand(0));
            } else {
                later_body(e.operand(0));
            }
            later_call("", p_.arguments_of(e));
            return;
        case ExprKind::Index:
            later(e.operand(0));
            later("[");
            later(e.operand(1));
            later("]");
            return;
        case ExprKind::Member:
            later(e.operand(0));
            later(".");
            later(p_.symbols.text(e.name));
            return;
        case ExprKind::Let:
        case ExprKind::Assert:
        case ExprKind::Echo:
        case ExprKind::Function:
            later_call(e.kind == ExprKind::Let      ? "let"
                       : e.kind == ExprKind::Assert ? "assert"
                       : e.kind == ExprKind::Echo   ? "echo"
                                                    : "function",
                       p_.arguments_of(e));
            if (e.operand(0) != kNone) {
                later(" ");
                later(e.operand(0));
            }
            return;
        default:
            later_element(e);
    }
}

/// Elements of a list that give any number of values.
void ExpressionWriter::later_element(const Expr& e) {
    switch (e.kind) {
        case ExprKind::ListFor:
        case ExprKind::ListLet:
            later_call(e.kind == ExprKind::ListFor ? "for" : "let", p_.arguments_of(e));
            later(" ");
            later_body(e.operand(0));
            break;
        case ExprKind::ListForC:
            later("for(");
            later_arguments(p_.arguments_of(e));
            later(";");
            later(e.operand(1));
            later(";");
            later_arguments(p_.update_of(e));
            later(") ");
            later(e.operand(0));
            break;
        case ExprKind::ListIf:
            later("if(");
            later(e.operand(0));
            later(") ");
            later_body(e.operand(1));
            if (e.operand(2) != kNone) {
                later(" else ");
                later_body(e.operand(2));
            }
            break;
        default:
            later("each ");
            later_body(e.operand(0));
    }
}

void ExpressionWriter::later_body(ExprId id) {
    later("(");
    later(id);
    later(")");
}

void ExpressionWriter::later_call(std::string_view name, std::span<const Argument> arguments) {
    later(name);
    later("(");
    later_arguments(arguments);
    later(")");
}

void ExpressionWriter::later_arguments(std::span<const Argument> arguments) {
    std::string_view separator;
    for (const Argument& a : arguments) {
        later(separator);
        separator = ", ";
        if (a.name != kNoSymbol) {
            later(p_.symbols.text(a.name));
        }
        if (a.name != kNoSymbol && a.value != kNone) {
            later(" = ");
        }
        if (a.value != kNone) {
            later(a.value);
        }
    }
}

std::string expression_text(const Program& program, ExprId id) {
    std::string text;
    if (id != kNone) {
        ExpressionWriter(program, text).expression(id);
    }
    return text;
}

}  // namespace csg::scad

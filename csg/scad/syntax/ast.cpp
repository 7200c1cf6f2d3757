#include "csg/scad/syntax/ast.h"

#include <algorithm>

namespace csg::scad {

std::vector<std::string> Program::fonts() const {
    std::vector<std::string> files;
    for (const Unit& unit : units) {
        for (const Use& use : unit.uses) {
            if (use.font && std::find(files.begin(), files.end(), use.path) == files.end()) {
                files.push_back(use.path);
            }
        }
    }
    return files;
}

std::string_view operator_text(Operator op) {
    switch (op) {
        case Operator::None:
            return "";
        case Operator::Not:
            return "!";
        case Operator::Negate:
            return "-";
        case Operator::Plus:
            return "+";
        case Operator::BitNot:
            return "~";
        case Operator::Or:
            return "||";
        case Operator::And:
            return "&&";
        case Operator::Equal:
            return "==";
        case Operator::NotEqual:
            return "!=";
        case Operator::Less:
            return "<";
        case Operator::LessEqual:
            return "<=";
        case Operator::Greater:
            return ">";
        case Operator::GreaterEqual:
            return ">=";
        case Operator::BitOr:
            return "|";
        case Operator::BitAnd:
            return "&";
        case Operator::ShiftLeft:
            return "<<";
        case Operator::ShiftRight:
            return ">>";
        case Operator::Add:
            return "+";
        case Operator::Subtract:
            return "-";
        case Operator::Multiply:
            return "*";
        case Operator::Divide:
            return "/";
        case Operator::Modulo:
            return "%";
        case Operator::Power:
            return "^";
    }
    return "";
}

}  // namespace csg::scad

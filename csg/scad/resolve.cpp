// Blocks: what they declare, and what the names of modules in them mean.
#include "csg/scad/resolve.h"

#include <algorithm>

#include "csg/scad/builtin_modules.h"
#include "csg/scad/resolver.h"

namespace csg::scad {

std::uint32_t Resolution::dynamic_index(Symbol name) const {
    const auto found = std::find(dynamic_names.begin(), dynamic_names.end(), name);
    return found == dynamic_names.end() ? kNone : static_cast<std::uint32_t>(found - dynamic_names.begin());
}

bool declares_for_children(std::string_view name) {
    return name == "for" || name == "intersection_for" || name == "let" || name == "assign";
}

Resolver::Resolver(const Program& program) : p_(program) {
    r_.of_expression.assign(p_.expressions.size(), kNone);
    r_.argument_slots.assign(p_.arguments.size(), kNone);
    r_.repeated_parameters.assign(p_.arguments.size(), false);
    r_.assignment_slots.assign(p_.assignments.size(), kNone);
    r_.locals_of_function.assign(p_.functions.size(), 0);
    r_.module_of_instantiation.resize(p_.instantiations.size());
    r_.frame_slots.assign(p_.blocks.size(), kNone);
    r_.module_info.resize(p_.modules.size());
    for (const Instantiation& i : p_.instantiations) {
        for (const Argument& a : p_.arguments_of(i)) {
            if (a.name != kNoSymbol && !dynamic_name(a.name)) {
                passed_[i.name].insert(a.name);
            }
        }
    }
}

Resolution Resolver::run() {
    roots_.resize(p_.units.size());
    for (UnitId unit = 0; unit < p_.units.size(); ++unit) {
        if (p_.units[unit].block != kNone) {
            roots_[unit].unit = unit;
            declare(p_.units[unit].block, roots_[unit], nullptr, {}, true);
        }
    }
    for (UnitId unit = 0; unit < p_.units.size(); ++unit) {
        if (p_.units[unit].block != kNone) {
            resolve_block(p_.units[unit].block, roots_[unit]);
        }
    }
    number_constants();
    return std::move(r_);
}

void Resolver::number_constants() {
    std::vector<bool> constant(p_.expressions.size());  // Parts come before what they are part of.
    for (ExprId id = 0; id < p_.expressions.size(); ++id) {
        const Expr& e = p_[id];
        if (e.kind == ExprKind::Vector) {
            const auto elements = p_.elements_of(e);
            constant[id] = std::all_of(elements.begin(), elements.end(), [&](ExprId part) { return constant[part]; });
        } else {
            constant[id] = e.kind == ExprKind::Undef || e.kind == ExprKind::Boolean || e.kind == ExprKind::Number ||
                           e.kind == ExprKind::String;
        }
        if (constant[id] && e.kind == ExprKind::Vector) {
            r_.of_expression[id] = r_.constants++;
        }
    }
}

std::uint32_t Resolver::dynamic(Symbol name) {
    const auto [at, is_new] = dynamic_.try_emplace(name, static_cast<std::uint32_t>(r_.dynamic_names.size()));
    if (is_new) {
        r_.dynamic_names.push_back(name);
    }
    return at->second;
}

void Resolver::declare(BlockId id, BlockScope& scope, const BlockScope* outer, std::span<const Argument> extra,
                       bool root) {
    const Block& block = p_.blocks[id];
    scope.outer = outer;
    const auto slot_of = [&](Symbol name) {
        return dynamic_name(name)
                   ? dynamic(name)
                   : scope.variables.try_emplace(name, static_cast<std::uint32_t>(scope.variables.size()))
                         .first->second;
    };
    for (const Argument& a : extra) {
        if (a.name != kNoSymbol) {
            r_.argument_slots[index_of(a)] = slot_of(a.name);
        }
    }
    for (const Argument& a : p_.assignments_of(block)) {
        r_.assignment_slots[static_cast<std::size_t>(&a - p_.assignments.data())] = slot_of(a.name);
    }
    for (std::uint32_t i = 0; i < block.functions.count; ++i) {
        scope.functions[p_.functions[block.functions.first + i].name] = block.functions.first + i;
    }
    for (std::uint32_t i = 0; i < block.modules.count; ++i) {
        scope.modules[p_.modules[block.modules.first + i].name] = block.modules.first + i;
    }
    scope.framed = root || !scope.variables.empty() || !scope.functions.empty() || !scope.modules.empty();
    if (scope.framed) {
        r_.frame_slots[id] = static_cast<std::uint32_t>(scope.variables.size());
    }
}

void Resolver::resolve_block(BlockId id, const BlockScope& scope) {
    const Block& block = p_.blocks[id];
    block_ = &scope;
    for (const Argument& a : p_.assignments_of(block)) {
        statement_expression(a.value);
    }
    for (const FunctionDefinition& f : p_.functions_of(block)) {
        Activation activation;
        resolve_function(p_.parameters_of(f), f.body, activation);
        r_.locals_of_function[static_cast<std::size_t>(&f - p_.functions.data())] = activation.most;
    }
    for (const ModuleDefinition& m : p_.modules_of(block)) {
        for (const Argument& a : p_.parameters_of(m)) {
            statement_expression(a.value);
        }
        mark_repeated(p_.parameters_of(m));
        BlockScope body;
        declare(m.body, body, &scope, p_.parameters_of(m), false);
        look_into(m, body);
        resolve_block(m.body, body);
        block_ = &scope;
    }
    for (const Instantiation& i : p_.instantiations_of(block)) {
        resolve_instantiation(i, scope);
    }
}

void Resolver::mark_repeated(std::span<const Argument> parameters) {
    for (std::size_t i = 1; i < parameters.size(); ++i) {
        r_.repeated_parameters[index_of(parameters[i])] =
            std::any_of(parameters.begin(), parameters.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Argument& before) { return before.name == parameters[i].name; });
    }
}

void Resolver::look_into(const ModuleDefinition& m, BlockScope& body) {
    ModuleInfo& info = r_.module_info[static_cast<std::size_t>(&m - p_.modules.data())];
    const auto parameters = p_.parameters_of(m);
    const auto is_parameter = [&](Symbol name) {
        return std::any_of(parameters.begin(), parameters.end(), [&](const Argument& p) { return p.name == name; });
    };
    if (const auto passed = passed_.find(m.name); passed != passed_.end()) {
        for (const Symbol name : passed->second) {
            if (!is_parameter(name)) {
                const auto slot = body.variables.try_emplace(name, static_cast<std::uint32_t>(body.variables.size()));
                info.other_arguments.emplace_back(name, slot.first->second);
            }
        }
        body.framed |= !body.variables.empty();
        if (body.framed) {
            r_.frame_slots[m.body] = static_cast<std::uint32_t>(body.variables.size());
        }
    }
    for (const Argument& a : p_.assignments_of(p_.blocks[m.body])) {
        if (is_parameter(a.name) && is_literal(a.value)) {
            info.literal_parameters.push_back(static_cast<std::uint32_t>(&a - p_.assignments.data()));
        }
    }
}

bool Resolver::is_literal(ExprId id) const {
    const Expr& e = p_[id];
    switch (e.kind) {
        case ExprKind::Undef:
        case ExprKind::Boolean:
        case ExprKind::Number:
        case ExprKind::String:
            return true;
        case ExprKind::Unary:
            return p_[e.operand(0)].kind == ExprKind::Number;
        default:
            return false;
    }
}

void Resolver::resolve_instantiation(const Instantiation& first, const BlockScope& scope) {
    const Instantiation* i = &first;
    for (;;) {
        resolve_head_and_children(*i, scope);
        if (i->otherwise == kNone) {
            return;
        }
        const Block& otherwise = p_.blocks[i->otherwise];
        if (!p_.is_else_if(otherwise)) {
            BlockScope inner;
            declare(i->otherwise, inner, &scope, {}, false);
            resolve_block(i->otherwise, inner);
            block_ = &scope;
            return;
        }
        i = &p_.instantiations_of(otherwise)[0];  // Such chains may be long: no scope, no stack.
    }
}

void Resolver::resolve_head_and_children(const Instantiation& i, const BlockScope& scope) {
    block_ = &scope;
    ModuleTarget& target = r_.module_of_instantiation[static_cast<std::size_t>(&i - p_.instantiations.data())];
    target.user = i.is_if ? DefinitionRef{} : find_module(i.name);
    target.builtin = target.user.id == kNone ? find_builtin_module(p_.symbols.text(i.name)) : nullptr;
    const bool declares = !i.is_if && declares_for_children(p_.symbols.text(i.name));
    BlockScope children;
    if (i.children != kNone) {
        declare(i.children, children, &scope, declares ? p_.arguments_of(i) : std::span<const Argument>(), false);
    }
    // A later variable of for or let may use an earlier one: they are worked out inside the children's frame.
    block_ = declares && i.children != kNone ? &children : &scope;
    for (const Argument& a : p_.arguments_of(i)) {
        statement_expression(a.value);
        if (!declares && a.name != kNoSymbol && dynamic_name(a.name)) {
            r_.argument_slots[index_of(a)] = dynamic(a.name);
        }
    }
    if (i.children != kNone) {
        resolve_block(i.children, children);
    }
    block_ = &scope;
}

DefinitionRef Resolver::find_definition(Symbol name, Names BlockScope::*table) const {
    std::uint32_t hops = 0;
    for (const BlockScope* s = block_; s != nullptr; s = s->outer) {
        if (const DefinitionRef found = definition_in(*s, name, table, hops); found.id != kNone) {
            return found;
        }
        hops += s->framed;
    }
    return {};
}

DefinitionRef Resolver::definition_in(const BlockScope& s, Symbol name, Names BlockScope::*table,
                                      std::uint32_t hops) const {
    if (const auto found = (s.*table).find(name); found != (s.*table).end()) {
        return {found->second, hops, kNone};
    }
    if (s.unit != kNone) {
        const auto& uses = p_.units[s.unit].uses;
        for (auto at = uses.rbegin(); at != uses.rend(); ++at) {  // Of several files the last counts.
            const Use& use = *at;
            if (use.unit == kNone || use.unit == s.unit) {
                continue;
            }
            const auto& used = roots_[use.unit].*table;
            if (const auto found = used.find(name); found != used.end()) {
                return {found->second, kUsedUnit, use.unit};
            }
        }
    }
    return {};
}

Resolution resolve(const Program& program) {
    return Resolver(program).run();
}

}  // namespace csg::scad

// Blocks: what they declare, and what the names of modules in them mean.
#include "csg/scad/machine/resolve.h"

#include <algorithm>

#include "csg/scad/builtin/builtin_modules.h"
#include "csg/scad/machine/resolver.h"
#include "csg/scad/syntax/parser.h"

namespace csg::scad {

bool declares_for_children(std::string_view name) {
    return name == "for" || name == "intersection_for" || name == "let" || name == "assign";
}

Resolver::Resolver(Program& program) : p_(program) {
    reserve();
    number_dynamic_names();
    unit_known_.assign(p_.units.size(), false);
    roots_.resize(p_.units.size());
    for (UnitId unit = 0; unit < p_.units.size(); ++unit) {
        if (p_.units[unit].block == kNone) {
            continue;
        }
        roots_[unit].unit = unit;
        declare(p_.units[unit].block, roots_[unit], nullptr, {}, true);
        const Block& block = p_.blocks[p_.units[unit].block];
        std::fill_n(unit_of_function_.begin() + block.functions.first, block.functions.count, unit);
        std::fill_n(unit_of_module_.begin() + block.modules.first, block.modules.count, unit);
    }
    need_unit(0);
    if (p_.units[0].block != kNone) {
        resolve_instantiations(p_.blocks[p_.units[0].block], roots_[0]);
    }
}

void Resolver::reserve() {
    const NodeCounts& more = p_.lazy.most;
    const auto keep_room = [](auto& table, std::size_t size) {
        if (table.capacity() < size) {
            table.reserve(table.empty() ? size : size + size / 4);  // Again: there may be more such.
        }
    };
    keep_room(r_.of_expression, p_.expressions.size() + more.expressions);
    keep_room(r_.argument_slots, p_.arguments.size() + more.arguments);
    keep_room(r_.repeated_parameters, p_.arguments.size() + more.arguments);
    keep_room(r_.assignment_slots, p_.assignments.size() + more.assignments);
    keep_room(r_.locals_of_function, p_.functions.size() + more.functions);
    keep_room(r_.module_of_instantiation, p_.instantiations.size() + more.instantiations);
    keep_room(r_.frame_slots, p_.blocks.size() + more.blocks);
    keep_room(r_.module_info, p_.modules.size() + more.modules);
    keep_room(r_.dynamic_of_symbol, p_.symbols.size() + more.names);
}

void Resolver::number_dynamic_names() {
    const auto known = static_cast<Symbol>(r_.dynamic_of_symbol.size());
    grow();
    for (Symbol symbol = known; symbol < p_.symbols.size(); ++symbol) {
        if (p_.symbols.text(symbol).starts_with('$')) {
            r_.dynamic_of_symbol[symbol] = r_.dynamics++;
        }
    }
}

void Resolver::redefine() {
    reserve();
    number_dynamic_names();
    const Block& block = p_.blocks[p_.units[0].block];
    for (const Argument& a : p_.assignments_of(block)) {
        const auto variable = roots_[0].variables.find(a.name);
        r_.assignment_slots[static_cast<std::size_t>(&a - p_.assignments.data())] =
            dynamic_name(a.name) ? dynamic(a.name) : variable->second;
    }
    resolve_main_assignments();
}

/// Those whose value has not been seen yet.
void Resolver::resolve_main_assignments() {
    block_ = &roots_[0];
    for (const Argument& a : p_.assignments_of(p_.blocks[p_.units[0].block])) {
        if (main_values_.insert(a.value).second) {
            statement_expression(a.value);
        }
    }
}

/// No new symbol is a `$` name: those of lazy bodies are known from the start.
void Resolver::grow() {
    r_.of_expression.resize(p_.expressions.size(), kNone);
    r_.argument_slots.resize(p_.arguments.size(), kNone);
    r_.repeated_parameters.resize(p_.arguments.size(), false);
    r_.assignment_slots.resize(p_.assignments.size(), kNone);
    r_.locals_of_function.resize(p_.functions.size(), 0);
    r_.module_of_instantiation.resize(p_.instantiations.size());
    r_.frame_slots.resize(p_.blocks.size(), kNone);
    r_.module_info.resize(p_.modules.size());
    r_.dynamic_of_symbol.resize(p_.symbols.size(), kNone);
    function_known_.resize(p_.functions.size(), false);
    module_known_.resize(p_.modules.size(), false);
    unit_of_function_.resize(p_.functions.size(), kNone);
    unit_of_module_.resize(p_.modules.size(), kNone);
}

void Resolver::gather_passed() {
    passed_known_ = true;
    passed_ = p_.lazy.passed;
    for (const Instantiation& i : p_.instantiations) {
        for (const Argument& a : p_.arguments_of(i)) {
            if (a.name != kNoSymbol && !dynamic_name(a.name)) {
                passed_.emplace_back(i.name, a.name);
            }
        }
    }
    std::sort(passed_.begin(), passed_.end());
    passed_.erase(std::unique(passed_.begin(), passed_.end()), passed_.end());
}

void Resolver::need_unit(UnitId unit) {
    if (!unit_known_[unit] && p_.units[unit].block != kNone) {
        unit_known_[unit] = true;
        if (unit == 0) {
            resolve_main_assignments();
        } else {
            resolve_assignments(p_.blocks[p_.units[unit].block], roots_[unit]);
        }
    }
}

void Resolver::resolve_top_function(std::uint32_t id) {
    build_function_body(p_, id);
    grow();
    resolve_definition(p_.functions[id], roots_[unit_of_function_[id]]);
}

void Resolver::resolve_top_module(std::uint32_t id) {
    build_module_body(p_, id);
    grow();
    resolve_definition(p_.modules[id], roots_[unit_of_module_[id]]);
}

void Resolver::mark_constant(ExprId list) {
    const auto elements = p_.elements_of(p_[list]);
    const bool constant = std::all_of(elements.begin(), elements.end(), [&](ExprId part) {
        return is_simple_literal(p_, part) || (p_[part].kind == ExprKind::Vector && r_.of_expression[part] != kNone);
    });
    if (constant) {
        r_.of_expression[list] = 0;
    }
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

void Resolver::resolve_assignments(const Block& block, const BlockScope& scope) {
    block_ = &scope;
    for (const Argument& a : p_.assignments_of(block)) {
        statement_expression(a.value);
    }
}

void Resolver::resolve_instantiations(const Block& block, const BlockScope& scope) {
    for (const Instantiation& i : p_.instantiations_of(block)) {
        resolve_instantiation(i, scope);
    }
}

void Resolver::resolve_block(BlockId id, const BlockScope& scope) {
    const Block& block = p_.blocks[id];
    resolve_assignments(block, scope);
    for (const FunctionDefinition& f : p_.functions_of(block)) {
        resolve_definition(f, scope);
    }
    for (const ModuleDefinition& m : p_.modules_of(block)) {
        resolve_definition(m, scope);
    }
    block_ = &scope;
    resolve_instantiations(block, scope);
}

void Resolver::resolve_definition(const FunctionDefinition& f, const BlockScope& scope) {
    const auto id = static_cast<std::size_t>(&f - p_.functions.data());
    block_ = &scope;
    function_known_[id] = true;
    Activation activation;
    resolve_function(p_.parameters_of(f), f.body, activation);
    r_.locals_of_function[id] = activation.most;
}

void Resolver::resolve_definition(const ModuleDefinition& m, const BlockScope& scope) {
    block_ = &scope;
    module_known_[static_cast<std::size_t>(&m - p_.modules.data())] = true;
    for (const Argument& a : p_.parameters_of(m)) {
        statement_expression(a.value);
    }
    mark_repeated(p_.parameters_of(m));
    BlockScope body;
    declare(m.body, body, &scope, p_.parameters_of(m), false);
    look_into(m, body);
    resolve_block(m.body, body);
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
    if (!passed_known_) {
        gather_passed();
    }
    const auto first = std::lower_bound(passed_.begin(), passed_.end(), std::pair(m.name, Symbol{0}));
    if (first != passed_.end() && first->first == m.name) {
        for (auto passed = first; passed != passed_.end() && passed->first == m.name; ++passed) {
            const Symbol name = passed->second;
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
        if (is_parameter(a.name) && is_simple_literal(p_, a.value)) {
            info.literal_parameters.push_back(static_cast<std::uint32_t>(&a - p_.assignments.data()));
        }
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

}  // namespace csg::scad

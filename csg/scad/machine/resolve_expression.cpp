// Expressions: what the names of variables and functions in them mean.
#include <algorithm>

#include "csg/scad/machine/resolver.h"

namespace csg::scad {

void Resolver::statement_expression(ExprId e) {
    if (e != kNone) {
        Activation activation;
        activation_ = &activation;
        resolve_expression(e);
        activation_ = nullptr;
        r_.statement_locals = std::max(r_.statement_locals, activation.most);
    }
}

void Resolver::resolve_function(std::span<const Argument> parameters, ExprId body, Activation& activation) {
    Activation* const before = activation_;
    activation_ = &activation;
    for (const Argument& a : parameters) {
        r_.argument_slots[index_of(a)] = dynamic_name(a.name) ? dynamic(a.name) : 0;
        activation.reserve();  // Every parameter has a slot of its number, used or not.
    }
    for (const Argument& a : parameters) {  // Defaults see the surroundings, not the parameters.
        if (a.value != kNone) {
            resolve_expression(a.value);
        }
    }
    mark_repeated(parameters);
    std::uint32_t slot = 0;
    for (const Argument& a : parameters) {
        if (!dynamic_name(a.name)) {
            r_.argument_slots[index_of(a)] = slot;
            activation.locals.push_back({a.name, slot, false});
        }
        ++slot;
    }
    if (body != kNone) {
        resolve_expression(body);
    }
    activation_ = before;
}

void Resolver::call_arguments(const Expr& e) {
    for (const Argument& a : p_.arguments_of(e)) {
        resolve_expression(a.value);
        if (a.name != kNoSymbol && dynamic_name(a.name)) {
            r_.argument_slots[index_of(a)] = dynamic(a.name);
        }
    }
}

void Resolver::bind(std::span<const Argument> arguments) {
    Activation& act = *activation_;
    const std::size_t first = act.locals.size();
    for (const Argument& a : arguments) {
        if (a.name == kNoSymbol) {
            continue;
        }
        const auto before = std::find_if(act.locals.begin() + static_cast<std::ptrdiff_t>(first), act.locals.end(),
                                         [&](const Activation::Local& l) { return l.name == a.name; });
        if (dynamic_name(a.name)) {
            r_.argument_slots[index_of(a)] = dynamic(a.name);
        } else if (before != act.locals.end()) {
            r_.argument_slots[index_of(a)] = before->slot;
        } else {
            r_.argument_slots[index_of(a)] = act.reserve();
            act.locals.push_back({a.name, r_.argument_slots[index_of(a)], true});
        }
    }
    for (const Argument& a : arguments) {
        resolve_expression(a.value);
        for (std::size_t i = first; i < act.locals.size(); ++i) {
            act.locals[i].pending &= act.locals[i].name != a.name;
        }
    }
}

void Resolver::resolve_expression(ExprId id) {
    while (id != kNone) {
        id = resolve_one(id);
    }
}

ExprId Resolver::resolve_one(ExprId id) {
    const Expr& e = p_[id];
    Activation& act = *activation_;
    switch (e.kind) {
        case ExprKind::Identifier:
            r_.of_expression[id] = add(find_variable(e.name));
            return kNone;
        case ExprKind::Vector:
            for (const ExprId element : p_.elements_of(e)) {
                resolve_expression(element);
            }
            mark_constant(id);
            return kNone;
        case ExprKind::Call:
            call_arguments(e);
            if (p_[e.operand(0)].kind == ExprKind::Identifier) {
                r_.of_expression[id] = find_call(p_[e.operand(0)].name);
                return kNone;
            }
            return e.operand(0);
        case ExprKind::Assert:
        case ExprKind::Echo:
            call_arguments(e);
            return e.operand(0);
        case ExprKind::Let:
        case ExprKind::ListLet:
        case ExprKind::ListFor:
        case ExprKind::ListForC: {
            const std::size_t visible = act.locals.size();
            const std::uint32_t used = act.used;
            bind(p_.arguments_of(e));
            if (e.kind == ExprKind::ListForC) {
                carry_in(id, visible);
                resolve_expression(e.operand(1));
                resolve_expression(e.operand(0));
                bind_update(p_.update_of(e), visible);
            } else {
                resolve_expression(e.operand(0));
            }
            act.locals.resize(visible);
            act.used = used;
            return kNone;
        }
        case ExprKind::Function:
            resolve_literal(id, e);
            return kNone;
        case ExprKind::Conditional:
        case ExprKind::ListIf:
            resolve_expression(e.operand(0));
            resolve_expression(e.operand(1));
            return e.operand(2);
        default:
            resolve_expression(e.operand(1));
            resolve_expression(e.operand(2));
            return e.operand(0);
    }
}

void Resolver::carry_in(ExprId loop, std::size_t first) {
    Activation& act = *activation_;
    std::vector<CarriedVariable> carried;
    for (const Argument& a : p_.update_of(p_[loop])) {
        const bool own = std::any_of(act.locals.begin() + static_cast<std::ptrdiff_t>(first), act.locals.end(),
                                     [&](const Activation::Local& l) { return l.name == a.name; });
        if (a.name != kNoSymbol && !dynamic_name(a.name) && !own) {
            const std::uint32_t outer = add(find_variable(a.name));
            carried.push_back({act.reserve(), outer});
            act.locals.push_back({a.name, carried.back().slot, false});
        }
    }
    if (!carried.empty()) {
        r_.of_expression[loop] = static_cast<std::uint32_t>(r_.carried.size());
        r_.carried.push_back(std::move(carried));
    }
}

void Resolver::bind_update(std::span<const Argument> update, std::size_t first) {
    Activation& act = *activation_;
    for (const Argument& a : update) {
        resolve_expression(a.value);
        if (a.name == kNoSymbol) {
            continue;
        }
        std::uint32_t slot = kNone;
        for (std::size_t i = first; i < act.locals.size(); ++i) {
            slot = act.locals[i].name == a.name ? act.locals[i].slot : slot;
        }
        r_.argument_slots[index_of(a)] = dynamic_name(a.name) ? dynamic(a.name) : slot;
    }
}

void Resolver::resolve_literal(ExprId id, const Expr& e) {
    LiteralInfo info;
    Activation activation;
    activation.outer = activation_;
    activation.literal = &info;
    resolve_function(p_.arguments_of(e), e.operand(0), activation);
    info.locals = activation.most;
    const auto parameters = p_.arguments_of(e);
    for (std::uint32_t i = 0; i < parameters.size(); ++i) {
        if (p_.symbols.text(parameters[i].name) == "this") {
            info.this_parameter = i;
        }
    }
    r_.of_expression[id] = static_cast<std::uint32_t>(r_.literals.size());
    r_.literals.push_back(std::move(info));
}

std::uint32_t Resolver::add(VariableRef ref) {
    r_.variables.push_back(ref);
    return static_cast<std::uint32_t>(r_.variables.size() - 1);
}

VariableRef Resolver::find_local(Activation& act, Symbol name, bool from_literal) {
    for (auto l = act.locals.rbegin(); l != act.locals.rend(); ++l) {
        if (l->name == name && (!l->pending || from_literal)) {
            return {Place::Local, l->pending, l->slot, kNone};
        }
    }
    if (act.literal == nullptr) {
        return {};
    }
    const auto known = std::find(act.capture_names.begin(), act.capture_names.end(), name);
    const auto slot = static_cast<std::uint32_t>(known - act.capture_names.begin());
    if (known == act.capture_names.end()) {
        const VariableRef from = act.outer == nullptr ? VariableRef{} : find_local(*act.outer, name, true);
        if (from.place == Place::Unknown) {
            return {};
        }
        act.capture_names.push_back(name);
        act.literal->captures.push_back({from.place == Place::Capture, from.hops != 0, from.slot});
        r_.late_captures |= from.hops != 0;
    }
    return {Place::Capture, 0, slot, kNone};
}

VariableRef Resolver::find_variable(Symbol name) {
    if (p_.symbols.text(name) == "$children") {
        return {Place::Children, 0, 0, kNone};
    }
    if (dynamic_name(name)) {
        return {Place::Dynamic, 0, dynamic(name), kNone};
    }
    if (activation_ != nullptr) {
        if (const VariableRef local = find_local(*activation_, name, false); local.place != Place::Unknown) {
            return local;
        }
    }
    std::uint32_t hops = 0;
    return find_in_blocks(name, block_, hops);
}

VariableRef Resolver::find_in_blocks(Symbol name, const BlockScope* s, std::uint32_t hops) {
    for (; s != nullptr; s = s->outer) {
        if (const auto found = s->variables.find(name); found != s->variables.end()) {
            const VariableRef further = find_in_blocks(name, s->outer, hops + s->framed);
            return {Place::Block, hops, found->second, further.place == Place::Unknown ? kNone : add(further)};
        }
        hops += s->framed;
    }
    return {p_.symbols.text(name) == "PI" ? Place::Pi : Place::Unknown, 0, 0, kNone};
}

std::uint32_t Resolver::find_call(Symbol name) {
    std::vector<CallTarget> targets;
    if (activation_ != nullptr && !dynamic_name(name)) {
        if (const VariableRef local = find_local(*activation_, name, false); local.place != Place::Unknown) {
            targets.push_back({CallTarget::Kind::Variable, local, {}, nullptr, {}, kNone});
        }
    }
    if (dynamic_name(name)) {
        targets.push_back(
            {CallTarget::Kind::Variable, {Place::Dynamic, 0, dynamic(name), kNone}, {}, nullptr, {}, kNone});
    }
    std::uint32_t hops = 0;
    bool certain = false;
    for (const BlockScope* s = block_; s != nullptr && !certain; s = s->outer) {
        if (const DefinitionRef f = definition_in(*s, name, &BlockScope::functions, hops); f.id != kNone) {
            targets.push_back({CallTarget::Kind::Function, {}, f, nullptr, {}, kNone});
            certain = true;
        } else if (const auto v = s->variables.find(name); v != s->variables.end()) {
            targets.push_back(
                {CallTarget::Kind::Variable, {Place::Block, hops, v->second, kNone}, {}, nullptr, {}, kNone});
        }
        hops += s->framed;
    }
    if (!certain) {
        const BuiltinFunction builtin = find_builtin_function(p_.symbols.text(name));
        targets.push_back({builtin == nullptr ? CallTarget::Kind::Unknown : CallTarget::Kind::Builtin,
                           {},
                           {},
                           builtin,
                           p_.symbols.text(name),
                           kNone});
    }
    const auto first = static_cast<std::uint32_t>(r_.calls.size());
    for (std::uint32_t i = 0; i < targets.size(); ++i) {
        targets[i].next = i + 1 < targets.size() ? first + i + 1 : kNone;
        r_.calls.push_back(targets[i]);
    }
    return first;
}

}  // namespace csg::scad

#include "csg/scad/resolve.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "csg/scad/builtin_modules.h"

namespace csg::scad {

std::uint32_t Resolution::dynamic_index(Symbol name) const {
    const auto found = std::find(dynamic_names.begin(), dynamic_names.end(), name);
    return found == dynamic_names.end() ? kNone : static_cast<std::uint32_t>(found - dynamic_names.begin());
}

bool declares_for_children(std::string_view name) {
    return name == "for" || name == "intersection_for" || name == "let" || name == "assign";
}

namespace {

/// A block while it is resolved, and what it declares.
struct BlockScope {
    const BlockScope* outer = nullptr;
    bool framed = false;
    UnitId unit = kNone;  ///< For the root block of a unit.
    std::unordered_map<Symbol, std::uint32_t> variables;
    std::unordered_map<Symbol, std::uint32_t> functions;
    std::unordered_map<Symbol, std::uint32_t> modules;
};

/// The locals of a function, a literal, or the expression of a statement.
struct Activation {
    struct Local {
        Symbol name;
        std::uint32_t slot;
        bool pending;  // Its value is being worked out; only literals see it.
    };
    Activation* outer = nullptr;  ///< Around a literal.
    LiteralInfo* literal = nullptr;
    std::vector<Symbol> capture_names;
    std::vector<Local> locals;  ///< Visible ones, the innermost last.
    std::uint32_t used = 0;
    std::uint32_t most = 0;

    std::uint32_t reserve() {
        most = std::max(most, used + 1);
        return used++;
    }
};

class Resolver {
  public:
    Resolver(const Program& program, std::span<const Symbol> always_dynamic) : p_(program) {
        r_.of_expression.assign(p_.expressions.size(), kNone);
        r_.argument_slots.assign(p_.arguments.size(), kNone);
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
        for (const Symbol name : always_dynamic) {
            dynamic(name);
        }
    }

    Resolution run() {
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

  private:
    /// Lists of constants are made once.
    void number_constants() {
        std::vector<bool> constant(p_.expressions.size());  // Parts come before what they are part of.
        for (ExprId id = 0; id < p_.expressions.size(); ++id) {
            const Expr& e = p_[id];
            if (e.kind == ExprKind::Vector) {
                const auto elements = p_.elements_of(e);
                constant[id] =
                    std::all_of(elements.begin(), elements.end(), [&](ExprId part) { return constant[part]; });
            } else {
                constant[id] = e.kind == ExprKind::Undef || e.kind == ExprKind::Boolean || e.kind == ExprKind::Number ||
                               e.kind == ExprKind::String;
            }
            if (constant[id] && e.kind == ExprKind::Vector) {
                r_.of_expression[id] = r_.constants++;
            }
        }
    }

    std::uint32_t index_of(const Argument& a) const { return static_cast<std::uint32_t>(&a - p_.arguments.data()); }

    std::uint32_t dynamic(Symbol name) {
        const auto [at, is_new] = dynamic_.try_emplace(name, static_cast<std::uint32_t>(r_.dynamic_names.size()));
        if (is_new) {
            r_.dynamic_names.push_back(name);
        }
        return at->second;
    }

    bool dynamic_name(Symbol name) const { return is_dynamic(p_.symbols.text(name)); }

    void declare(BlockId id, BlockScope& scope, const BlockScope* outer, std::span<const Argument> extra, bool root) {
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

    void resolve_block(BlockId id, const BlockScope& scope) {
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

    /// What calls of a module need to know besides its parameters.
    void look_into(const ModuleDefinition& m, BlockScope& body) {
        ModuleInfo& info = r_.module_info[static_cast<std::size_t>(&m - p_.modules.data())];
        const auto parameters = p_.parameters_of(m);
        const auto is_parameter = [&](Symbol name) {
            return std::any_of(parameters.begin(), parameters.end(), [&](const Argument& p) { return p.name == name; });
        };
        if (const auto passed = passed_.find(m.name); passed != passed_.end()) {
            for (const Symbol name : passed->second) {
                if (!is_parameter(name)) {
                    const auto slot =
                        body.variables.try_emplace(name, static_cast<std::uint32_t>(body.variables.size()));
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

    [[nodiscard]] bool is_literal(ExprId id) const {
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

    void resolve_instantiation(const Instantiation& first, const BlockScope& scope) {
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

    void resolve_head_and_children(const Instantiation& i, const BlockScope& scope) {
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

    DefinitionRef find_module(Symbol name) const { return find_definition(name, &BlockScope::modules); }

    DefinitionRef find_definition(Symbol name, std::unordered_map<Symbol, std::uint32_t> BlockScope::*table) const {
        std::uint32_t hops = 0;
        for (const BlockScope* s = block_; s != nullptr; s = s->outer) {
            if (const DefinitionRef found = definition_in(*s, name, table, hops); found.id != kNone) {
                return found;
            }
            hops += s->framed;
        }
        return {};
    }

    /// In one scope; in the root of a unit also in the files it uses.
    DefinitionRef definition_in(const BlockScope& s, Symbol name,
                                std::unordered_map<Symbol, std::uint32_t> BlockScope::*table,
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

    void statement_expression(ExprId e) {
        if (e != kNone) {
            Activation activation;
            activation_ = &activation;
            resolve_expression(e);
            activation_ = nullptr;
            r_.statement_locals = std::max(r_.statement_locals, activation.most);
        }
    }

    void resolve_function(std::span<const Argument> parameters, ExprId body, Activation& activation) {
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

    void call_arguments(const Expr& e) {
        for (const Argument& a : p_.arguments_of(e)) {
            resolve_expression(a.value);
            if (a.name != kNoSymbol && dynamic_name(a.name)) {
                r_.argument_slots[index_of(a)] = dynamic(a.name);
            }
        }
    }

    /// Variables of a let or for, in order; each sees those before it. Returns how many locals were visible before.
    void bind(std::span<const Argument> arguments) {
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

    void resolve_expression(ExprId id) {
        while (id != kNone) {
            id = resolve_one(id);
        }
    }

    /// Resolves all of an expression but one operand, which is returned: chains need no stack.
    ExprId resolve_one(ExprId id) {
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

    /// Updates assign to the loop's own variables, or declare more, which later updates see.
    void bind_update(std::span<const Argument> update, std::size_t first) {
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
            if (dynamic_name(a.name)) {
                slot = dynamic(a.name);
            } else if (slot == kNone) {
                slot = act.reserve();
                act.locals.push_back({a.name, slot, false});
            }
            r_.argument_slots[index_of(a)] = slot;
        }
    }

    void resolve_literal(ExprId id, const Expr& e) {
        LiteralInfo info;
        Activation activation;
        activation.outer = activation_;
        activation.literal = &info;
        resolve_function(p_.arguments_of(e), e.operand(0), activation);
        info.locals = activation.most;
        r_.of_expression[id] = static_cast<std::uint32_t>(r_.literals.size());
        r_.literals.push_back(std::move(info));
    }

    std::uint32_t add(VariableRef ref) {
        r_.variables.push_back(ref);
        return static_cast<std::uint32_t>(r_.variables.size() - 1);
    }

    /// Among the locals of `act`, and those around it if it belongs to a literal.
    VariableRef find_local(Activation& act, Symbol name, bool from_literal) {
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
        }
        return {Place::Capture, 0, slot, kNone};
    }

    VariableRef find_variable(Symbol name) {
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

    VariableRef find_in_blocks(Symbol name, const BlockScope* s, std::uint32_t hops) {
        for (; s != nullptr; s = s->outer) {
            if (const auto found = s->variables.find(name); found != s->variables.end()) {
                const VariableRef further = find_in_blocks(name, s->outer, hops + s->framed);
                return {Place::Block, hops, found->second, further.place == Place::Unknown ? kNone : add(further)};
            }
            hops += s->framed;
        }
        return {p_.symbols.text(name) == "PI" ? Place::Pi : Place::Unknown, 0, 0, kNone};
    }

    std::uint32_t find_call(Symbol name) {
        std::vector<CallTarget> targets;
        if (activation_ != nullptr && !dynamic_name(name)) {
            if (const VariableRef local = find_local(*activation_, name, false); local.place != Place::Unknown) {
                targets.push_back({CallTarget::Kind::Variable, local, {}, nullptr, kNone});
            }
        }
        if (dynamic_name(name)) {
            targets.push_back(
                {CallTarget::Kind::Variable, {Place::Dynamic, 0, dynamic(name), kNone}, {}, nullptr, kNone});
        }
        std::uint32_t hops = 0;
        bool certain = false;
        for (const BlockScope* s = block_; s != nullptr && !certain; s = s->outer) {
            if (const DefinitionRef f = definition_in(*s, name, &BlockScope::functions, hops); f.id != kNone) {
                targets.push_back({CallTarget::Kind::Function, {}, f, nullptr, kNone});
                certain = true;
            } else if (const auto v = s->variables.find(name); v != s->variables.end()) {
                targets.push_back(
                    {CallTarget::Kind::Variable, {Place::Block, hops, v->second, kNone}, {}, nullptr, kNone});
            }
            hops += s->framed;
        }
        if (!certain) {
            const BuiltinFunction builtin = find_builtin_function(p_.symbols.text(name));
            targets.push_back(
                {builtin == nullptr ? CallTarget::Kind::Unknown : CallTarget::Kind::Builtin, {}, {}, builtin, kNone});
        }
        const auto first = static_cast<std::uint32_t>(r_.calls.size());
        for (std::uint32_t i = 0; i < targets.size(); ++i) {
            targets[i].next = i + 1 < targets.size() ? first + i + 1 : kNone;
            r_.calls.push_back(targets[i]);
        }
        return first;
    }

    const Program& p_;
    Resolution r_;
    std::unordered_map<Symbol, std::set<Symbol>> passed_;  ///< Names of arguments, by name of the module called.
    std::vector<BlockScope> roots_;
    std::unordered_map<Symbol, std::uint32_t> dynamic_;
    const BlockScope* block_ = nullptr;
    Activation* activation_ = nullptr;
};

}  // namespace

Resolution resolve(const Program& program, std::span<const Symbol> always_dynamic) {
    return Resolver(program, always_dynamic).run();
}

}  // namespace csg::scad

// Calls of functions.
#include <algorithm>

#include "csg/scad/machine/compiler.h"

namespace csg::scad {

/// Where what a call works out begins: where its result goes, if nothing else lies above.
Register Compiler::call_window(Register target) const {
    return is_temporary(target) && target + 1 == next_ ? target : next_;
}

/// `tail`: it takes the place of the function that it ends.
void Compiler::call(ExprId id, Register target, bool tail) {
    const Expr& e = p_[id];
    const Temporaries temporaries(*this);
    if (p_[e.operand(0)].kind != ExprKind::Identifier) {
        call_any(id, kNone, true, target, tail);
        return;
    }
    const std::uint32_t call = r_.of_expression[id];
    switch (r_.calls[call].kind) {
        case CallTarget::Kind::Variable:
            call_any(id, call, true, target, tail);
            return;
        case CallTarget::Kind::Function:
            call_function(id, call, target, tail);
            return;
        case CallTarget::Kind::Builtin:
            call_builtin(id, call, target, tail);
            return;
        case CallTarget::Kind::Unknown:
            emit({.op = Opcode::WarnNoFunction, .e = id});
            finish_call(constant({}), target, tail);
    }
}

/// The result goes where it belongs.
void Compiler::finish_call(Operand result, Register target, bool tail) {
    if (tail) {
        emit({.op = Opcode::Return, .a = word(result)});
    } else {
        move(result, target);
    }
}

void Compiler::silent_argument(ExprId id, Register target) {
    if (id != kNone && p_[id].kind == ExprKind::Identifier) {
        emit({.op = Opcode::LoadSilent, .target = target, .a = r_.of_expression[id]});
    } else {
        into(id, target);
    }
}

void Compiler::call_builtin(ExprId id, std::uint32_t call, Register target, bool tail) {
    const auto arguments = p_.arguments_of(p_[id]);
    const BuiltinFunction function = r_.calls[call].builtin;
    if (arguments.size() == 1) {
        Operand argument{};
        if (function == host_.is_undef) {
            const Register silent = take();
            silent_argument(arguments[0].value, silent);
            argument = operand_of(silent);
        } else {
            argument = operand(arguments[0].value, target);
        }
        emit({.op = function == host_.len ? Opcode::Length : Opcode::CallBuiltinOne,
              .target = target,
              .a = call,
              .b = word(argument),
              .e = id});
    } else {
        const Register first = call_window(target);
        next_ = first;
        for (const Argument& a : arguments) {
            const Register to = take();
            if (function == host_.is_undef) {
                silent_argument(a.value, to);
            } else {
                into(a.value, to);
            }
        }
        emit({.op = Opcode::CallBuiltin,
              .target = target,
              .a = call,
              .b = first,
              .c = static_cast<std::uint32_t>(arguments.size()),
              .e = id});
    }
    if (tail) {
        emit({.op = Opcode::Return, .a = word(operand_of(target))});
    }
}

std::vector<std::uint32_t> Compiler::places_of(std::span<const Argument> arguments,
                                               std::span<const Argument> parameters) const {
    std::vector<std::uint32_t> places;
    std::vector<bool> named(parameters.size()), given(parameters.size());
    std::size_t position = 0;
    for (const Argument& a : arguments) {
        std::size_t place = 0;
        if (a.name == kNoSymbol) {
            while (position < parameters.size() && named[position]) {
                ++position;
            }
            place = position++;
        } else {
            while (place < parameters.size() && parameters[place].name != a.name) {
                ++place;
            }
        }
        if (place >= parameters.size() || given[place]) {
            return {};
        }
        named[place] = a.name != kNoSymbol;
        given[place] = true;
        places.push_back(static_cast<std::uint32_t>(place));
    }
    return places;
}

void Compiler::note_arguments(std::uint32_t begin, ExprId call) {
    if (begin != here()) {
        code_.arguments.push_back({begin, here(), call});
    }
}

void Compiler::call_function(ExprId id, std::uint32_t call, Register target, bool tail) {
    constexpr std::size_t kMost = 64;  // Further parameters are not told apart.
    const auto arguments = p_.arguments_of(p_[id]);
    const auto parameters = p_.parameters_of(p_.functions[r_.calls[call].function.id]);
    const std::vector<std::uint32_t> places = places_of(arguments, parameters);
    if (places.size() != arguments.size() || parameters.size() > kMost) {
        call_any(id, call, false, target, tail);
        return;
    }
    const Register first = call_window(target);
    next_ = first;
    take(static_cast<std::uint32_t>(parameters.size()));
    std::vector<bool> given(parameters.size());
    for (const std::uint32_t place : places) {
        given[place] = true;
    }
    const auto leading = static_cast<std::uint32_t>(std::find(given.begin(), given.end(), false) - given.begin());
    const std::uint32_t begin = here();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        into(arguments[i].value, first + places[i]);
    }
    if (!tail) {
        note_arguments(begin, id);
    }
    for (std::uint32_t i = leading; i < given.size(); ++i) {
        if (!given[i]) {
            emit({.op = Opcode::Unset, .a = first + i});
        }
    }
    emit({.op = tail ? Opcode::TailFunction : Opcode::CallFunction,
          .target = target,
          .a = call,
          .b = first,
          .c = leading,
          .e = id});
}

void Compiler::call_any(ExprId id, std::uint32_t call, bool find, Register target, bool tail) {
    const Expr& e = p_[id];
    const auto arguments = p_.arguments_of(e);
    const Register first = call_window(target);
    next_ = first;
    take();
    Jumps nothing;
    if (!find) {
        move(constant({}), first);
    } else if (call != kNone) {
        nothing.push_back(emit({.op = Opcode::FindCallee, .a = call, .b = first, .e = id}));
    } else {
        into(e.operand(0), first);
        nothing.push_back(emit({.op = Opcode::CheckCallee, .b = first, .e = id}));
    }
    const std::uint32_t begin = here();
    for (const Argument& a : arguments) {
        into(a.value, take());
    }
    if (!tail) {
        note_arguments(begin, id);
    }
    emit({.op = tail ? Opcode::TailAny : Opcode::CallAny,
          .target = target,
          .a = call,
          .b = first,
          .c = static_cast<std::uint32_t>(arguments.size()),
          .e = id});
    if (!nothing.empty()) {
        const std::uint32_t end = tail ? 0 : emit({.op = Opcode::Jump});
        land(nothing);
        finish_call(constant({}), target, tail);
        if (!tail) {
            land({end});
        }
    }
}

}  // namespace csg::scad

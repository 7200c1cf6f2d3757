// The machine that runs compiled expressions: one activation of `run` for each function that is not a tail call.
#include "csg/scad/machine/machine.h"

#include "csg/scad/machine/operators.h"

namespace csg::scad {

namespace {

bool truth(const Value& value) {
    return value.is_bool() ? value.boolean() : static_cast<bool>(value);
}

/// Small enough to be copied by a loop without calls.
void copy_element(const Value& list, double index, Value& out) {
    const auto elements = list.elements();
    if (index < static_cast<double>(elements.size())) {
        out = elements[static_cast<std::size_t>(index)];
    } else {
        out = Value();
    }
}

}  // namespace

Value Evaluator::run(Activation& a, std::uint32_t entry) {
    const Instruction* start = a.code->instructions.data();
    const Value* constants = a.code->constants.data();
    Value* r = a.registers;
    unsigned tail_calls = 0;
    const auto at = [&](std::uint32_t o) __attribute__((always_inline))->const Value& {
        // In two steps: GCC 12 with -fsanitize=undefined takes the wrong element of (… ? … : …)[o >> 1].
        const Value* const base = (o & 1U) != 0 ? constants : r;
        return base[o >> 1U];
    };
    const auto arithmetic = [&](const Instruction& i, auto&& of_numbers) {
        const Value &x = at(i.a), &y = at(i.b);
        if (x.is_number() && y.is_number()) {
            r[i.target] = of_numbers(x.number(), y.number());
        } else {
            r[i.target] = apply_binary(i, x, y);
        }
    };
    const auto holds = [&](const Instruction& i, auto&& of_numbers) {
        const Value &x = at(i.a), &y = at(i.b);
        return (x.is_number() && y.is_number() ? of_numbers(x.number(), y.number()) : compare(i, x, y)) ==
               (i.flag != 0);
    };
    for (const Instruction* next = start + entry;;) {
        const Instruction& i = *next++;
        switch (i.op) {
            case Opcode::Move:
                r[i.target] = at(i.a);
                break;
            case Opcode::LoadVariable:
                r[i.target] = variable_or_warn(i, a);
                break;
            case Opcode::LoadBlock: {
                const Value& value = outward(a.frame, i.b)->slots[i.c];
                if (value.is_unset()) {
                    r[i.target] = variable_or_warn(i, a);
                } else {
                    r[i.target] = value;
                }
                break;
            }
            case Opcode::LoadDynamic: {
                const Value& value = dynamic_[i.b];
                if (value.is_unset()) {
                    r[i.target] = variable_or_warn(i, a);
                } else {
                    note_read(i.b);
                    r[i.target] = value;
                }
                break;
            }
            case Opcode::LoadSilent: {
                Value value = variable(r_.variables[i.a], a.frame, &a);
                r[i.target] = value.is_unset() ? Value() : std::move(value);
                break;
            }
            case Opcode::LoadCarried:
                r[i.target] = variable(r_.variables[i.a], a.frame, &a);
                break;
            case Opcode::CheckSet:
                if (r[i.target].is_unset()) {
                    r[i.target] = unknown_variable(i.e);
                }
                break;
            case Opcode::Unary: {
                const Value& x = at(i.a);
                if (x.is_number() && i.flag == static_cast<std::uint8_t>(Operator::Negate)) {
                    r[i.target] = -x.number();
                } else {
                    r[i.target] = apply_unary(i, x);
                }
                break;
            }
            case Opcode::Equal:
                arithmetic(i, [](double x, double y) { return x == y; });
                break;
            case Opcode::NotEqual:
                arithmetic(i, [](double x, double y) { return x != y; });
                break;
            case Opcode::Less:
                arithmetic(i, [](double x, double y) { return x < y; });
                break;
            case Opcode::LessEqual:
                arithmetic(i, [](double x, double y) { return x <= y; });
                break;
            case Opcode::Greater:
                arithmetic(i, [](double x, double y) { return x > y; });
                break;
            case Opcode::GreaterEqual:
                arithmetic(i, [](double x, double y) { return x >= y; });
                break;
            case Opcode::Add:
                arithmetic(i, [](double x, double y) { return x + y; });
                break;
            case Opcode::Subtract:
                arithmetic(i, [](double x, double y) { return x - y; });
                break;
            case Opcode::Multiply:
                arithmetic(i, [](double x, double y) { return x * y; });
                break;
            case Opcode::Divide:
                arithmetic(i, [](double x, double y) { return x / y; });
                break;
            case Opcode::Modulo:
                arithmetic(i, [](double x, double y) { return remainder_of(x, y); });
                break;
            case Opcode::Binary:
                r[i.target] = apply_binary(i, at(i.a), at(i.b));
                break;
            case Opcode::Index: {
                const Value &list = at(i.a), &index = at(i.b);
                if (list.is_vector() && index.is_number() && index.number() >= 0) {
                    copy_element(list, index.number(), r[i.target]);
                } else {
                    r[i.target] = element_of(list, index);
                }
                break;
            }
            case Opcode::IndexBlock: {
                const Value &list = outward(a.frame, i.flag)->slots[i.c], &index = at(i.b);
                if (list.is_vector() && index.is_number() && index.number() >= 0) {
                    copy_element(list, index.number(), r[i.target]);
                } else {
                    r[i.target] = element_of(list.is_unset() ? variable_or_warn(i, a) : list, index);
                }
                break;
            }
            case Opcode::Member: {
                const Value& value = at(i.a);
                if (value.is_vector() && i.flag != 0) {
                    copy_element(value, i.flag - 1.0, r[i.target]);
                } else {
                    r[i.target] = member_of(value, name(i.b));
                }
                break;
            }
            case Opcode::Range:
                r[i.target] = check_range(i.e, r + i.a)
                                  ? Value(Range{r[i.a].number(), r[i.a + 1].number(), r[i.a + 2].number()})
                                  : Value();
                break;
            case Opcode::Length: {
                const Value& list = at(i.b);
                if (list.is_vector()) {
                    r[i.target] = static_cast<double>(list.elements().size());
                } else {
                    r[i.target] = call_builtin(i.e, i.a, {&list, 1});
                }
                break;
            }
            case Opcode::Jump:
                next = start + i.target;
                break;
            case Opcode::JumpTrue:
                if (truth(at(i.a)) == (i.flag != 0)) {
                    next = start + i.target;
                }
                break;
            case Opcode::JumpEqual:
                if (holds(i, [](double x, double y) { return x == y; })) {
                    next = start + i.target;
                }
                break;
            case Opcode::JumpNotEqual:
                if (holds(i, [](double x, double y) { return x != y; })) {
                    next = start + i.target;
                }
                break;
            case Opcode::JumpLess:
                if (holds(i, [](double x, double y) { return x < y; })) {
                    next = start + i.target;
                }
                break;
            case Opcode::JumpLessEqual:
                if (holds(i, [](double x, double y) { return x <= y; })) {
                    next = start + i.target;
                }
                break;
            case Opcode::JumpGreater:
                if (holds(i, [](double x, double y) { return x > y; })) {
                    next = start + i.target;
                }
                break;
            case Opcode::JumpGreaterEqual:
                if (holds(i, [](double x, double y) { return x >= y; })) {
                    next = start + i.target;
                }
                break;
            case Opcode::JumpSet:
                if (!r[i.a].is_unset()) {
                    next = start + i.target;
                }
                break;
            case Opcode::List:
                r[i.target] = Value::list({r + i.a, i.b});
                break;
            case Opcode::BeginList:
                r[i.target] = static_cast<double>(gathered_.size());
                break;
            case Opcode::Append:
                gathered_.push_back(at(i.a));
                break;
            case Opcode::AppendTaken:
                gathered_.push_back(std::move(r[i.a]));
                break;
            case Opcode::AppendEach:
                append_each(at(i.a), p_[i.e].where);
                break;
            case Opcode::AppendEachOf:
                for (const Value& value : at(i.a).elements()) {
                    append_each(value, p_[i.e].where);
                }
                break;
            case Opcode::EndList:
                r[i.target] = take_gathered(static_cast<std::size_t>(r[i.a].number()));
                break;
            case Opcode::ForValues:
                if (!begin_loop(i, at(i.b), r + i.a, r[i.c])) {
                    next = start + i.target;
                }
                break;
            case Opcode::ForRange:
                if (!begin_range_loop(i, r + i.a, r[i.c])) {
                    next = start + i.target;
                }
                break;
            case Opcode::ForNext: {
                Value* const loop = r + i.a;
                const double index = loop[kLoopIndex].number() + 1;
                loop[kLoopIndex] = index;
                if ((static_cast<std::uint64_t>(index) & 1023U) == 0) {
                    a.step.at = &i;
                    check_loop(p_[i.e].where);
                }
                if (index < loop[kLoopCount].number()) {
                    if (loop[kLoopValues].is_number()) {
                        r[i.c] = loop[kLoopValues].number() + loop[kLoopStep].number() * index;
                    } else if (loop[kLoopValues].is_vector()) {
                        r[i.c] = loop[kLoopValues].elements()[static_cast<std::size_t>(index)];
                    } else {
                        r[i.c] = loop_value(loop);
                    }
                    next = start + i.target;
                }
                break;
            }
            case Opcode::ForRound:
                a.step.at = &i;
                count_round(i, r[i.a]);
                break;
            case Opcode::BindDynamic:
                bind_dynamic(i.target, at(i.a));
                break;
            case Opcode::MarkDynamic:
                r[i.target] = static_cast<double>(undo_.size());
                break;
            case Opcode::RestoreDynamic:
                unwind(static_cast<std::size_t>(r[i.a].number()));
                break;
            case Opcode::Settle:
                if (!late_.empty()) {
                    settle(r + i.a);
                }
                break;
            case Opcode::MakeClosure:
                r[i.target] = make_closure(i.e, a);
                break;
            case Opcode::WarnAssignment:
                warn_assignment(i, at(i.a));
                break;
            case Opcode::Unset:
                r[i.a] = Value::unset();
                break;
            case Opcode::CallFunction:
                a.step.at = &i;
                r[i.target] = call_function(i, a);
                break;
            case Opcode::CallAny:
                a.step.at = &i;
                r[i.target] = call_any(i, a);
                break;
            case Opcode::TailFunction:
            case Opcode::TailAny: {
                a.step.at = &i;
                Value result;
                if (!replace(i, a, ++tail_calls, entry, result)) {
                    return result;
                }
                start = a.code->instructions.data();
                constants = a.code->constants.data();
                r = a.registers;
                next = start + entry;
                break;
            }
            case Opcode::FindCallee:
                if (!find_callee(i, a)) {
                    next = start + i.target;
                }
                break;
            case Opcode::CheckCallee:
                if (!r[i.b].is_function()) {
                    warn_no_callee(i, r[i.b]);
                    next = start + i.target;
                }
                break;
            case Opcode::CallBuiltin:
                r[i.target] = call_builtin(i.e, i.a, {r + i.b, i.c});
                break;
            case Opcode::CallBuiltinOne:
                r[i.target] = call_builtin(i.e, i.a, {&at(i.b), 1});
                break;
            case Opcode::WarnNoFunction:
                warn_no_function(i.e);
                break;
            case Opcode::Echo:
                echo(p_.arguments_of(p_[i.e]), r + i.a);
                break;
            case Opcode::FailAssert:
                a.step.at = &i;
                fail_assertion(p_[i.e].where, i.b, i.flag != 0 ? &at(i.a) : nullptr);
            case Opcode::Return:
                if ((i.a & 1U) != 0) {
                    return constants[i.a >> 1U];
                }
                return std::move(r[i.a >> 1U]);
        }
    }
}

}  // namespace csg::scad

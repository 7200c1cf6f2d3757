// Loops and lists of the machine.
#include <iterator>

#include "csg/scad/machine/machine.h"
#include "csg/scad/machine/sequence.h"
#include "csg/scad/value/object.h"

namespace csg::scad {

void Evaluator::append_each(const Value& value, const SourceRange& where) {
    if (value.is_vector()) {
        note_values(value.elements().size());
        gathered_.insert(gathered_.end(), value.elements().begin(), value.elements().end());
    } else if (value.is_range() || value.is_string()) {
        const Sequence sequence(value, *this, where);
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            gathered_.push_back(sequence.at(i));
        }
    } else if (!value.is_undef()) {
        gathered_.push_back(value);
    }
}

/// A list of what was gathered from `begin` on.
Value Evaluator::take_gathered(std::size_t begin) {
    Value list = Value::list(std::span(gathered_).subspan(begin));
    gathered_.resize(begin);
    return list;
}

/// Gets the four registers of a loop ready, and the first value to `variable`. False where there is none.
bool Evaluator::begin_loop(const Instruction& i, const Value& values, Value* loop, Value& variable) {
    const std::size_t count = Sequence::count(values, *this, p_[i.e].where);
    if (values.is_range()) {
        const Range range = values.range();
        loop[kLoopValues] = range.begin;
        loop[kLoopStep] = range.step;
    } else {
        loop[kLoopValues] = values;
        loop[kLoopStep] = 0.0;
    }
    loop[kLoopIndex] = 0.0;
    loop[kLoopCount] = static_cast<double>(count);
    if (count == 0) {
        return false;
    }
    variable = loop[kLoopValues].is_number() ? loop[kLoopValues] : loop_value(loop);
    return true;
}

/// The same of a range that nobody else needs.
bool Evaluator::begin_range_loop(const Instruction& i, Value* loop, Value& variable) {
    if (!check_range(i.e, loop)) {
        return false;
    }
    const Range range{loop[0].number(), loop[1].number(), loop[2].number()};
    const std::size_t count = Sequence::count(range, *this, p_[i.b].where);
    loop[kLoopValues] = range.begin;
    loop[kLoopStep] = range.step;
    loop[kLoopIndex] = 0.0;
    loop[kLoopCount] = static_cast<double>(count);
    variable = range.begin;
    return count != 0;
}

/// What a loop that does not go through numbers comes to.
Value Evaluator::loop_value(Value* loop) {
    const Value& values = loop[kLoopValues];
    const auto index = static_cast<std::size_t>(loop[kLoopIndex].number());
    if (values.is_vector()) {
        return values.elements()[index];
    }
    if (values.is_object()) {
        return values.entries().keys()[index];
    }
    if (values.is_string()) {
        const auto begin = static_cast<std::size_t>(loop[kLoopStep].number());
        const std::size_t bytes = code_point_bytes(values.string(), begin);
        loop[kLoopStep] = static_cast<double>(begin + bytes);
        return values.string().substr(begin, bytes);
    }
    return values;
}

void Evaluator::check_loop(const SourceRange& where) {
    check_stop(where);
    if (live_elements() + gathered_.size() > request_.limits.list_elements) {
        fail(where, fmt::format("Lists hold more than {} elements", request_.limits.list_elements));
    }
}

void Evaluator::count_round(const Instruction& i, Value& round) {
    constexpr double kMaxRounds = 1'000'000;  // OpenSCAD's limit.
    const SourceRange& where = p_[i.e].where;
    if (round.number() >= kMaxRounds) {
        fail(where, "For loop counter exceeded limit");
    }
    round = round.number() + 1;
    check_stop(where);
}

}  // namespace csg::scad

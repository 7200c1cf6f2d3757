#include "csg/scad/machine/trace.h"

#include <fmt/format.h>

#include <algorithm>

namespace csg::scad {

namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 10;  // Of a parameter.

std::string parameters_text(const Program& program, const ActiveStep& step) {
    std::string result;
    for (std::size_t i = 0; i < step.parameters.size(); ++i) {
        std::string value;
        try {
            value = step.values[i].echo_text(kMostBytes);
        } catch (const ValueLimit&) {
            value = "...";
        }
        result += fmt::format("{}{} = {}", i == 0 ? "" : ", ", program.symbols.text(step.parameters[i].name), value);
    }
    return result;
}

/// What a trace shows: a step, or a call whose arguments are being worked out, in `where` and `name`.
struct Shown {
    const ActiveStep* step = nullptr;
    const SourceRange* where = nullptr;
    Symbol name = kNoSymbol;
};

/// Calls of a step whose arguments are being worked out, the innermost first, and the step itself.
std::vector<Shown> shown_of(const Program& program, const ActiveStep& step) {
    std::vector<Shown> shown;
    if (step.at != nullptr) {
        const auto at = static_cast<std::uint32_t>(step.at - step.code->instructions.data());
        for (const ArgumentRegion& region : step.code->arguments) {
            const Expr& call = program[region.call];
            const Expr& callee = program[call.operand(0)];
            if (region.begin <= at && at < region.end && callee.kind == ExprKind::Identifier) {
                shown.push_back({nullptr, &call.where, callee.name});
            }
        }
    }
    if (step.name != kNoSymbol) {
        shown.push_back({&step, step.where, step.name});
    }
    return shown;
}

void append(std::vector<Message>& messages, const Program& program, const Shown& shown) {
    const std::string& name = program.symbols.text(shown.name);
    const auto add = [&](const SourceRange& where, std::string text) {
        messages.push_back({Severity::Trace, where, std::move(text)});
    };
    switch (shown.step == nullptr ? ActiveStep::Kind::CalledBy : shown.step->kind) {
        case ActiveStep::Kind::CalledBy:
            add(*shown.where, fmt::format("called by '{}'", name));
            break;
        case ActiveStep::Kind::CallOf:
            add(*shown.where, fmt::format("call of '{}({})'", name, parameters_text(program, *shown.step)));
            break;
        case ActiveStep::Kind::Assignment:
            if (const auto first = program.first_places.find(shown.step->assignment);
                first != program.first_places.end()) {
                add(first->second, fmt::format("overwritten assignment to \"{}\" (this is where the assignment is "
                                               "evaluated)",
                                               name));
                add(*shown.where, fmt::format("overwriting assignment to \"{}\"", name));
            } else {
                add(*shown.where, fmt::format("assignment to \"{}\"", name));
            }
            break;
    }
}

}  // namespace

std::vector<Message> trace_messages(const Program& program, const ActiveStep* innermost, std::size_t shown) {
    std::vector<Shown> first, last;  // `last` is a ring once it is full.
    std::size_t count = 0;
    for (const ActiveStep* step = innermost; step != nullptr; step = step->outer) {
        for (const Shown& one : shown_of(program, *step)) {
            if (count < shown) {
                first.push_back(one);
            } else if (last.size() < shown) {
                last.push_back(one);
            } else if (shown != 0) {
                last[count % shown] = one;
            }
            ++count;
        }
    }
    const std::size_t left_out = count - first.size() - last.size();
    if (left_out != 0 && shown != 0) {
        std::rotate(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(count % shown), last.end());
    }
    std::vector<Message> messages;
    for (const Shown& one : first) {
        append(messages, program, one);
    }
    if (left_out != 0) {
        messages.push_back({Severity::Trace, {}, fmt::format("  *** Excluding {} frames ***", left_out)});
    }
    for (const Shown& one : last) {
        append(messages, program, one);
    }
    return messages;
}

}  // namespace csg::scad

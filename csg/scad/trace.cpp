#include "csg/scad/trace.h"

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

void append(std::vector<Message>& messages, const Program& program, const ActiveStep& step) {
    const std::string& name = program.symbols.text(step.name);
    const auto add = [&](const SourceRange& where, std::string text) {
        messages.push_back({Severity::Trace, where, std::move(text)});
    };
    switch (step.kind) {
        case ActiveStep::Kind::CalledBy:
            add(*step.where, fmt::format("called by '{}'", name));
            break;
        case ActiveStep::Kind::CallOf:
            add(*step.where, fmt::format("call of '{}({})'", name, parameters_text(program, step)));
            break;
        case ActiveStep::Kind::Assignment:
            if (const auto first = program.first_places.find(step.assignment); first != program.first_places.end()) {
                add(first->second, fmt::format("overwritten assignment to \"{}\" (this is where the assignment is "
                                               "evaluated)",
                                               name));
                add(*step.where, fmt::format("overwriting assignment to \"{}\"", name));
            } else {
                add(*step.where, fmt::format("assignment to \"{}\"", name));
            }
            break;
    }
}

}  // namespace

std::vector<Message> trace_messages(const Program& program, const ActiveStep* innermost, std::size_t shown) {
    std::vector<const ActiveStep*> first, last;  // `last` is a ring once it is full.
    std::size_t count = 0;
    for (const ActiveStep* step = innermost; step != nullptr; step = step->outer) {
        if (step->name == kNoSymbol) {
            continue;
        }
        if (count < shown) {
            first.push_back(step);
        } else if (last.size() < shown) {
            last.push_back(step);
        } else if (shown != 0) {
            last[count % shown] = step;
        }
        ++count;
    }
    const std::size_t left_out = count - first.size() - last.size();
    if (left_out != 0 && shown != 0) {
        std::rotate(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(count % shown), last.end());
    }
    std::vector<Message> messages;
    for (const ActiveStep* step : first) {
        append(messages, program, *step);
    }
    if (left_out != 0) {
        messages.push_back({Severity::Trace, {}, fmt::format("  *** Excluding {} frames ***", left_out)});
    }
    for (const ActiveStep* step : last) {
        append(messages, program, *step);
    }
    return messages;
}

}  // namespace csg::scad

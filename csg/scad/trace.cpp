#include "csg/scad/trace.h"

#include <fmt/format.h>

namespace csg::scad {

namespace {

std::string text_of(const TraceStep& step, const SymbolTable& symbols) {
    const std::string& name = symbols.text(step.name);
    switch (step.kind) {
        case TraceStep::Kind::CalledBy:
            return fmt::format("called by '{}'", name);
        case TraceStep::Kind::Assignment:
            return fmt::format("assignment to \"{}\"", name);
        case TraceStep::Kind::CallOf:
            break;
    }
    std::string parameters;
    for (const auto& [parameter, value] : step.parameters) {
        std::string text;
        try {
            text = value.echo_text();
        } catch (const ValueLimit&) {
            text = "...";
        }
        parameters += fmt::format("{}{} = {}", parameters.empty() ? "" : ", ", symbols.text(parameter), text);
    }
    return fmt::format("call of '{}({})'", name, parameters);
}

}  // namespace

void Trace::add(TraceStep step) {
    if (count_ < kEnd) {
        first_.push_back(std::move(step));
    } else if (count_ < 2 * kEnd) {
        last_.push_back(std::move(step));
    } else {
        last_[count_ % kEnd] = std::move(step);
    }
    ++count_;
}

std::vector<Message> Trace::messages(const SymbolTable& symbols) const {
    std::vector<Message> result;
    const auto show = [&](const TraceStep& step) {
        result.push_back({Severity::Trace, step.where, text_of(step, symbols)});
    };
    for (const TraceStep& step : first_) {
        show(step);
    }
    const std::size_t left_out = count_ - first_.size() - last_.size();
    if (left_out != 0) {
        result.push_back({Severity::Trace, {}, fmt::format("  *** Excluding {} frames ***", left_out)});
    }
    for (std::size_t i = 0; i < last_.size(); ++i) {
        show(last_[left_out == 0 ? i : (count_ + i) % kEnd]);
    }
    return result;
}

}  // namespace csg::scad

#include "csg/scad/machine/sequence.h"

#include "csg/scad/value/object.h"

namespace csg::scad {

std::size_t Sequence::count(const Range& range, Evaluator& evaluator, const SourceRange& where) {
    constexpr std::uint32_t kMaxSteps = 1'000'000;  // OpenSCAD's limit.
    const std::uint32_t count = range.count();
    if (count >= kMaxSteps) {
        evaluator.warn(where, fmt::format("Bad range parameter in for statement: too many elements ({})", count));
        return 0;
    }
    return count;
}

std::size_t Sequence::count(const Value& value, Evaluator& evaluator, const SourceRange& where) {
    switch (value.type()) {
        case ValueType::Range:
            return count(value.range(), evaluator, where);
        case ValueType::Vector:
            return value.elements().size();
        case ValueType::String:
            return value.length();
        case ValueType::Object:
            return value.entries().size();
        default:
            return value.is_undef() ? 0 : 1;
    }
}

Sequence::Sequence(const Value& value, Evaluator& evaluator, const SourceRange& where)
    : value_(value), size_(count(value, evaluator, where)) {
    if (value.is_string()) {
        const std::string_view text = value.string();
        for (std::size_t at = 0; at < text.size(); at += characters_.back().size()) {
            characters_.push_back(text.substr(at, code_point_bytes(text, at)));
        }
    }
}

Value Sequence::at(std::size_t i) const {
    if (value_.is_range()) {
        return value_.range().at(static_cast<std::uint32_t>(i));
    }
    if (value_.is_vector()) {
        return value_.elements()[i];
    }
    if (value_.is_object()) {
        return value_.entries().keys()[i];
    }
    return value_.is_string() ? Value(std::string(characters_[i])) : value_;
}

}  // namespace csg::scad

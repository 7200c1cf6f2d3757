#include "csg/scad/sequence.h"

#include "csg/scad/object.h"

namespace csg::scad {

Sequence::Sequence(const Value& value, Evaluator& evaluator, const SourceRange& where) : value_(value) {
    constexpr std::uint32_t kMaxSteps = 1'000'000;  // OpenSCAD's limit.
    if (value.is_range()) {
        size_ = value.range().count();
        if (size_ >= kMaxSteps) {
            evaluator.warn(where, fmt::format("Bad range parameter in for statement: too many elements ({})", size_));
            size_ = 0;
        }
    } else if (value.is_vector()) {
        size_ = value.elements().size();
    } else if (value.is_string()) {
        const std::string_view text = value.string();
        for (std::size_t at = 0; at < text.size(); at += characters_.back().size()) {
            characters_.push_back(text.substr(at, code_point_bytes(text, at)));
        }
        size_ = characters_.size();
    } else if (value.is_object()) {
        size_ = value.entries().size();
    } else {
        size_ = value.is_undef() ? 0 : 1;
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

// Values as text, as OpenSCAD prints them.
#include <array>
#include <charconv>
#include <cmath>

#include "csg/scad/value/number_text.h"
#include "csg/scad/value/object.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

std::string number_text(double number) {
    if (std::string plain; append_plain_number(plain, number)) {
        return plain;
    }
    if (std::isnan(number)) {
        return "nan";
    }
    if (std::isinf(number)) {
        return number < 0 ? "-inf" : "inf";
    }
    if (number == 0) {
        return "0";
    }
    // d.ddddde±xx, correctly rounded; ties go to the even digit, as the six digits are of the exact binary value.
    std::array<char, 32> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::scientific, 5);
    std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
    std::string result;
    if (text.front() == '-') {
        result = "-";
        text.remove_prefix(1);
    }
    const std::size_t e = text.find('e');
    int exponent = 0;
    const std::string_view digits_of_exponent = text.substr(text[e + 1] == '+' ? e + 2 : e + 1);
    std::from_chars(digits_of_exponent.data(), digits_of_exponent.data() + digits_of_exponent.size(), exponent);
    std::string digits = std::string(1, text[0]) + std::string(text.substr(2, e - 2));
    digits.erase(digits.find_last_not_of('0') + 1);
    const auto count = static_cast<int>(digits.size());
    if (exponent < -5 || exponent > 5) {
        result += digits[0];
        if (count > 1) {
            result += '.' + digits.substr(1);
        }
        result += exponent < 0 ? "e-" : "e+";
        return result + std::to_string(std::abs(exponent));
    }
    if (exponent < 0) {
        return result + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    }
    if (count <= exponent + 1) {
        return result + digits + std::string(static_cast<std::size_t>(exponent + 1 - count), '0');
    }
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    return result + digits.substr(0, whole) + '.' + digits.substr(whole);
}

namespace {

constexpr std::size_t kMostNested = 20'000;

std::string scalar_text(const Value& value, bool quoted) {
    switch (value.type()) {
        case ValueType::Bool:
            return value.boolean() ? "true" : "false";
        case ValueType::Number:
            return number_text(value.number());
        case ValueType::String:
            return quoted ? '"' + value.string() + '"' : value.string();
        case ValueType::Range: {
            const Range& r = value.range();
            return '[' + number_text(r.begin) + " : " + number_text(r.step) + " : " + number_text(r.end) + ']';
        }
        case ValueType::Function:
            return value.function().text();
        default:
            return "undef";
    }
}

/// A list or an object whose text is being written.
class OpenCompound {
  public:
    explicit OpenCompound(const Value& value)
        : object_(value.is_object() ? &value.entries() : nullptr),
          parts_(object_ != nullptr ? object_->values() : value.elements()) {}
    [[nodiscard]] bool done() const { return next_ == parts_.size(); }
    [[nodiscard]] std::string_view begin() const { return object_ != nullptr ? "{ " : "["; }
    [[nodiscard]] std::string_view end() const { return object_ == nullptr ? "]" : parts_.empty() ? "}" : "; }"; }
    /// The next part; what is to be written before it goes to `out`.
    const Value& next(std::string& out) {
        if (next_ != 0) {
            out += object_ != nullptr ? "; " : ", ";
        }
        if (object_ != nullptr) {
            out += object_->keys()[next_] + " = ";
        }
        return parts_[next_++];
    }

  private:
    const ObjectEntries* object_;  ///< Null for a list.
    std::span<const Value> parts_;
    std::size_t next_ = 0;
};

std::string text_of(const Value& value, bool quoted, std::size_t most_bytes) {
    const auto is_compound = [](const Value& v) { return v.is_vector() || v.is_object(); };
    if (!is_compound(value)) {
        return scalar_text(value, quoted);
    }
    std::vector<OpenCompound> open{OpenCompound(value)};  // Not recursive: lists nest without bound.
    std::string result(open.back().begin());
    while (!open.empty()) {
        OpenCompound& top = open.back();
        if (top.done()) {
            result += top.end();
            open.pop_back();
            continue;
        }
        const Value& part = top.next(result);
        note_values(1);
        if (result.size() > most_bytes) {
            throw ValueLimit("A list is too long to be converted to text");
        }
        if (is_compound(part)) {
            if (open.size() == kMostNested) {
                throw ValueLimit("Stack exhausted while trying to convert a vector to EchoString");
            }
            open.emplace_back(part);
            result += open.back().begin();
        } else {
            result += scalar_text(part, true);
        }
    }
    return result;
}

}  // namespace

std::string Value::text() const {
    return text_of(*this, false, kMostTextBytes);
}
std::string Value::echo_text(std::size_t most_bytes) const {
    return text_of(*this, true, most_bytes);
}

}  // namespace csg::scad

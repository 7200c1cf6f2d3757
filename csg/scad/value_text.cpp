// Values as text, as OpenSCAD prints them.
#include <array>
#include <charconv>
#include <cmath>

#include "csg/scad/value.h"

namespace csg::scad {

std::string number_text(double number) {
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

std::string text_of(const Value& value, bool quoted, std::size_t most_bytes) {
    if (!value.is_vector()) {
        return scalar_text(value, quoted);
    }
    struct Open {
        std::span<const Value> elements;
        std::size_t next;
    };
    std::string result = "[";
    std::vector<Open> open{{value.elements(), 0}};  // Not recursive: lists nest without bound.
    while (!open.empty()) {
        Open& top = open.back();
        if (top.next == top.elements.size()) {
            result += ']';
            open.pop_back();
            continue;
        }
        if (top.next != 0) {
            result += ", ";
        }
        const Value& element = top.elements[top.next++];
        if (result.size() > most_bytes) {
            throw ValueLimit("A list is too long to be converted to text");
        }
        if (element.is_vector()) {
            if (open.size() == kMostNested) {
                throw ValueLimit("Stack exhausted while trying to convert a vector to EchoString");
            }
            result += '[';
            open.push_back({element.elements(), 0});
        } else {
            result += scalar_text(element, true);
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

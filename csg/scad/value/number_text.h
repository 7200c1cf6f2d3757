// Numbers with six significant digits, as the .csg output has them. Internal to the texts of trees and values.
#pragma once

#include <string>

namespace csg::scad {

/// Appends a number from 0.0001 up to a million, of either sign, or 0; false, and nothing, for others and where a
/// longer way must decide how to round. No zeros behind the decimal point at the end: "0.5", "12", "-0.00033333".
[[nodiscard]] bool append_plain_number(std::string& out, double number);

/// Appends as C++ streams print it: "0.5", "1e+06", "nan".
void append_number(std::string& out, double number);

}  // namespace csg::scad

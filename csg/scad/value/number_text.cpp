#include "csg/scad/value/number_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace csg::scad {

namespace {

constexpr std::size_t kDigits = 6;
constexpr std::uint32_t kTooMany = 1'000'000;  // 10^kDigits
constexpr double kFewest = 1e5;                // The least number of kDigits.

/// Writes the digits of `value`, as many as `count`, the first ones zeros where it is smaller.
void write_digits(char* out, std::uint32_t value, std::size_t count) {
    for (std::size_t i = count; i-- > 0; value /= 10) {
        out[i] = static_cast<char>('0' + value % 10);
    }
}

std::size_t digits_of(std::uint32_t value) {
    std::size_t count = 1;
    for (; value >= 10; value /= 10) {
        ++count;
    }
    return count;
}

}  // namespace

bool append_plain_number(std::string& out, double number) {
    const double size = std::abs(number);
    if (!(size < kTooMany) || (number == 0 && std::signbit(number))) {
        return false;
    }
    std::array<char, 32> text{};
    char* at = text.data();
    if (number < 0) {
        *at++ = '-';
    }
    const auto whole = static_cast<std::uint32_t>(size);
    if (whole == size) {
        const std::size_t count = digits_of(whole);
        write_digits(at, whole, count);
        out.append(text.data(), at + count);
        return true;
    }
    // How many digits behind the point make six significant ones: powers of ten up to 10^9 are exact, so their product
    // with the number is off by half a unit in its last place, 2^-34 at most.
    static constexpr std::array<double, 10> kPowers = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    std::size_t behind = 0;
    if (whole > 0) {
        behind = kDigits - digits_of(whole);
    } else {
        behind = kDigits;
        while (behind < kPowers.size() && size * kPowers[behind] < kFewest) {
            ++behind;
        }
        if (behind == kPowers.size()) {
            return false;
        }
    }
    const double scaled = size * kPowers[behind];
    const double floor = std::floor(scaled);
    const double rest = scaled - floor;
    constexpr double kTooClose = 1e-9;
    if (std::abs(rest - 0.5) < kTooClose || scaled < kFewest - 0.5) {
        return false;
    }
    auto digits = static_cast<std::uint32_t>(floor) + (rest > 0.5 ? 1 : 0);
    if (digits >= kTooMany) {
        return false;
    }
    while (behind > 0 && digits % 10 == 0) {
        digits /= 10;
        --behind;
    }
    const auto power = static_cast<std::uint32_t>(kPowers[behind]);
    const std::uint32_t before = digits / power;
    const std::size_t count = digits_of(before);
    write_digits(at, before, count);
    at += count;
    if (behind > 0) {
        *at++ = '.';
        write_digits(at, digits % power, behind);
        at += behind;
    }
    out.append(text.data(), at);
    return true;
}

void append_number(std::string& out, double number) {
    if (!append_plain_number(out, number)) {
        fmt::format_to(std::back_inserter(out), "{:g}", number);
    }
}

}  // namespace csg::scad

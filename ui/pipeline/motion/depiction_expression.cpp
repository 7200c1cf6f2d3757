#include "ui/pipeline/motion/depiction_expression.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csg/scad/builtin/color_names.h"
#include "ui/pipeline/suggestion.h"
#include "ui/pipeline/trimmed.h"

namespace ui {

namespace {

using Technique = Depiction::Technique;

const std::vector<std::pair<std::string, Technique>> kTechniques = {
    {"path", Technique::Path},   {"motion", Technique::Motion},     {"still", Technique::Still},
    {"ghost", Technique::Ghost}, {"rotation", Technique::Rotation}, {"collision", Technique::Collision},
    {"frame", Technique::Frame}, {"speak", Technique::Speak},       {"camera", Technique::Camera},
    {"auto", Technique::Auto}};

/// Of an expression that is none.
struct Unexpected {
    std::size_t at = 0;  ///< Bytes.
    std::string expected;
};

class Reader {
  public:
    explicit Reader(const std::string& text) : text_(text) {}

    Depiction read() {
        Depiction d;
        d.text = text_;
        d.technique = technique();
        if (take('{')) {
            d.part = until('}');
            if (d.part.empty()) {
                fail("the name of a part");
            }
        }
        if (take('[')) {
            d.times = times();
        }
        if (take('(')) {
            parameters(d);
        }
        skip();
        if (at_ < text_.size()) {
            fail(d.times ? "(name=value,…), or the end" : "{part}, [t0,t1], (name=value,…), or the end");
        }
        if (d.technique == Technique::Speak && d.say.empty()) {
            fail("(text=\"…\"), what it says");
        }
        return d;
    }

  private:
    [[noreturn]] void fail(const std::string& expected) const { throw Unexpected{at_, expected}; }
    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
    }
    bool take(char c) {
        skip();
        if (at_ < text_.size() && text_[at_] == c) {
            ++at_;
            return true;
        }
        return false;
    }
    std::string word() {
        skip();
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        return text_.substr(begin, at_ - begin);
    }
    std::string until(char end) {
        const std::size_t close = text_.find(end, at_);
        if (close == std::string::npos) {
            at_ = text_.size();
            fail(fmt::format("'{}'", end));
        }
        std::size_t first = at_, last = close;
        while (first < last && text_[first] == ' ') {
            ++first;
        }
        while (last > first && text_[last - 1] == ' ') {
            --last;
        }
        at_ = close + 1;
        return text_.substr(first, last - first);
    }
    double number() {
        skip();
        double value = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error != std::errc()) {
            fail("a number");
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }

    Technique technique() {
        const std::string name = word();
        for (const auto& [known, technique] : kTechniques) {
            if (name == known) {
                return technique;
            }
        }
        at_ -= name.size();
        const std::vector<std::string> names = technique_names();
        fail(fmt::format("a technique: {}{}", fmt::join(names, ", "), suggestion(name, names)));
    }
    std::pair<double, double> times() {
        const double first = number();
        const double last = take(',') ? number() : first;
        if (last < first) {
            fail("a time that is not before the first");
        }
        if (!take(']')) {
            fail("']'");
        }
        return {first, last};
    }
    void parameters(Depiction& d) {
        do {
            const std::string name = word();
            const auto expect_value = [&] {
                if (!take('=')) {
                    fail("'='");
                }
            };
            if (name == "n") {
                expect_value();
                const double n = number();
                if (!(n >= 1 && n <= 1000) || n != static_cast<int>(n)) {
                    fail("a whole number from 1 to 1000 before this");
                }
                d.count = static_cast<int>(n);
            } else if (name == "squash") {
                expect_value();
                d.squash = number();
                if (!(d.squash >= 0 && d.squash <= 10)) {
                    fail("a number from 0 to 10 before this");
                }
            } else if (name == "width") {
                expect_value();
                d.width = number();
                if (!(*d.width > 0)) {
                    fail("a width above 0 before this");
                }
            } else if (name == "color") {
                expect_value();
                d.color = color();
            } else if (name == "text") {
                expect_value();
                d.say = quoted();
            } else if (name == "style" && has_images(d.technique)) {
                expect_value();
                skip();
                d.style_at = at_;
                d.style = style();
            } else if (name == "with") {
                expect_value();
                d.with = quoted();
            } else {
                at_ -= name.size();
                fail(fmt::format("n=, squash=, width=, color=, {}text= or with=",
                                 has_images(d.technique) ? "style=, " : ""));
            }
        } while (take(','));
        if (!take(')')) {
            fail("',' or ')'");
        }
    }
    /// Between quotes of either kind.
    std::string quoted() {
        skip();
        const char quote = at_ < text_.size() ? text_[at_] : ' ';
        if (quote != '"' && quote != '\'') {
            fail("a text in quotes");
        }
        const std::size_t close = text_.find(quote, at_ + 1);
        if (close == std::string::npos || close == at_ + 1) {
            at_ = close == std::string::npos ? text_.size() : at_ + 1;
            fail(close == std::string::npos ? fmt::format("{}", quote) : "a text");
        }
        std::string result = text_.substr(at_ + 1, close - at_ - 1);
        at_ = close + 1;
        return result;
    }
    static bool has_images(Technique technique) {
        return technique == Technique::Still || technique == Technique::Ghost || technique == Technique::Auto;
    }
    /// A name, or in quotes STYLE,PARAMETER=VALUE,….
    std::string style() {
        skip();
        if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\'')) {
            return quoted();
        }
        const std::size_t begin = at_;
        while (at_ < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '-')) {
            ++at_;
        }
        if (at_ == begin) {
            fail("a style");
        }
        return text_.substr(begin, at_ - begin);
    }
    /// #rrggbb, or a name of color().
    csg::Rgba color() {
        skip();
        std::size_t end = at_;
        while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '#')) {
            ++end;
        }
        const auto found = csg::scad::find_color(std::string_view(text_).substr(at_, end - at_));
        if (!found) {
            fail("a color, #rrggbb or a name");
        }
        at_ = end;
        return {found->r, found->g, found->b, 1};
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

bool matches(std::string_view pattern, std::string_view name) {
    // By the last star that was passed: what it stands for grows until the rest fits.
    std::size_t p = 0, n = 0, star = std::string_view::npos, from = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            from = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++from;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

/// Where what is behind a # begins; not of a color, nor in a text.
std::size_t end_of_rule(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote != 0) {
            quote = line[i] == quote ? '\0' : quote;
        } else if (line[i] == '"' || line[i] == '\'') {
            quote = line[i];
        } else if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) {
            return i;
        }
    }
    return line.size();
}

}  // namespace

std::vector<std::string> technique_names() {
    std::vector<std::string> names;
    names.reserve(kTechniques.size());
    for (const auto& [known, technique] : kTechniques) {
        names.push_back(known);
    }
    return names;
}

Depiction read_depiction(const std::string& text) {
    try {
        return Reader(text).read();
    } catch (const Unexpected& wrong) {
        throw std::runtime_error(fmt::format("expected {}\n  {}\n  {:>{}}", wrong.expected, text, '^', wrong.at + 1));
    }
}

std::vector<Depiction> read_depiction_rules(const std::string& text, const std::string& file) {
    std::vector<Depiction> rules;
    int number = 0;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        const std::string rule(trimmed(line.substr(0, end_of_rule(line))));
        begin = end + 1;
        if (rule.empty()) {
            continue;
        }
        try {
            rules.push_back(Reader(rule).read());
            rules.back().rule = true;
        } catch (const Unexpected& wrong) {
            const std::size_t indent = line.find_first_not_of(" \t\r");
            throw std::runtime_error(fmt::format("{}:{}:{}: expected {}\n  {}\n  {:>{}}", file, number + 1,
                                                 indent + wrong.at + 1, wrong.expected, rule, '^', wrong.at + 1));
        }
    }
    return rules;
}

bool names_body(const std::string& pattern, const std::string& name) {
    const std::size_t blank = name.rfind(' ');
    const bool numbered = blank != std::string::npos && blank + 1 < name.size() &&
                          name.find_first_not_of("0123456789", blank + 1) == std::string::npos;
    for (std::size_t begin = 0; begin <= pattern.size();) {
        const std::size_t end = std::min(pattern.find(',', begin), pattern.size());
        const std::string_view one = trimmed(std::string_view(pattern).substr(begin, end - begin));
        if (matches(one, name) || (numbered && matches(one, std::string_view(name).substr(0, blank)))) {
            return true;
        }
        begin = end + 1;
    }
    return false;
}

}  // namespace ui

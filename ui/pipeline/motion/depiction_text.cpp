#include <cctype>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ui/pipeline/motion/depiction.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

using Technique = Depiction::Technique;

const std::vector<std::pair<std::string, Technique>> kTechniques = {
    {"path", Technique::Path},   {"motion", Technique::Motion},     {"still", Technique::Still},
    {"ghost", Technique::Ghost}, {"rotation", Technique::Rotation}, {"auto", Technique::Auto}};

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
        return d;
    }

  private:
    [[noreturn]] void fail(const std::string& expected) const {
        throw std::runtime_error(fmt::format("expected {}\n  {}\n  {:>{}}", expected, text_, '^', at_ + 1));
    }
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
        std::vector<std::string> names;
        names.reserve(kTechniques.size());
        for (const auto& [known, technique] : kTechniques) {
            names.push_back(known);
        }
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
            } else {
                at_ -= name.size();
                fail("n=, squash=, width= or color=");
            }
        } while (take(','));
        if (!take(')')) {
            fail("',' or ')'");
        }
    }
    csg::Rgba color() {
        skip();
        if (at_ + 7 > text_.size() || text_[at_] != '#') {
            fail("a color, #rrggbb");
        }
        unsigned value = 0;
        const char* const begin = text_.data() + at_ + 1;
        const auto [end, error] = std::from_chars(begin, begin + 6, value, 16);
        if (error != std::errc() || end != begin + 6) {
            fail("a color, #rrggbb");
        }
        at_ += 7;
        const auto part = [&](unsigned shift) { return static_cast<float>(value >> shift & 255U) / 255.0F; };
        return {part(16), part(8), part(0), 1};
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

}  // namespace

Depiction read_depiction(const std::string& text) {
    return Reader(text).read();
}

}  // namespace ui

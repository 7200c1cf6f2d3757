// == of values.
#include <algorithm>
#include <bit>

#include "csg/scad/value/object.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

namespace {

using Values = std::span<const Value>;

/// What a list or an object consists of.
Values parts_of(const Value& value) {
    return value.is_object() ? value.entries().values() : value.elements();
}

bool is_compound(const Value& value) {
    return value.is_vector() || value.is_object();
}

/// Whether two values that may have parts can be equal at all: of one type, of one size, of the same keys in order.
bool same_shape(const Value& a, const Value& b) {
    if (a.type() != b.type() || parts_of(a).size() != parts_of(b).size()) {
        return false;
    }
    return !a.is_object() || std::equal(a.entries().keys().begin(), a.entries().keys().end(),
                                        b.entries().keys().begin(), b.entries().keys().end());
}

bool equal_ranges(const Range& r, const Range& s) {
    const std::uint32_t m = r.count();
    return m == s.count() && (m == 0 || (r.begin == s.begin && (m == 1 || r.step == s.step)));
}

/// A function equals itself only; a method, the same function of the same object.
bool equal_functions(const FunctionObject& f, const FunctionObject& g) {
    if (&f == &g || !f.is_method() || !g.is_method()) {
        return &f == &g;
    }
    const auto &m = static_cast<const MethodObject&>(f), &n = static_cast<const MethodObject&>(g);
    return &m.function.function() == &n.function.function() && &m.self.entries() == &n.self.entries();
}

bool equal_simple(const Value& a, const Value& b) {
    if (a.type() != b.type()) {
        return false;
    }
    switch (a.type()) {
        case ValueType::Bool:
            return a.boolean() == b.boolean();
        case ValueType::Number:
            return a.number() == b.number();
        case ValueType::String:
            return a.string() == b.string();
        case ValueType::Range:
            return equal_ranges(a.range(), b.range());
        case ValueType::Function:
            return equal_functions(a.function(), b.function());
        default:
            return true;
    }
}

/// Goes through pairs of lists; those that nest deep are set aside, so that they need no deep stack.
class Comparison {
  public:
    bool run(const Value& a, const Value& b) {
        if (!compare(a, b, 0)) {
            return false;
        }
        while (!pending_.empty()) {
            const auto [x, y] = pending_.back();
            pending_.pop_back();
            if (!compare(x, y, 0)) {
                return false;
            }
        }
        return true;
    }

  private:
    static constexpr int kMostDepth = 32;
    static constexpr std::size_t kMostPairs = 50'000'000;

    bool compare(const Value& a, const Value& b, int depth) {
        if (!is_compound(a) || !is_compound(b)) {
            return equal_simple(a, b);
        }
        if (!same_shape(a, b)) {
            return false;
        }
        const Values x = parts_of(a), y = parts_of(b);
        return depth < kMostDepth ? compare(x, y, depth + 1) : (pending_.emplace_back(x, y), true);
    }

    bool compare(Values x, Values y, int depth) {
        note_values(x.size() + 1);
        if (++pairs_ > kMostPairs) {
            throw ValueLimit("The lists are too large to compare");
        }
        for (std::size_t i = 0; i < x.size(); ++i) {
            const bool same =
                x[i].is_number() && y[i].is_number() ? x[i].number() == y[i].number() : compare(x[i], y[i], depth);
            if (!same) {
                return false;
            }
        }
        return true;
    }

    std::size_t pairs_ = 0;
    std::vector<std::pair<Values, Values>> pending_;
};

/// Counts down `budget` by what it looks at.
bool identical_within(const Value& a, const Value& b, std::size_t& budget) {
    if (a.type() != b.type() || budget == 0) {
        return false;
    }
    --budget;
    switch (a.type()) {
        case ValueType::Bool:
            return a.boolean() == b.boolean();
        case ValueType::Number:
            return std::bit_cast<std::uint64_t>(a.number()) == std::bit_cast<std::uint64_t>(b.number());
        case ValueType::String:
            return &a.string() == &b.string() || a.string() == b.string();
        case ValueType::Vector: {
            const Values x = a.elements(), y = b.elements();
            return x.size() == y.size() &&
                   (x.data() == y.data() ||
                    std::equal(x.begin(), x.end(), y.begin(),
                               [&](const Value& v, const Value& w) { return identical_within(v, w, budget); }));
        }
        case ValueType::Range:
            return &a.range() == &b.range();
        case ValueType::Function:
            return &a.function() == &b.function();
        case ValueType::Object:
            return &a.entries() == &b.entries();
        default:
            return true;
    }
}

}  // namespace

bool identical(const Value& a, const Value& b) {
    std::size_t budget = 64;
    return identical_within(a, b, budget);
}

bool equal(const Value& a, const Value& b) {
    return is_compound(a) && is_compound(b) ? Comparison().run(a, b) : equal_simple(a, b);
}

}  // namespace csg::scad

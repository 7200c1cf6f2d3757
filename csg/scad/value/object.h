// Objects: values by name. What `object()`, `textmetrics()` and `import()` of JSON give.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "csg/scad/value/value.h"

namespace csg::scad {

/// The entries of an object, in the order in which their keys were set.
class ObjectEntries {
  public:
    [[nodiscard]] std::size_t size() const { return keys_.size(); }
    [[nodiscard]] std::span<const std::string> keys() const { return keys_; }
    /// Of the keys, in their order.
    [[nodiscard]] std::span<const Value> values() const { return values_; }
    /// Null where there is no such key. Holds until an entry is set or removed.
    [[nodiscard]] const Value* find(std::string_view key) const;

    void set(std::string_view key, Value value);
    /// Leaves a gap, which counts as an entry until `close_gaps`.
    void remove(std::string_view key);
    /// To be called after removing, before anybody looks at keys and values.
    void close_gaps();
    /// Moves the values to the end of `out`; only the keys are left.
    void take_values(std::vector<Value>& out);

  private:
    [[nodiscard]] std::optional<std::size_t> index_of(std::string_view key) const;
    void enter(std::size_t index);

    std::vector<std::string> keys_;
    std::vector<Value> values_;                                    ///< Unset in a gap.
    std::unordered_multimap<std::size_t, std::uint32_t> by_hash_;  ///< Only once there are many.
    std::size_t gaps_ = 0;
};

/// A function that was taken out of an object and has a parameter `this`, which is that object whenever it is called.
/// Made when the entry is looked up, so that an object never holds itself.
struct MethodObject final : FunctionObject {
    /// `function` is no method itself; `self` is an object.
    MethodObject(Value f, Value s) : FunctionObject(true), function(std::move(f)), self(std::move(s)) {}
    [[nodiscard]] std::string text() const override { return function.function().text(); }
    void take_captures(std::vector<Value>& out) override;
    [[nodiscard]] bool is_method() const override { return true; }
    Value function;
    Value self;
};

/// `object.key`, `object["key"]`: undef where there is no such key; functions with a parameter `this` as methods.
[[nodiscard]] Value member_of_object(const Value& object, std::string_view key);

}  // namespace csg::scad

#include "csg/scad/value/object.h"

#include <algorithm>
#include <iterator>

namespace csg::scad {

namespace {

constexpr std::size_t kFew = 16;  // Looked through one by one.

std::size_t hash_of(std::string_view key) {
    return std::hash<std::string_view>()(key);
}

}  // namespace

std::optional<std::size_t> ObjectEntries::index_of(std::string_view key) const {
    if (keys_.size() <= kFew) {
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            if (keys_[i] == key && !values_[i].is_unset()) {
                return i;
            }
        }
        return std::nullopt;
    }
    const auto [begin, end] = by_hash_.equal_range(hash_of(key));
    const auto found = std::find_if(
        begin, end, [&](const auto& entry) { return keys_[entry.second] == key && !values_[entry.second].is_unset(); });
    return found == end ? std::nullopt : std::optional<std::size_t>(found->second);
}

const Value* ObjectEntries::find(std::string_view key) const {
    const auto index = index_of(key);
    return index ? &values_[*index] : nullptr;
}

void ObjectEntries::enter(std::size_t index) {
    by_hash_.emplace(hash_of(keys_[index]), static_cast<std::uint32_t>(index));
}

void ObjectEntries::set(std::string_view key, Value value) {
    if (const auto index = index_of(key)) {
        values_[*index] = std::move(value);
        return;
    }
    keys_.emplace_back(key);
    values_.push_back(std::move(value));
    if (keys_.size() == kFew + 1) {
        for (std::size_t i = 0; i < kFew; ++i) {
            enter(i);
        }
    }
    if (keys_.size() > kFew) {
        enter(keys_.size() - 1);
    }
}

void ObjectEntries::remove(std::string_view key) {
    const auto index = index_of(key);
    if (!index) {
        return;
    }
    values_[*index] = Value::unset();
    if (++gaps_ > kFew && 2 * gaps_ > keys_.size()) {
        close_gaps();
    }
}

void ObjectEntries::close_gaps() {
    if (gaps_ == 0) {
        return;
    }
    ObjectEntries kept;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        if (!values_[i].is_unset()) {
            kept.set(keys_[i], std::move(values_[i]));
        }
    }
    *this = std::move(kept);
}

void ObjectEntries::take_values(std::vector<Value>& out) {
    out.insert(out.end(), std::make_move_iterator(values_.begin()), std::make_move_iterator(values_.end()));
    values_.clear();
}

void MethodObject::take_captures(std::vector<Value>& out) {
    out.push_back(std::move(function));
    out.push_back(std::move(self));
}

Value member_of_object(const Value& object, std::string_view key) {
    const Value* const found = object.entries().find(key);
    if (found == nullptr || !found->is_function() || !found->function().takes_this) {
        return found == nullptr ? Value() : *found;
    }
    const FunctionObject& function = found->function();
    return Value(
        new MethodObject(function.is_method() ? static_cast<const MethodObject&>(function).function : *found, object));
}

}  // namespace csg::scad

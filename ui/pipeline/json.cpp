#include "ui/pipeline/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace ui {

namespace {

bool is_member(const Json& item) {
    return item.items().size() == 2 && item.items()[0].text() != nullptr;
}

/// Recurses as deeply as the value is nested.
Json converted(const nlohmann::ordered_json& value) {
    if (value.is_array()) {
        Json array = Json::array();
        for (const auto& item : value) {
            array.push_back(converted(item));
        }
        return array;
    }
    if (value.is_object()) {
        Json object = Json::object();
        for (const auto& [name, member] : value.items()) {
            object[name] = converted(member);
        }
        return object;
    }
    return value.is_string()            ? Json(value.get_ref<const std::string&>())
           : value.is_boolean()         ? Json(value.get<bool>())
           : value.is_number_unsigned() ? Json(value.get<std::uint64_t>())
           : value.is_number_integer()  ? Json(value.get<std::int64_t>())
           : value.is_number()          ? Json(value.get<double>())
                                        : Json(nullptr);
}

}  // namespace

Json::Json(std::nullptr_t) : value_(nullptr) {}
Json::Json(std::string text) : value_(std::move(text)) {}
Json::Json(std::string_view text) : value_(std::string(text)) {}
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json::Json(std::initializer_list<Json> items) {
    if (!std::all_of(items.begin(), items.end(), is_member)) {
        value_ = Array(items);
        return;
    }
    Object& members = value_.emplace<Object>();
    for (const Json& item : items) {
        members.emplace_back(*item.items()[0].text(), item.items()[1]);
    }
}

Json Json::read(std::string_view text, int deepest) {
    using Event = nlohmann::ordered_json::parse_event_t;
    return converted(nlohmann::ordered_json::parse(
        text, [&](int depth, Event, nlohmann::ordered_json&) { return depth < deepest; }, false));
}

Json Json::array() {
    Json json;
    json.value_ = Array();
    return json;
}

Json Json::object() {
    Json json;
    json.value_ = Object();
    return json;
}

bool Json::is_null() const {
    return std::holds_alternative<std::nullptr_t>(value_);
}

bool Json::is_object() const {
    return std::holds_alternative<Object>(value_);
}

bool Json::is_fraction() const {
    return std::holds_alternative<double>(value_);
}

bool Json::truth() const {
    return std::get<bool>(value_);
}

double Json::fraction() const {
    return std::get<double>(value_);
}

const std::string* Json::text() const {
    return std::get_if<std::string>(&value_);
}

const Json::Array& Json::items() const {
    static const Array kNone;
    const auto* array = std::get_if<Array>(&value_);
    return array != nullptr ? *array : kNone;
}

const Json::Object& Json::members() const {
    static const Object kNone;
    const auto* object = std::get_if<Object>(&value_);
    return object != nullptr ? *object : kNone;
}

const Json* Json::find(std::string_view name) const {
    const auto found = std::ranges::find(members(), name, &Object::value_type::first);
    return found != members().end() ? &found->second : nullptr;
}

Json& Json::operator[](std::string_view name) {
    if (is_null()) {
        value_ = Object();
    }
    Object& object = std::get<Object>(value_);
    const auto found = std::ranges::find(object, name, &Object::value_type::first);
    return found != object.end() ? found->second : object.emplace_back(name, nullptr).second;
}

void Json::push_back(Json item) {
    if (is_null()) {
        value_ = Array();
    }
    std::get<Array>(value_).push_back(std::move(item));
}

void Json::erase(std::string_view name) {
    std::erase_if(std::get<Object>(value_), [&](const auto& member) { return member.first == name; });
}

void Json::update(const Json& other) {
    for (const auto& [name, value] : other.members()) {
        (*this)[name] = value;
    }
}

std::string Json::dump(int indent) const {
    // Nested as deeply as the program's own structures are.
    const auto convert = [](const auto& self, const Json& json) -> nlohmann::ordered_json {
        if (std::holds_alternative<Array>(json.value_)) {
            auto array = nlohmann::ordered_json::array();
            for (const Json& item : json.items()) {
                array.push_back(self(self, item));
            }
            return array;
        }
        if (std::holds_alternative<Object>(json.value_)) {
            auto object = nlohmann::ordered_json::object();
            for (const auto& [name, value] : json.members()) {
                object[name] = self(self, value);
            }
            return object;
        }
        return std::visit(
            [](const auto& value) -> nlohmann::ordered_json {
                if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, Array> &&
                              !std::is_same_v<std::decay_t<decltype(value)>, Object>) {
                    return value;
                }
                return nullptr;
            },
            json.value_);
    };
    return convert(convert, *this).dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace ui

// Values of JSON. Only json.cpp includes the library that reads and writes them, which takes seconds to compile.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ui {

/// Null, a truth value, a number, a text, an array, or an object, whose members stay in the order in which they came.
class Json {
  public:
    using Array = std::vector<Json>;
    using Object = std::vector<std::pair<std::string, Json>>;

    Json(std::nullptr_t = nullptr);
    Json(std::same_as<bool> auto value) : value_(value) {}
    Json(std::signed_integral auto value) : value_(static_cast<std::int64_t>(value)) {}
    Json(std::unsigned_integral auto value) requires(!std::same_as<decltype(value), bool>)
        : value_(static_cast<std::uint64_t>(value)) {}
    Json(std::floating_point auto value) : value_(static_cast<double>(value)) {}
    Json(std::string text);
    Json(std::string_view text);
    Json(const char* text);
    /// {{"name", value}, …} is an object, every other list an array.
    Json(std::initializer_list<Json> items);
    Json(const Json&);
    Json(Json&&) noexcept;
    Json& operator=(const Json&);
    Json& operator=(Json&&) noexcept;
    ~Json();

    /// Of a text; null where it is no JSON. What is nested more than `deepest` levels is left out.
    [[nodiscard]] static Json read(std::string_view text, int deepest);
    [[nodiscard]] static Json array();
    [[nodiscard]] static Json object();

    [[nodiscard]] bool is_null() const;
    [[nodiscard]] bool is_object() const;
    [[nodiscard]] bool is_fraction() const;  ///< A number that was not an integer's.
    /// Of a truth value, and of a number of is_fraction().
    [[nodiscard]] bool truth() const;
    [[nodiscard]] double fraction() const;
    /// Of a text; null of others.
    [[nodiscard]] const std::string* text() const;
    /// Of an array; of others none.
    [[nodiscard]] const Array& items() const;
    /// Of an object; of others none.
    [[nodiscard]] const Object& members() const;
    /// The member of that name; null where there is none.
    [[nodiscard]] const Json* find(std::string_view name) const;

    /// The member of that name, added where there was none; what is null becomes an object.
    Json& operator[](std::string_view name);
    /// What is null becomes an array.
    void push_back(Json item);
    void erase(std::string_view name);
    /// Takes over all members of another object; those that are there already keep their places.
    void update(const Json& other);

    /// As text, on one line or with lines indented by `indent` blanks; what is not UTF-8 becomes U+FFFD.
    [[nodiscard]] std::string dump(int indent = -1) const;

  private:
    std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> value_;
};

}  // namespace ui

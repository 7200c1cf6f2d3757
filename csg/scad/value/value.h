// Values of the language: small, shared, immutable once shared.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace csg::scad {

class Value;
class ObjectEntries;

/// A variable that has no value yet is `Unset`; no expression ever yields it.
enum class ValueType : std::uint8_t { Unset, Undef, Bool, Number, String, Vector, Range, Function, Object };

/// "undefined", "bool", "number", … as in OpenSCAD's messages.
[[nodiscard]] std::string_view type_name(ValueType type);

/// The shared part of strings, vectors, ranges, functions and objects. Values belong to one thread: the count is not
/// atomic.
struct ValueObject {
    explicit ValueObject(ValueType t) : type(t) {}
    ValueObject(const ValueObject&) = delete;
    ValueObject& operator=(const ValueObject&) = delete;
    std::uint32_t references = 1;
    const ValueType type;

  protected:
    ~ValueObject() = default;
};

/// The shared part of lists: where the elements lie. value.cpp knows the rest of it.
struct ListObject : ValueObject {
    ListObject() : ValueObject(ValueType::Vector) {}
    Value* data = nullptr;
    std::size_t size = 0;

  protected:
    ~ListObject() = default;
};

/// begin, begin + step, … up to and including end.
struct Range {
    double begin = 0;
    double step = 1;
    double end = 0;

    /// How many numbers it holds; saturates at 2^32-1, which also stands for a range that never ends. 0 for NaN.
    [[nodiscard]] std::uint32_t count() const;
    [[nodiscard]] double at(std::uint32_t i) const { return i == 0 ? begin : begin + step * i; }
};

/// What a function value is made of. Evaluators derive from it.
struct FunctionObject : ValueObject {
    explicit FunctionObject(bool takes) : ValueObject(ValueType::Function), takes_this(takes) {}
    virtual ~FunctionObject() = default;
    /// As echo prints it.
    [[nodiscard]] virtual std::string text() const = 0;
    /// Moves the captured values to `out`, so that they can be destroyed without recursion.
    virtual void take_captures(std::vector<Value>& out) = 0;
    /// Whether it has a parameter `this`: taken out of an object it becomes a method (object.h).
    const bool takes_this;
    /// Whether it is a MethodObject.
    [[nodiscard]] virtual bool is_method() const { return false; }
};

class Value {
  public:
    Value() : type_(ValueType::Undef), bits_(0) {}
    Value(bool b) : type_(ValueType::Bool), bits_(b) {}
    Value(double number) : type_(ValueType::Number), number_(number) {}
    Value(int number) : Value(static_cast<double>(number)) {}
    Value(std::string text);
    Value(const char* text) : Value(std::string(text)) {}
    Value(std::vector<Value> elements);
    Value(const Range& range);
    explicit Value(ObjectEntries entries);
    // Constants of a program, which are kept from run to run and may meet their end on another thread: they do not
    // count as elements that are alive.
    [[nodiscard]] static Value lasting(std::string text);
    [[nodiscard]] static Value lasting(std::span<Value> elements);
    /// Takes over one reference.
    explicit Value(FunctionObject* function) : type_(ValueType::Function), object_(function) {}
    /// A list of the elements, which are moved out: one allocation, for the short lists that most are.
    [[nodiscard]] static Value list(std::span<Value> elements);
    /// A list of what `make` gives for 0, 1, … `count` - 1.
    template <typename F>
    [[nodiscard]] static Value list_of(std::size_t count, F&& make);
    [[nodiscard]] static Value unset() {
        Value v;
        v.type_ = ValueType::Unset;
        return v;
    }

    Value(const Value& other) noexcept : type_(other.type_), bits_(other.bits_) {
        if (shared()) {
            ++object_->references;
        }
    }
    Value(Value&& other) noexcept : type_(std::exchange(other.type_, ValueType::Undef)), bits_(other.bits_) {}
    Value& operator=(const Value& other) noexcept {
        if (other.shared()) {
            ++other.object_->references;
        }
        replace(other.type_, other.bits_);
        return *this;
    }
    Value& operator=(Value&& other) noexcept {
        replace(std::exchange(other.type_, ValueType::Undef), other.bits_);
        return *this;
    }
    // Spare a temporary where most values go.
    Value& operator=(std::same_as<double> auto number) noexcept {
        drop();
        type_ = ValueType::Number;
        number_ = number;
        return *this;
    }
    Value& operator=(std::same_as<bool> auto b) noexcept {
        drop();
        type_ = ValueType::Bool;
        bits_ = b;
        return *this;
    }
    ~Value() {
        if (shared()) {
            release(type_, object_);
        }
    }
    /// Lets go of what it shares, if anything; the value is any then.
    void drop() noexcept {
        if (shared()) {
            release(std::exchange(type_, ValueType::Undef), object_);
        }
    }
    // For dismantling (value.cpp) what is shared. The value becomes undef; gives the object where that was the last
    // reference to it, which is then the caller's.
    [[nodiscard]] ValueObject* last_reference() noexcept;
    /// Takes over an object that nobody refers to.
    [[nodiscard]] static Value adopt(ValueObject* object);
    void swap(Value& other) noexcept {
        std::swap(type_, other.type_);
        std::swap(bits_, other.bits_);
    }

    [[nodiscard]] ValueType type() const { return type_; }
    [[nodiscard]] bool is_unset() const { return type_ == ValueType::Unset; }
    [[nodiscard]] bool is_undef() const { return type_ == ValueType::Undef; }
    [[nodiscard]] bool is_bool() const { return type_ == ValueType::Bool; }
    [[nodiscard]] bool is_number() const { return type_ == ValueType::Number; }
    [[nodiscard]] bool is_string() const { return type_ == ValueType::String; }
    [[nodiscard]] bool is_vector() const { return type_ == ValueType::Vector; }
    [[nodiscard]] bool is_range() const { return type_ == ValueType::Range; }
    [[nodiscard]] bool is_function() const { return type_ == ValueType::Function; }
    [[nodiscard]] bool is_object() const { return type_ == ValueType::Object; }

    // Each of these requires the type.
    [[nodiscard]] bool boolean() const { return bits_ != 0; }
    [[nodiscard]] double number() const { return number_; }
    [[nodiscard]] const std::string& string() const;
    [[nodiscard]] std::span<const Value> elements() const;
    [[nodiscard]] const Range& range() const;
    [[nodiscard]] FunctionObject& function() const { return *static_cast<FunctionObject*>(object_); }
    [[nodiscard]] const ObjectEntries& entries() const;

    /// Number of code points of a string.
    [[nodiscard]] std::size_t length() const;
    /// undef, false, 0, "", [] and an object without entries are false; all else is true.
    [[nodiscard]] explicit operator bool() const;

    /// Vectors only: in place where nobody else holds the list, else to a copy of it.
    void append(Value element);

    static constexpr std::size_t kMostTextBytes = std::size_t{64} << 20;
    // Texts throw ValueLimit where they would be too long or lists nest too deep.

    /// As str() and nested in vectors: strings without quotes at top level, with quotes inside.
    [[nodiscard]] std::string text() const;
    /// As echo() prints it: strings in quotes.
    [[nodiscard]] std::string echo_text(std::size_t most_bytes = kMostTextBytes) const;

  private:
    [[nodiscard]] bool shared() const { return type_ >= ValueType::String; }
    /// An empty list with room for `count` elements.
    [[nodiscard]] static ListObject* make_room(std::size_t count);
    static void destroy(ValueType type, ValueObject* object);
    static void release(ValueType type, ValueObject* object) noexcept {
        if (--object->references == 0) {
            destroy(type, object);
        }
    }
    /// The new value is in place before the old one goes, which may be what it was taken from.
    void replace(ValueType type, std::uint64_t bits) noexcept {
        const ValueType old_type = std::exchange(type_, type);
        const std::uint64_t old_bits = std::exchange(bits_, bits);
        if (old_type >= ValueType::String) {
            release(old_type, std::bit_cast<ValueObject*>(old_bits));
        }
    }

    ValueType type_;
    union {
        double number_;
        ValueObject* object_;
        std::uint64_t bits_;
    };
};
static_assert(sizeof(Value) == 16);

inline std::span<const Value> Value::elements() const {
    const auto* const list = static_cast<const ListObject*>(object_);
    return {list->data, list->size};
}

template <typename F>
Value Value::list_of(std::size_t count, F&& make) {
    ListObject* const list = make_room(count);
    Value value;  // Which owns what there is, should one of them fail.
    value.object_ = list;
    value.type_ = ValueType::Vector;
    for (std::size_t i = 0; i < count; ++i) {
        new (list->data + i) Value(make(i));
        ++list->size;
    }
    return value;
}

/// == of the language: different types are never equal; undef equals undef. Throws ValueLimit where shared parts make
/// the lists too large to compare.
[[nodiscard]] bool equal(const Value& a, const Value& b);

/// Whether nothing can tell the two apart, as far as is quickly seen: false for lists and texts that are equal but
/// large or deep and no copies of each other.
[[nodiscard]] bool identical(const Value& a, const Value& b);

/// A number as OpenSCAD prints it: six significant digits, ("0.1", "1e+6", "inf", "nan", "0" for -0).
[[nodiscard]] std::string number_text(double number);

/// A value would grow beyond what is allowed, or is too deep or too long for what was asked of it.
class ValueLimit : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// How many list elements are alive on this thread; every 16 bytes of a string count as one.
[[nodiscard]] std::size_t live_elements();

/// How many may be alive on this thread: making one more list or string throws ValueLimit.
void limit_elements(std::size_t most);

/// Where the work on the values of this thread is to end: once `stop` asks for it, making lists and texts and going
/// through them throws base::Stopped.
void end_values_at(const std::stop_token& stop);

/// By what goes through many values: `count` more of them were looked at. Throws base::Stopped.
void note_values(std::size_t count);

// UTF-8. The first byte of a code point tells how long it is, as in OpenSCAD (GLib), even where what follows does not
// fit: whoever needs to know asks `is_valid_utf8`.
[[nodiscard]] std::size_t code_point_bytes(std::string_view text, std::size_t at);
[[nodiscard]] std::size_t code_point_count(std::string_view text);
[[nodiscard]] bool is_valid_utf8(std::string_view text);
/// U+FFFD where the bytes are invalid.
[[nodiscard]] char32_t decode_code_point(std::string_view text, std::size_t at);
void append_utf8(std::string& text, char32_t code_point);

}  // namespace csg::scad

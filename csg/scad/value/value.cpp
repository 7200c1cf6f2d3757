#include "csg/scad/value/value.h"

#include "base/stop.h"
#include "csg/scad/value/object.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <tuple>

namespace csg::scad {

namespace {

thread_local std::size_t g_live_elements = 0;
thread_local std::size_t g_most_elements = std::numeric_limits<std::size_t>::max();
thread_local std::size_t g_noted = 0;
thread_local std::stop_token g_stop;

constexpr std::size_t kLookedAt = 4096;  // Values between two looks at the token: some microseconds.

/// Counts `size` more elements in.
void count_in(std::size_t size) {
    if (size > g_most_elements || g_live_elements > g_most_elements - size) {
        throw ValueLimit("Lists hold more than " + std::to_string(g_most_elements) + " elements");
    }
    note_values(size);
    g_live_elements += size;
}

struct StringObject : ValueObject {
    explicit StringObject(std::string t, bool lasting = false)
        : ValueObject(ValueType::String),
          text(std::move(t)),
          length(code_point_count(text)),
          counted(lasting ? 0 : text.size() / sizeof(Value)) {
        count_in(counted);
    }
    ~StringObject() { g_live_elements -= counted; }
    const std::string text;
    const std::size_t length;
    const std::size_t counted;
};

/// Rooms for short lists, which programs make and drop by the million: cut from larger pieces, and kept for the next
/// ones of as many elements.
class ShortLists {
  public:
    static constexpr std::size_t kLongest = 16;
    ShortLists() = default;
    ~ShortLists() {
        ended_ = true;
        if (out_ != 0) {  // A list outlives its thread: so do the pieces.
            std::for_each(pieces_.begin(), pieces_.end(), [](auto& piece) { std::ignore = piece.release(); });
        }
    }
    ShortLists(const ShortLists&) = delete;
    ShortLists& operator=(const ShortLists&) = delete;

    [[nodiscard]] void* take(std::size_t elements, std::size_t bytes) {
        ++out_;
        Room*& first = free_[elements];
        return first == nullptr ? cut(bytes) : std::exchange(first, first->next);
    }
    void give(void* room, std::size_t elements) {
        if (!ended_) {
            --out_;
            free_[elements] = new (room) Room{free_[elements]};
        }
    }

  private:
    struct Room {
        Room* next;
    };
    static constexpr std::size_t kPiece = std::size_t{32} << 10;

    void* cut(std::size_t bytes) {
        if (left_ < bytes) {
            pieces_.push_back(std::make_unique_for_overwrite<std::byte[]>(kPiece));
            next_ = pieces_.back().get();
            left_ = kPiece;
        }
        left_ -= bytes;
        return std::exchange(next_, next_ + bytes);
    }

    std::array<Room*, kLongest + 1> free_{};
    std::vector<std::unique_ptr<std::byte[]>> pieces_;
    std::byte* next_ = nullptr;
    std::size_t left_ = 0;
    std::size_t out_ = 0;  // Rooms that are lists.
    bool ended_ = false;   // At the end of the thread.
};

thread_local ShortLists g_short_lists;

/// The elements lie right behind the object, or, once it has grown, in room of their own.
struct VectorObject : ListObject {
    /// Empty, with room for so many elements.
    static VectorObject* create(std::size_t elements) {
        count_in(elements);
        const std::size_t bytes = sizeof(VectorObject) + elements * sizeof(Value);
        void* const room =
            elements <= ShortLists::kLongest ? g_short_lists.take(elements, bytes) : ::operator new(bytes);
        return new (room) VectorObject(elements);
    }
    static VectorObject* create(std::span<Value> moved) {
        VectorObject* const list = create(moved.size());
        std::uninitialized_move(moved.begin(), moved.end(), list->data);
        list->size = moved.size();
        return list;
    }
    /// One that is not counted, and lies in no piece of the thread that makes it.
    static VectorObject* create_lasting(std::span<Value> moved) {
        void* const room = ::operator new(sizeof(VectorObject) + moved.size() * sizeof(Value));
        auto* const list = new (room) VectorObject(moved.size(), kLasting);
        std::uninitialized_move(moved.begin(), moved.end(), list->data);
        list->size = moved.size();
        return list;
    }
    static void remove(VectorObject* vector) {
        const std::size_t behind = vector->behind;
        vector->~VectorObject();
        if (behind <= ShortLists::kLongest) {
            g_short_lists.give(vector, behind);
        } else {
            ::operator delete(vector);
        }
    }
    void append(Value element) {
        count_in(1);
        if (size == room) {
            grow();
        }
        new (data + size) Value(std::move(element));
        ++size;
    }
    [[nodiscard]] std::span<Value> elements() const { return {data, size}; }

  private:
    static constexpr std::uint32_t kLasting = std::numeric_limits<std::uint32_t>::max();
    explicit VectorObject(std::size_t elements) : VectorObject(elements, static_cast<std::uint32_t>(elements)) {}
    VectorObject(std::size_t elements, std::uint32_t fit_behind)
        : room(static_cast<std::uint32_t>(elements)), behind(fit_behind) {
        data = first_behind();
    }
    ~VectorObject() {
        g_live_elements -= behind == kLasting ? 0 : size;
        std::destroy_n(data, size);
        if (data != first_behind()) {
            ::operator delete(data);
        }
    }
    [[nodiscard]] Value* first_behind() { return reinterpret_cast<Value*>(this + 1); }
    void grow() {
        const std::size_t larger = 2 * size + 4;
        auto* const moved = static_cast<Value*>(::operator new(larger * sizeof(Value)));
        std::uninitialized_move_n(data, size, moved);
        std::destroy_n(data, size);
        if (data != first_behind()) {
            ::operator delete(data);
        }
        data = moved;
        room = static_cast<std::uint32_t>(larger);
    }
    std::uint32_t room;          // How many elements fit where they lie.
    const std::uint32_t behind;  // How many fit behind the object; kLasting for one that never grows.
};
static_assert(sizeof(VectorObject) % alignof(Value) == 0);

struct RangeObject : ValueObject {
    explicit RangeObject(const Range& r) : ValueObject(ValueType::Range), range(r) {}
    const Range range;
};

/// Every entry counts as two elements.
struct EntriesObject : ValueObject {
    explicit EntriesObject(ObjectEntries e) : ValueObject(ValueType::Object), entries(std::move(e)) {
        entries.close_gaps();
        count_in(2 * entries.size());
    }
    ~EntriesObject() { g_live_elements -= 2 * entries.size(); }
    ObjectEntries entries;
};

}  // namespace

std::size_t live_elements() {
    return g_live_elements;
}

void limit_elements(std::size_t most) {
    g_most_elements = most;
}

void end_values_at(const std::stop_token& stop) {
    g_stop = stop;
}

void note_values(std::size_t count) {
    g_noted += count;
    if (g_noted >= kLookedAt) {
        g_noted = 0;
        base::end_if_asked(g_stop);
    }
}

std::string_view type_name(ValueType type) {
    switch (type) {
        case ValueType::Unset:
        case ValueType::Undef:
            return "undefined";
        case ValueType::Bool:
            return "bool";
        case ValueType::Number:
            return "number";
        case ValueType::String:
            return "string";
        case ValueType::Vector:
            return "vector";
        case ValueType::Range:
            return "range";
        case ValueType::Function:
            return "function";
        case ValueType::Object:
            return "object";
    }
    return "";
}

std::uint32_t Range::count() const {
    constexpr auto kMany = std::numeric_limits<std::uint32_t>::max();
    if (std::isnan(begin) || std::isnan(step) || std::isnan(end)) {
        return 0;
    }
    if (step < 0 ? begin < end : begin > end) {
        return 0;
    }
    if (step == 0) {
        return begin == end ? 0 : kMany;
    }
    if (begin == end || std::isinf(step)) {
        return 1;
    }
    if (std::isinf(begin) || std::isinf(end)) {
        return kMany;
    }
    // The quotient of 1 and 0.1 must count as 10 although it may round to just below: one step in the last place up.
    const double steps = std::nextafter((end - begin) / step, std::numeric_limits<double>::infinity());
    return steps >= kMany - 1.0 ? kMany : static_cast<std::uint32_t>(steps) + 1;
}

Value::Value(std::string text) : type_(ValueType::String), object_(new StringObject(std::move(text))) {}
Value::Value(std::vector<Value> elements) : type_(ValueType::Vector), object_(VectorObject::create(elements)) {}
Value Value::list(std::span<Value> elements) {
    Value value;
    value.object_ = VectorObject::create(elements);
    value.type_ = ValueType::Vector;
    return value;
}
Value Value::lasting(std::string text) {
    Value value;
    value.object_ = new StringObject(std::move(text), true);
    value.type_ = ValueType::String;
    return value;
}
Value Value::lasting(std::span<Value> elements) {
    Value value;
    value.object_ = VectorObject::create_lasting(elements);
    value.type_ = ValueType::Vector;
    return value;
}
ListObject* Value::make_room(std::size_t count) {
    return VectorObject::create(count);
}
Value::Value(const Range& range) : type_(ValueType::Range), object_(new RangeObject(range)) {}
Value::Value(ObjectEntries entries) : type_(ValueType::Object), object_(new EntriesObject(std::move(entries))) {}

const std::string& Value::string() const {
    return static_cast<StringObject*>(object_)->text;
}
const Range& Value::range() const {
    return static_cast<RangeObject*>(object_)->range;
}
const ObjectEntries& Value::entries() const {
    return static_cast<EntriesObject*>(object_)->entries;
}
std::size_t Value::length() const {
    return static_cast<StringObject*>(object_)->length;
}

Value::operator bool() const {
    switch (type_) {
        case ValueType::Unset:
        case ValueType::Undef:
            return false;
        case ValueType::Bool:
            return boolean();
        case ValueType::Number:
            return number_ != 0;
        case ValueType::String:
            return !string().empty();
        case ValueType::Vector:
            return !elements().empty();
        case ValueType::Object:
            return entries().size() != 0;
        case ValueType::Range:
        case ValueType::Function:
            return true;
    }
    return false;
}

void Value::append(Value element) {
    if (object_->references != 1) {
        const auto old = elements();
        *this = Value(std::vector<Value>(old.begin(), old.end()));
    }
    static_cast<VectorObject*>(object_)->append(std::move(element));
}

namespace {

/// Lists, objects and closures nest without bound: those that lie deep are set aside and dismantled in a loop.
class Dismantling {
  public:
    void run(ValueType type, ValueObject* object) {
        dismantle(type, object, 0);
        while (!pending_.empty()) {
            Value value = std::move(pending_.back());
            pending_.pop_back();
            drop(value, 0);
        }
    }

  private:
    static constexpr int kMostDepth = 32;

    void drop(Value& value, int depth) {
        if (value.type() < ValueType::Vector || value.type() == ValueType::Range) {
            value.drop();
        } else if (ValueObject* const object = value.last_reference()) {
            if (depth < kMostDepth) {
                dismantle(object->type, object, depth + 1);
            } else {
                pending_.push_back(Value::adopt(object));
            }
        }
    }

    void dismantle(ValueType type, ValueObject* object, int depth) {
        if (type == ValueType::Vector) {
            auto* const vector = static_cast<VectorObject*>(object);
            for (Value& element : vector->elements()) {
                drop(element, depth);
            }
            VectorObject::remove(vector);
        } else if (type == ValueType::Function) {
            auto* const function = static_cast<FunctionObject*>(object);
            function->take_captures(pending_);
            delete function;
        } else {
            auto* const entries = static_cast<EntriesObject*>(object);
            entries->entries.take_values(pending_);
            delete entries;
        }
    }

    std::vector<Value> pending_;
};

}  // namespace

void Value::destroy(ValueType type, ValueObject* object) {
    switch (type) {
        case ValueType::String:
            delete static_cast<StringObject*>(object);
            return;
        case ValueType::Range:
            delete static_cast<RangeObject*>(object);
            return;
        default:
            Dismantling().run(type, object);
    }
}

ValueObject* Value::last_reference() noexcept {
    type_ = ValueType::Undef;
    return --object_->references == 0 ? object_ : nullptr;
}

Value Value::adopt(ValueObject* object) {
    Value value;
    object->references = 1;
    value.type_ = object->type;
    value.object_ = object;
    return value;
}

}  // namespace csg::scad

#include "csg/scad/builtin/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "csg/scad/value/object.h"

namespace csg::scad {

namespace {

/// Takes the parser's events; nothing recurses, however deep the text nests.
class ValueMaker : public nlohmann::json_sax<nlohmann::json> {
  public:
    bool null() override { return add(Value()); }
    bool boolean(bool b) override { return add(b); }
    bool number_integer(number_integer_t n) override { return add(static_cast<double>(n)); }
    bool number_unsigned(number_unsigned_t n) override { return add(static_cast<double>(n)); }
    bool number_float(number_float_t n, const string_t&) override { return add(n); }
    bool string(string_t& text) override { return add(std::move(text)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(); }
    bool start_array(std::size_t) override { return open(); }
    bool key(string_t& key) override {
        key_ = std::move(key);
        return true;
    }
    bool end_array() override {
        std::vector<Value> elements;
        for (Entry& entry : open_.back().entries) {
            elements.push_back(std::move(entry.second));
        }
        return close(std::move(elements));
    }
    bool end_object() override {
        auto& entries = open_.back().entries;
        std::stable_sort(entries.begin(), entries.end(),
                         [](const Entry& a, const Entry& b) { return a.first < b.first; });
        ObjectEntries object;
        for (Entry& entry : entries) {
            object.set(entry.first, std::move(entry.second));
        }
        return close(Value(std::move(object)));
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override {
        error = e.what();
        if (const std::size_t at = error.find("line "); at != std::string::npos) {
            error.erase(0, at);  // The parser's name for the error says nothing to people.
        }
        return false;
    }

    Value result;
    std::string error;

  private:
    using Entry = std::pair<std::string, Value>;  ///< Of an array: without a key.
    struct Open {
        std::string key;  ///< Where it goes to once it is whole.
        std::vector<Entry> entries;
    };

    bool open() {
        open_.push_back({std::exchange(key_, {}), {}});
        return true;
    }
    bool close(Value value) {
        key_ = std::move(open_.back().key);
        open_.pop_back();
        return add(std::move(value));
    }
    bool add(Value value) {
        note_values(1);
        if (open_.empty()) {
            result = std::move(value);
        } else {
            open_.back().entries.emplace_back(std::exchange(key_, {}), std::move(value));
        }
        return true;
    }

    std::vector<Open> open_;
    std::string key_;
};

}  // namespace

std::variant<Value, JsonError> parse_json(std::string_view text) {
    ValueMaker maker;
    if (!nlohmann::json::sax_parse(text, &maker)) {
        return JsonError{maker.error};
    }
    return std::move(maker.result);
}

}  // namespace csg::scad

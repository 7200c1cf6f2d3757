// Built-in functions of objects, and import() of JSON.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "csg/scad/builtin/builtin_functions.h"
#include "csg/scad/builtin/json.h"
#include "csg/scad/builtin/named_arguments.h"
#include "csg/scad/value/object.h"

namespace csg::scad {

namespace {

constexpr std::string_view kHelp =
    "In an unnamed list, entries must be [key,value] to set or [key] to delete. The key must be <string>.";

/// Sets or deletes what one entry of a list says. OpenSCAD's warning where it says nothing proper.
std::optional<std::string> edit(ObjectEntries& object, const Value& entry, std::size_t argument, std::size_t index) {
    if (!entry.is_vector()) {
        return fmt::format("object( Argument {} [Element {} <{}>] ) Entry type is not a list, it is <{}>. {}", argument,
                           index, type_name(entry.type()), type_name(entry.type()), kHelp);
    }
    const auto parts = entry.elements();
    if (parts.empty()) {
        return fmt::format("object(Argument {} [Element {} []]) Entry is empty. {}", argument, index, kHelp);
    }
    if (parts.size() > 2) {
        return fmt::format(
            "object(Argument {} [Element {} [...]]) Entry length is {}, must be 1 [key] or 2 [key,value]. {}", argument,
            index, parts.size(), kHelp);
    }
    if (!parts[0].is_string()) {
        return fmt::format(
            "object(Argument {} [Element {} [<{}>{}]]) The key of the entry is not <string> but <{}>. {}", argument,
            index, type_name(parts[0].type()), parts.size() == 1 ? "" : ",value", type_name(parts[0].type()), kHelp);
    }
    if (parts.size() == 1) {
        object.remove(parts[0].string());
    } else {
        object.set(parts[0].string(), parts[1]);
    }
    return std::nullopt;
}

/// An unnamed argument: another object, or a list of changes.
std::optional<std::string> merge(ObjectEntries& object, const Value& value, std::size_t argument) {
    if (value.is_object()) {
        const ObjectEntries& other = value.entries();
        for (std::size_t i = 0; i < other.size(); ++i) {
            object.set(other.keys()[i], other.values()[i]);
        }
        return std::nullopt;
    }
    if (!value.is_vector()) {
        return fmt::format(
            "object(Argument {} <{}>) An unnamed argument must be either <object> or <list>, it is <{}>. ", argument,
            type_name(value.type()), type_name(value.type()));
    }
    const auto entries = value.elements();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (auto problem = edit(object, entries[i], argument, i)) {
            return problem;
        }
    }
    return std::nullopt;
}

Value object(std::string_view, std::span<const Value> a, FunctionHost& host) {
    ObjectEntries result;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (const std::string_view key = host.argument_name(i); !key.empty()) {
            result.set(key, a[i]);
        } else if (auto problem = merge(result, a[i], i)) {
            host.warn(std::move(*problem));
            return {};
        }
    }
    return Value(std::move(result));
}

Value has_key(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 2, 2, "2", host) || !check_type(name, a, 0, ValueType::Object, host) ||
        !check_type(name, a, 1, ValueType::String, host)) {
        return {};
    }
    return a[0].entries().find(a[1].string()) != nullptr;
}

Value is_object(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, 1, "1", host)) {
        return {};
    }
    return a[0].is_object();
}

Value import(std::string_view, std::span<const Value> a, FunctionHost& host) {
    static constexpr std::array<std::string_view, 1> kParameters{"file"};
    const NamedArguments arguments(a, kParameters, host);
    const std::string path = host.data_file(arguments.text("file")).path;
    if (const auto known = host.imported.find(path); known != host.imported.end()) {
        return known->second;
    }
    const ReadResult text = host.read(path);
    if (std::holds_alternative<ReadError>(text)) {
        host.warn(fmt::format("Could not read file '{}'", path));
        return {};
    }
    auto result = parse_json(std::get<std::string>(text));
    if (const auto* error = std::get_if<JsonError>(&result)) {
        host.warn(fmt::format("Failed to parse file '{}': {}", path, error->text));
        return {};
    }
    return host.imported.emplace(path, std::get<Value>(std::move(result))).first->second;
}

constexpr std::array kObjects{
    FunctionEntry{"object", object},
    FunctionEntry{"has_key", has_key},
    FunctionEntry{"is_object", is_object},
    FunctionEntry{"import", import},
};

}  // namespace

std::span<const FunctionEntry> object_functions() {
    return kObjects;
}

}  // namespace csg::scad

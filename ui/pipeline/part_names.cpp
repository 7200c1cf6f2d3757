#include "ui/pipeline/part_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ui/pipeline/model.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

bool is_named(const std::string& part, const std::string& name) {
    if (!part.starts_with(name)) {
        return false;
    }
    const std::string rest = part.substr(name.size());
    return rest.empty() ||
           (rest.size() > 1 && rest[0] == ' ' && rest.find_first_not_of("0123456789", 1) == std::string::npos);
}

[[noreturn]] void throw_unknown(const csg::Scene& scene, const char* option, const std::string& name) {
    std::vector<std::string> names;
    for (const csg::Part& part : scene.parts) {
        names.push_back(part.name);
    }
    constexpr std::size_t kMostNamed = 12;
    std::vector<std::string> shown = names;
    if (shown.size() > kMostNamed) {
        shown.resize(kMostNamed);
        shown.emplace_back("…");
    }
    throw ModelError(fmt::format("{}: no part \"{}\".{}", option, name,
                                 suggestion(name, names,
                                            fmt::format(" There {} {}; --parts says what is one.",
                                                        shown.size() == 1 ? "is" : "are", fmt::join(shown, ", ")))));
}

}  // namespace

std::vector<csg::PartId> parts_named(const csg::Scene& scene, const char* option, const std::string& name) {
    std::vector<csg::PartId> found;
    for (csg::PartId id = 0; id < scene.parts.size(); ++id) {
        if (is_named(scene.parts[id].name, name)) {
            found.push_back(id);
        }
    }
    if (found.empty()) {
        throw_unknown(scene, option, name);
    }
    return found;
}

}  // namespace ui

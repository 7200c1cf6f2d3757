#include "ui/pipeline/part_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "npr/part_style.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

std::string unknown_part(const csg::Scene& scene, std::string_view option, std::string_view name) {
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
    const std::string all = fmt::format(" There {} {}; --parts says what is one.", shown.size() == 1 ? "is" : "are",
                                        fmt::join(shown, ", "));
    return fmt::format("{}: no part \"{}\".{}", option, name, suggestion(name, names, all));
}

std::vector<csg::PartId> parts_named(const csg::Scene& scene, const char* option, const std::string& name) {
    std::vector<csg::PartId> found;
    for (csg::PartId id = 0; id < scene.parts.size(); ++id) {
        if (npr::names_part(name, scene.parts[id].name)) {
            found.push_back(id);
        }
    }
    if (found.empty()) {
        throw ModelError(unknown_part(scene, option, name));
    }
    return found;
}

std::vector<csg::PartId> parts_selected(const csg::Scene& scene, std::string_view option,
                                        const npr::PartSelector& selector) {
    std::vector<csg::PartId> found;
    for (csg::PartId id = 0; id < scene.parts.size(); ++id) {
        const csg::Part& part = scene.parts[id];
        layers::PartLook look;
        look.name = part.name;
        look.color = {part.color.r, part.color.g, part.color.b, part.color.a};
        if (npr::selects(selector, look)) {
            found.push_back(id);
        }
    }
    if (found.empty()) {
        const std::string& name = selector.by_color ? selector.text : selector.name;
        throw ModelError(unknown_part(scene, option, name));
    }
    return found;
}

}  // namespace ui

#include "ui/pipeline/annotation/callouts.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace ui {

namespace {

/// "bolt" of "bolt 2"; "part 2" stays, since parts of that name have nothing else in common.
std::string common_name(const std::string& name) {
    const std::size_t blank = name.rfind(' ');
    const bool numbered = blank != std::string::npos && blank + 1 < name.size() &&
                          name.find_first_not_of("0123456789", blank + 1) == std::string::npos;
    const std::string base = numbered ? name.substr(0, blank) : name;
    return base == "part" ? name : base;
}

}  // namespace

std::vector<Callout> callouts_of(const csg::Scene& scene) {
    std::vector<Callout> callouts;
    std::map<std::string, std::size_t> known;
    for (csg::PartId id = 0; id < scene.parts.size(); ++id) {
        const csg::Part& part = scene.parts[id];
        // Glyphs of depictions come from no text.
        if (part.hidden || !scene.leaves[part.first_leaf].where.known() ||
            (part.kind != csg::PartKind::Solid && part.kind != csg::PartKind::Translucent)) {
            continue;
        }
        const std::string name = common_name(part.name);
        const auto [at, fresh] = known.try_emplace(name, callouts.size());
        if (fresh) {
            callouts.push_back({name, {}});
        }
        callouts[at->second].parts.push_back(id);
    }
    for (Callout& callout : callouts) {
        // Of ghosts there is the solid itself.
        const auto solid = [&](csg::PartId id) { return scene.parts[id].kind == csg::PartKind::Solid; };
        if (std::any_of(callout.parts.begin(), callout.parts.end(), solid)) {
            std::erase_if(callout.parts, [&](csg::PartId id) { return !solid(id); });
        }
        if (callout.parts.size() > 1) {
            callout.text += fmt::format(" ×{}", callout.parts.size());
        }
    }
    return callouts;
}

}  // namespace ui

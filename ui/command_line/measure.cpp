#include "ui/command_line/measure.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "ui/command_line/call_place.h"
#include "ui/command_line/files.h"
#include "ui/command_line/usage_error.h"
#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/inspection/measured_text.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

/// From texts to things of a model.
class Finder {
  public:
    Finder(const Model& model, const csg::scad::SourceSet& sources, const PickPixel& pick)
        : model_(model), sources_(sources), pick_(pick) {}

    Measured find(const ThingText& thing) {
        switch (thing.where) {
            case ThingText::Where::Point:
                return measured_point(thing.point);
            case ThingText::Where::Pixel:
                return at_pixel(thing);
            case ThingText::Where::Source:
                break;
        }
        return of_call(thing);
    }

  private:
    Measured at_pixel(const ThingText& thing) {
        const std::size_t wanted = std::max<std::size_t>(thing.number, 1);
        const auto surfaces = pick_(thing.pixel, static_cast<int>(wanted));
        if (surfaces.empty()) {
            refuse(thing, "there is nothing at that pixel");
        }
        if (surfaces.size() < wanted) {
            refuse(thing, fmt::format("behind that pixel there {} {} surface{}", surfaces.size() == 1 ? "is" : "are",
                                      surfaces.size(), surfaces.size() == 1 ? "" : "s"));
        }
        const PickedSurface& picked = surfaces[wanted - 1];
        if (thing.what == ThingText::What::Face) {
            return measured_face(model_, picked);
        }
        if (!edges_) {
            edges_.emplace(model_);
        }
        const bool corner = thing.what == ThingText::What::Corner;
        const auto found = corner ? edges_->corner(picked) : edges_->edge(picked);
        if (!found) {
            refuse(thing, corner ? "the face there has no corner" : "the face there has no edge");
        }
        return *found;
    }

    Measured of_call(const ThingText& thing) {
        const csg::SourceLocation where =
            call_at(*model_.tree, all_calls(*model_.tree), thing.option, thing.call, "call");
        const std::vector<csg::LeafId> leaves = leaves_of(where);
        if (leaves.empty()) {
            refuse(thing, "what is called there has no surface of its own in the model");
        }
        if (thing.number == 0 && leaves.size() > 1) {
            refuse(thing, fmt::format("{} shapes come from there: #1 to #{}", leaves.size(), leaves.size()));
        }
        if (thing.number > leaves.size()) {
            refuse(thing,
                   fmt::format("{} shape{} from there", leaves.size(), leaves.size() == 1 ? " comes" : "s come"));
        }
        const csg::LeafId leaf = leaves[std::max<std::size_t>(thing.number, 1) - 1];
        if (thing.towards) {
            return measured_face(model_, leaf, *thing.towards);
        }
        const auto round = measured_round(model_, leaf);
        if (!round) {
            const auto steps = steps_to(model_, model_.scene.leaves[leaf].occurrence);
            refuse(thing,
                   fmt::format("{} has no round surface, or several; name a face of it by where it looks: +z@{}{}",
                               call_text(model_, sources_, steps.back()), thing.call,
                               thing.number == 0 ? "" : fmt::format("#{}", thing.number)));
        }
        if (!round->form.remark.empty()) {
            refuse(thing, round->form.remark);
        }
        return *round;
    }

    /// Shapes with a surface, made by the call or below it, each place once.
    [[nodiscard]] std::vector<csg::LeafId> leaves_of(const csg::SourceLocation& where) const {
        std::vector<csg::LeafId> found;
        std::set<csg::OccurrenceId> known;
        const csg::Scene& scene = model_.scene;
        for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
            const csg::OccurrenceId occurrence = scene.leaves[leaf].occurrence;
            if (occurrence == csg::kNoOccurrence || model_.geometry.leaves[leaf].triangles.empty()) {
                continue;
            }
            const auto path = csg::path_to(scene, occurrence);
            const bool below = std::any_of(path.begin(), path.end(), [&](csg::OccurrenceId id) {
                return model_.tree->node(scene.occurrences[id].node).where == where;
            });
            if (below && known.insert(occurrence).second) {
                found.push_back(leaf);
            }
        }
        return found;
    }

    const Model& model_;
    const csg::scad::SourceSet& sources_;
    const PickPixel& pick_;
    std::optional<EdgeFinder> edges_;
};

std::optional<double> value_of(const Measured& thing, const std::string& name) {
    if (name == "length" && thing.kind == Measured::Kind::Edge) {
        return glm::distance(thing.from, thing.to);
    }
    const auto radius = thing.radius();
    return !radius              ? std::nullopt
           : name == "radius"   ? radius
           : name == "diameter" ? std::optional(2 * *radius)
                                : std::nullopt;
}

std::optional<double> value_of(const Relation& relation, const std::string& name) {
    return name == "distance"  ? relation.distance
           : name == "minimum" ? relation.least
           : name == "maximum" ? relation.most
           : name == "angle"   ? relation.degrees
                               : std::nullopt;
}

std::string value_line(const std::optional<double>& value, const std::string& name, const std::string& what) {
    if (!value) {
        throw UsageError(fmt::format("--value {}: there is none: {}", name, what));
    }
    return fmt::format("{:.12g}\n", *value);
}

}  // namespace

std::string measured_output(const MeasureOptions& options, const Model& model, const csg::scad::SourceSet& sources,
                            const PickPixel& pick) {
    Finder finder(model, sources, pick);
    std::string text;
    Json of = Json::array(), between = Json::array();
    const auto tell = [&](const char* option, const ThingText& named, const Measured& thing) {
        text += fmt::format("{} {}: {}\n{}", option, named.text, headline(thing), details(model, sources, thing));
    };
    for (const ThingText& named : options.of) {
        const Measured thing = finder.find(named);
        if (!options.value.empty()) {
            text += value_line(value_of(thing, options.value), options.value, headline(thing));
        } else {
            tell("of", named, thing);
        }
        of.push_back(to_json(model, sources, thing));
    }
    for (const auto& [first, second] : options.between) {
        const Measured a = finder.find(first), b = finder.find(second);
        const Relation relation = relation_of(a, b);
        if (!options.value.empty()) {
            text += value_line(value_of(relation, options.value), options.value,
                               fmt::format("{} and {}", headline(a), headline(b)));
        } else {
            tell("between", first, a);
            tell("and", second, b);
            text += relation_text(a, b, relation);
        }
        Json json = {{"a", to_json(model, sources, a)}, {"b", to_json(model, sources, b)}};
        json.update(to_json(relation));
        between.push_back(json);
    }
    return options.json ? text_of(Json{{"of", of}, {"between", between}}) : printable(text);
}

}  // namespace ui

#include "ui/pipeline/inspection/measured_text.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

using csg::solid::FormKind;
using csg::solid::SurfaceForm;

/// Seven digits; what is but rounding is 0.
std::string number(double value) {
    return fmt::format("{:.7g}", std::abs(value) < 1e-9 ? 0.0 : value);
}

std::string text_of(const glm::dvec3& p) {
    return fmt::format("[{}, {}, {}]", number(p.x), number(p.y), number(p.z));
}

const char* kind_of(const Measured& thing) {
    switch (thing.kind) {
        case Measured::Kind::Point:
            return "point";
        case Measured::Kind::Edge:
            return "edge";
        case Measured::Kind::Circle:
            return "circle";
        case Measured::Kind::Face:
            break;
    }
    return csg::solid::name(thing.form.kind);
}

bool is_round(const Measured& thing) {
    return thing.kind == Measured::Kind::Circle ||
           (thing.kind == Measured::Kind::Face && thing.form.kind != FormKind::Plane);
}

/// What stands for a circle comes so near to its middle.
std::optional<double> inner_radius(const Measured& thing) {
    const bool circle = thing.kind == Measured::Kind::Circle || thing.form.kind == FormKind::Cylinder;
    return is_round(thing) && circle && thing.form.segments > 0
               ? std::optional(thing.form.radius * std::cos(std::numbers::pi / thing.form.segments))
               : std::nullopt;
}

std::string where_it_lies(const Measured& thing) {
    const SurfaceForm& form = thing.form;
    switch (thing.kind) {
        case Measured::Kind::Point:
            return "";
        case Measured::Kind::Edge:
            return fmt::format("   from {} to {}\n", text_of(thing.from), text_of(thing.to));
        case Measured::Kind::Circle:
            return fmt::format("   center {}, axis along {}\n", text_of(form.point), text_of(form.direction));
        case Measured::Kind::Face:
            break;
    }
    switch (form.kind) {
        case FormKind::Plane:
            return fmt::format("   through {}, normal {}\n", text_of(thing.at), text_of(form.direction));
        case FormKind::Cylinder:
            return fmt::format("   axis through {} along {}\n", text_of(form.point), text_of(form.direction));
        case FormKind::Cone:
            return fmt::format("   apex {}, axis along {}\n", text_of(form.point), text_of(form.direction));
        case FormKind::Sphere:
            return fmt::format("   center {}\n", text_of(form.point));
        case FormKind::Torus:
            return fmt::format("   center {}, axis along {}\n", text_of(form.point), text_of(form.direction));
    }
    return "";
}

}  // namespace

std::string headline(const Measured& thing) {
    const SurfaceForm& form = thing.form;
    std::string text = kind_of(thing);
    if (thing.kind == Measured::Kind::Point) {
        return fmt::format("{} {}", text, text_of(thing.at));
    }
    if (thing.kind == Measured::Kind::Edge) {
        return fmt::format("{}, length {}", text, number(glm::distance(thing.from, thing.to)));
    }
    if (const auto radius = thing.radius()) {
        text += fmt::format(", radius {}, diameter {}", number(*radius), number(2 * *radius));
    }
    if (thing.kind == Measured::Kind::Face && form.kind == FormKind::Cone) {
        text += fmt::format(", angle at the apex {}°", number(2 * glm::degrees(form.half_angle)));
    }
    if (thing.kind == Measured::Kind::Face && form.kind == FormKind::Torus) {
        text += fmt::format(" of the tube, {} from the axis to its middle", number(form.ring_radius));
    }
    return text;
}

std::string details(const Model& model, const csg::scad::SourceSet& sources, const Measured& thing) {
    std::string text = where_it_lies(thing);
    if (is_round(thing) && !thing.form.exact) {
        text += fmt::format("   fitted: its corners are within {:.2g} of it\n", thing.form.deviation);
    } else if (const auto inner = inner_radius(thing)) {
        text += fmt::format("   as written; its {} sides come as near as {}\n", thing.form.segments, number(*inner));
    }
    if (!thing.form.remark.empty()) {
        text += fmt::format("   {}\n", thing.form.remark);
    }
    if (thing.leaf) {
        const auto steps = steps_to(model, model.scene.leaves[*thing.leaf].occurrence);
        if (!steps.empty()) {
            text += fmt::format("   of {}  {}\n", call_text(model, sources, steps.back()),
                                place_of(model, steps.back().node.where));
        }
    }
    return text;
}

std::string relation_text(const Measured& a, const Measured& b, const Relation& relation) {
    std::string text;
    if (relation.distance) {
        const glm::dvec3 way = relation.to - relation.from;
        text += fmt::format("distance {}\n", number(*relation.distance));
        text += fmt::format("   from {} to {}: {} along x, {} along y, {} along z\n", text_of(relation.from),
                            text_of(relation.to), number(way.x), number(way.y), number(way.z));
    } else {
        text += fmt::format("distance none: the {} and the {} are not parallel, and meet\n", kind_of(a), kind_of(b));
    }
    if (relation.most) {
        text += relation.least ? fmt::format("   between their surfaces {} at least, {} at most\n",
                                             number(*relation.least), number(*relation.most))
                               : fmt::format("   between their surfaces {} at most\n", number(*relation.most));
    }
    if (relation.degrees) {
        text += fmt::format("angle {}°{}\n", number(*relation.degrees), relation.parallel ? ", parallel" : "");
    }
    return text;
}

Json to_json(const Model& model, const csg::scad::SourceSet& sources, const Measured& thing) {
    const SurfaceForm& form = thing.form;
    Json json = {{"kind", kind_of(thing)}, {"at", to_json(thing.at)}};
    if (thing.kind == Measured::Kind::Edge) {
        json["length"] = glm::distance(thing.from, thing.to);
        json["from"] = to_json(thing.from);
        json["to"] = to_json(thing.to);
    }
    if (const auto radius = thing.radius()) {
        json["radius"] = *radius;
        json["diameter"] = 2 * *radius;
    }
    if (const auto inner = inner_radius(thing)) {
        json["inner_radius"] = *inner;
        json["sides"] = form.segments;
    }
    if (thing.kind == Measured::Kind::Face && form.kind == FormKind::Plane) {
        json["normal"] = to_json(form.direction);
    } else if (is_round(thing)) {
        const bool on_axis = thing.kind == Measured::Kind::Face && form.kind == FormKind::Cylinder;
        const bool apex = thing.kind == Measured::Kind::Face && form.kind == FormKind::Cone;
        json[on_axis ? "axis_point" : apex ? "apex" : "center"] = to_json(form.point);
        if (const auto direction = thing.direction()) {
            json["axis"] = to_json(*direction);
        }
        if (apex) {
            json["apex_angle"] = 2 * glm::degrees(form.half_angle);
        }
        if (thing.kind == Measured::Kind::Face && form.kind == FormKind::Torus) {
            json["ring_radius"] = form.ring_radius;
        }
        json["exact"] = form.exact;
        if (!form.exact) {
            json["deviation"] = form.deviation;
        }
    }
    if (!form.remark.empty()) {
        json["remark"] = form.remark;
    }
    if (thing.leaf) {
        const auto steps = steps_to(model, model.scene.leaves[*thing.leaf].occurrence);
        json["leaf"] = *thing.leaf;
        json["part"] = model.scene.parts[model.scene.leaves[*thing.leaf].part].name;
        json["call"] = steps.empty() ? Json(nullptr) : call_json(model, sources, steps.back());
    }
    return json;
}

Json to_json(const Relation& relation) {
    Json json = Json::object();
    if (relation.distance) {
        json["distance"] = *relation.distance;
        json["from"] = to_json(relation.from);
        json["to"] = to_json(relation.to);
    } else {
        json["distance"] = nullptr;
    }
    if (relation.least) {
        json["minimum"] = *relation.least;
    }
    if (relation.most) {
        json["maximum"] = *relation.most;
    }
    if (relation.degrees) {
        json["angle"] = *relation.degrees;
        json["parallel"] = relation.parallel;
    }
    return json;
}

}  // namespace ui

#include "ui/command_line/summary.h"

#include <cmath>

#include <fmt/format.h>

#include "ui/pipeline/inspection/layer_measures.h"
#include "ui/pipeline/picture/exact_bounds.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

Json time_json(double milliseconds) {
    const long total = std::lround(milliseconds);
    const long hours = total / 3'600'000, minutes = total / 60'000 % 60, seconds = total / 1000 % 60;
    return {{"time", fmt::format("{}:{:02}:{:02}.{:03}", hours, minutes, seconds, total % 1000)},
            {"total", total},
            {"milliseconds", total % 1000},
            {"seconds", seconds},
            {"minutes", minutes},
            {"hours", hours}};
}

Json box_json(const csg::Box& box) {
    if (box.empty()) {
        return nullptr;
    }
    const auto array = [](const glm::dvec3& v) { return Json{v.x, v.y, v.z}; };
    return {{"min", array(box.lo)}, {"max", array(box.hi)}, {"size", array(box.size())}};
}

Json to_json(const SolidMeasures& m) {
    return {{"volume", m.volume.value},
            {"volume_error", m.volume.error},
            {"area", m.area.value},
            {"area_error", m.area.error},
            {"centroid", ui::to_json(m.centroid)},
            {"centroid_error", m.centroid_error},
            {"moments", ui::to_json(m.moments)},
            {"moments_error", m.moments_error}};
}

/// The figures that were asked for.
Json geometry_json(const SummaryParts& parts, const Json& figures) {
    Json json = Json::object();
    for (const auto& [key, value] : figures.members()) {
        const bool told = key == "bounding_box" ? parts.bounding_box
                          : key == "area"       ? parts.area
                          : key == "volume"     ? parts.volume
                          : key == "dimensions" ? true
                                                : parts.geometry;
        if (told) {
            json[key] = value;
        }
    }
    return json;
}

}  // namespace

Json parts_json(const Model& model) {
    std::vector<csg::Box> boxes;
    for (const csg::solid::PlacedLeaf& leaf : model.geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    Json all = Json::array();
    for (const csg::Part& part : model.scene.parts) {
        all.push_back({{"name", part.name},
                       {"kind", csg::name(part.kind)},
                       {"color", part.color.given() ? Json(csg::color_name(part.color)) : Json(nullptr)},
                       {"leaves", part.leaf_count},
                       {"bounding_box", box_json(csg::bounds(model.scene, part, boxes))}});
    }
    return all;
}

Json measures_json(const Model& model, double precision, const std::stop_token& stop) {
    const LayerMeasures measures = measure_by_layers(model, precision, stop);
    Json json = to_json(measures.all);
    json["bounding_box"] = box_json(exact_bounds(model, stop));
    json["spacing"] = measures.spacing;
    Json parts = Json::array();
    for (csg::PartId id = 0; id < model.scene.parts.size(); ++id) {
        if (!measures.parts[id].box.empty()) {
            Json part = {{"name", model.scene.parts[id].name}};
            part.update(to_json(measures.parts[id]));
            part["bounding_box"] = box_json(measures.parts[id].box);
            parts.push_back(part);
        }
    }
    json["parts"] = parts;
    return json;
}

Json summary_json(const SummaryParts& parts, const SummaryFigures& figures) {
    Json json = Json::object();
    if (parts.cache) {
        json["cache"]["geometry_cache"] = {{"entries", figures.cache.entries}, {"bytes", figures.cache.bytes}};
    }
    if (parts.time) {
        json["time"] = time_json(figures.milliseconds);
    }
    if (parts.camera) {
        json["camera"] = to_json(figures.camera);
    }
    if (parts.bounding_box) {
        json["bounding_box"] = box_json(figures.box);
    }
    if (figures.geometry && (parts.geometry || parts.area || parts.volume)) {
        json["geometry"] = geometry_json(parts, *figures.geometry);
    }
    if (parts.parts) {
        json["parts"] = figures.parts;
    }
    if (parts.measures) {
        json["measures"] = figures.measures;
    }
    return json;
}

}  // namespace ui

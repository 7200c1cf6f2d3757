#include "ui/pipeline/statistics.h"

namespace ui {

Json to_json(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json to_json(const base::Camera& camera) {
    return {{"translation", to_json(camera.target)},
            {"rotation", to_json(camera.rotation)},
            {"distance", camera.distance},
            {"fov", camera.fov}};
}

Json to_json(const ModelStatistics& s) {
    return {{"parts", s.parts},
            {"leaves", s.leaves},
            {"triangles", s.triangles},
            {"planes", s.planes},
            {"products_before_pruning", s.products_unpruned},
            {"products", s.products},
            {"literals", s.literals},
            {"pruned_products", s.pruned_products},
            {"pruned_literals", s.pruned_literals},
            {"ms", {{"place", s.place_ms}, {"normalize", s.normalize_ms}}}};
}

namespace {

/// Swaps of each picture, in order.
Json sorts(const PictureStatistics& s) {
    Json swaps = Json::array(), from_nothing = Json::array();
    for (const npr::SortCount& count : s.sorts) {
        swaps.push_back(count.swaps);
        from_nothing.push_back(count.from_nothing);
    }
    return {{"triangles", s.sorted_triangles}, {"swaps", swaps}, {"swaps_from_nothing", from_nothing}};
}

}  // namespace

Json to_json(const PictureStatistics& s) {
    Json json = {{"engine", s.engine.engine->name},
                 {"engine_reason", s.engine.reason},
                 {"painter", s.opengl ? "opengl" : "cpu"},
                 {"samples", s.samples},
                 {"layers", s.walk.layers},
                 {"passes", s.walk.passes},
                 {"bands", s.walk.bands},
                 {"fragments", s.walk.fragments},
                 {"drawn_leaves", s.walk.drawn_leaves},
                 {"drawn_products", s.walk.drawn_products},
                 {"skipped_leaves", s.walk.skipped_leaves},
                 {"occluded_leaves", s.walk.occluded_leaves ? Json(*s.walk.occluded_leaves) : Json(nullptr)},
                 {"skipped_products", s.walk.skipped_products},
                 {"skipped_triangles", s.walk.skipped_triangles},
                 {"parity_slots", s.walk.slots},
                 {"longest_list", s.walk.longest_list},
                 {"pixel_memory", s.walk.memory},
                 {"peeled_away", s.revealed.layers},
                 {"revealed_share", s.revealed.share},
                 {"ms", {{"upload", s.upload_ms}, {"peel", s.peel_ms}, {"style", s.style_ms}, {"read", s.read_ms}}}};
    if (s.sorted_triangles > 0) {
        json["sorted"] = sorts(s);
    }
    return json;
}

}  // namespace ui

// Parameters of sorted transparency (docs/transparency/sorted.md).
#pragma once

#include "npr/settings.h"
#include "npr/sorted/blending.h"

namespace npr {

/// What is sorted, back to front.
enum class SortOrder : int {
    Triangles = 0,  ///< All triangles of all parts, in one list.
    Objects = 1,    ///< Parts; in each, its triangles.
    Parts = 2,      ///< Parts; their triangles are drawn as they come.
    None = 3,
};

struct SortedSettings {
    int order{};  ///< A SortOrder.
    bool depth_writes{};
    bool back_faces{};
    int src{}, dst{}, equation{};  ///< Of blend_factor_names() and blend_equation_names().
    int src_alpha{}, dst_alpha{}, alpha_equation{};
    glm::vec3 constant{};
    float constant_alpha{};
    bool premultiplied{};

    [[nodiscard]] Blending blending() const;
    static const SettingsTable<SortedSettings>& table();
};

}  // namespace npr

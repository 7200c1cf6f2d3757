#include "base/view_values.h"

#include <glm/gtc/matrix_transform.hpp>

namespace base {

ViewValues view_values(const View& view, const glm::dvec3& local_center, double diagonal) {
    ViewValues b;
    // Doubles become floats once, after the large translations have canceled.
    b.clip_from_local = glm::mat4(glm::translate(view.clip_from_world(), local_center));
    b.eye_from_world = glm::mat4(view.eye_from_world());
    b.picture = glm::vec4(glm::dvec4(glm::dvec2(view.size()), view.half_height(), view.near_distance()));
    b.depth_range = glm::vec4(glm::dvec4(view.near_distance(), view.orthographic() ? view.far_distance() : 0.0,
                                         view.orthographic() ? 1.0 : 0.0, diagonal));
    b.local_center = glm::vec4(glm::dvec4(local_center, 0.0));
    return b;
}

}  // namespace base

#include "gl/view_block.h"

namespace gl {

void ViewBlock::update(const base::View& view, const glm::dvec3& local_center, double diagonal) {
    const base::ViewValues values = base::view_values(view, local_center, diagonal);
    buffer_.upload_bytes(&values, sizeof values, GL_STREAM_DRAW);
}

}  // namespace gl

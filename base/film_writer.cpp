#include "base/film_writer.h"

#include <algorithm>

namespace base {

ImageRectangle difference(const Image& a, const Image& b) {
    int left = a.width, right = -1, top = a.height, bottom = -1;
    for (int y = 0; y < a.height; ++y) {
        const std::uint8_t *p = a.pixel(0, y), *q = b.pixel(0, y);
        for (int x = 0; x < a.width; ++x) {
            if (!std::equal(p + 4 * x, p + 4 * x + 4, q + 4 * x)) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = y;
            }
        }
    }
    return right < 0 ? ImageRectangle{} : ImageRectangle{left, top, right - left + 1, bottom - top + 1};
}

}  // namespace base

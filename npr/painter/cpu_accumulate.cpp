#include "npr/painter/cpu_accumulate.h"

#include <algorithm>

#include "base/parallel.h"
#include "npr/guard_band.h"
#include "npr/painter/cpu_shine.h"
#include "npr/srgb.h"

namespace npr {

void CpuAccumulator::paint_sample(const Paint& paint, const Picture& picture, std::size_t sample,
                                  const CpuSubject& subject, const std::stop_token& stop) {
    const Picture wide = with_guard_band(picture);
    if (sample == 0) {
        size_ = wide.size;
        guard_ = wide.guard;
        sum_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), glm::vec4(0));
    }
    samples_ = static_cast<int>(sample) + 1;
    const base::View view = sample_view(wide, sample, subject.lo, subject.hi);
    CpuFrame frame{wide, view, subject.peel(view), sum_, stop};
    frame.mesh = subject.mesh;
    frame.sample = static_cast<int>(sample);
    std::vector<ShineRow> shine;
    if (picture.transparency == Transparency::ViewDependent) {
        shine = find_shine(frame);
        frame.shine = shine;
    }
    std::vector<ShadowBits> shadows;
    if (subject.shadows && casts_shadows(picture)) {
        shadows = subject.shadows(view);
        frame.shadows = shadows;
    }
    paint(frame);
}

const glm::vec4* CpuAccumulator::shown_row(int y) const {
    return &sum_[static_cast<std::size_t>(y + guard_) * static_cast<std::size_t>(size_.x) +
                 static_cast<std::size_t>(guard_)];
}

std::vector<glm::vec4> CpuAccumulator::light() const {
    const glm::ivec2 shown = size_ - 2 * guard_;
    std::vector<glm::vec4> mean;
    mean.reserve(static_cast<std::size_t>(shown.x) * static_cast<std::size_t>(shown.y));
    for (int y = 0; y < shown.y; ++y) {
        const glm::vec4* from = shown_row(y);
        mean.insert(mean.end(), from, from + shown.x);
    }
    for (glm::vec4& pixel : mean) {
        pixel /= static_cast<float>(samples_);
    }
    return mean;
}

base::Image CpuAccumulator::image() const {
    const glm::ivec2 shown = size_ - 2 * guard_;
    const auto width = static_cast<std::size_t>(shown.x), height = static_cast<std::size_t>(shown.y);
    base::Image image{shown.x, shown.y, std::vector<std::uint8_t>(4 * width * height)};
    const SrgbTables& srgb = SrgbTables::get();
    base::for_each_index(shown.y, [&] {
        return [&](int y) {
            // The sum's rows go up, the image's down.
            const glm::vec4* from = shown_row(y);
            std::uint8_t* to = &image.rgba[4 * (height - 1 - static_cast<std::size_t>(y)) * width];
            for (std::size_t x = 0; x < width; ++x, to += 4) {
                if (x > 0 && from[x] == from[x - 1]) {
                    std::copy_n(to - 4, 4, to);
                    continue;
                }
                const glm::vec4 c = from[x] / static_cast<float>(samples_);
                if (c.a > 0) {
                    to[0] = srgb.byte(c.r / c.a);
                    to[1] = srgb.byte(c.g / c.a);
                    to[2] = srgb.byte(c.b / c.a);
                    to[3] = static_cast<std::uint8_t>(std::min(c.a, 1.0F) * 255 + 0.5F);
                }
            }
        };
    });
    return image;
}

}  // namespace npr

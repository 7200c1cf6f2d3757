#include "ui/pipeline/annotation/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ui {

namespace {

constexpr double kMargin = 4, kGap = 5, kShortest = 14;  // Pixels: to the border, to other boxes, of leaders.
/// In place of pixels of leaders: what is the worse the more of it there is.
constexpr double kOfModel = 1e4, kThrough = 1e6, kCrossing = 500, kFromBelow = 6;
constexpr int kPlacesAcross = 160;
constexpr int kRounds = 3;

class Layout {
  public:
    Layout(const Coverage& model, std::span<const LabelBox> labels, std::span<const PixelBox> taken)
        : model_(model),
          labels_(labels),
          taken_(taken),
          step_(std::max(2.0, static_cast<double>(std::max(model.size().x, model.size().y)) / kPlacesAcross)),
          placed_(labels.size()) {}

    std::optional<std::vector<PlacedLabel>> run() {
        for (int round = 0; round < kRounds; ++round) {
            for (std::size_t i = 0; i < labels_.size(); ++i) {
                auto best = best_place(i);
                if (!best) {
                    return std::nullopt;
                }
                placed_[i] = *best;
            }
        }
        std::vector<PlacedLabel> result;
        result.reserve(placed_.size());
        for (const auto& label : placed_) {
            result.push_back(*label);
        }
        return result;
    }

  private:
    [[nodiscard]] std::optional<PlacedLabel> best_place(std::size_t label) const {
        const glm::dvec2 size = labels_[label].size, last = glm::dvec2(model_.size()) - size - kMargin;
        std::optional<PlacedLabel> best;
        double least = std::numeric_limits<double>::infinity();
        for (double y = kMargin; y <= last.y; y += step_) {
            for (double x = kMargin; x <= last.x; x += step_) {
                const glm::dvec2 lo = glm::floor(glm::dvec2(x, y));
                const PlacedLabel candidate = at(label, {lo, lo + size});
                // The length alone is most of the work saved.
                const double length = glm::distance(labels_[label].anchor, candidate.end) + below(label, candidate);
                if (length < least) {
                    const double cost = length + cost_of(label, candidate);
                    if (cost < least) {
                        least = cost;
                        best = candidate;
                    }
                }
            }
        }
        if (best) {
            best->of_model = model_.pixels(best->box);
        }
        return best;
    }

    /// With the leader to the nearest middle of a side.
    [[nodiscard]] PlacedLabel at(std::size_t label, const PixelBox& box) const {
        const LabelBox& of = labels_[label];
        const glm::dvec2 middle = 0.5 * (box.lo + box.hi);
        const std::array<glm::dvec2, 4> ends{glm::dvec2(box.lo.x, middle.y), glm::dvec2(box.hi.x, middle.y),
                                             glm::dvec2(middle.x, box.lo.y), glm::dvec2(middle.x, box.hi.y)};
        const auto near = [&](const glm::dvec2& a, const glm::dvec2& b) {
            return glm::distance(a, of.anchor) < glm::distance(b, of.anchor);
        };
        return {box, of.leader ? *std::min_element(ends.begin(), ends.end(), near) : middle, 0};
    }

    /// Leaders look best at either end of a text.
    [[nodiscard]] double below(std::size_t label, const PlacedLabel& place) const {
        return labels_[label].leader && (place.end.y == place.box.lo.y || place.end.y == place.box.hi.y) ? kFromBelow
                                                                                                         : 0;
    }

    /// But for the length; infinite where it cannot be.
    [[nodiscard]] double cost_of(std::size_t label, const PlacedLabel& place) const {
        constexpr double kNever = std::numeric_limits<double>::infinity();
        const LabelBox& own = labels_[label];
        const PixelBox wide = place.box.grown(kGap);
        if (std::any_of(taken_.begin(), taken_.end(), [&](const PixelBox& box) { return overlap(wide, box); })) {
            return kNever;
        }
        double cost = 0;
        if (own.leader && overlap(place.box.grown(kShortest), {own.anchor, own.anchor})) {
            cost += kThrough;
        }
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            const LabelBox& other = labels_[i];
            if (i == label) {
                continue;
            }
            if (other.leader && overlap(wide, {other.anchor, other.anchor})) {
                cost += kThrough;
            }
            if (!placed_[i]) {
                continue;
            }
            if (overlap(wide, placed_[i]->box)) {
                return kNever;
            }
            if (own.leader && meets(placed_[i]->box.grown(2), own.anchor, place.end)) {
                cost += kThrough;
            }
            if (other.leader && meets(place.box.grown(2), other.anchor, placed_[i]->end)) {
                cost += kThrough;
            }
            if (own.leader && other.leader && cross(own.anchor, place.end, other.anchor, placed_[i]->end)) {
                cost += kCrossing;
            }
        }
        const std::int64_t of_model = own.aside ? model_.pixels(place.box.grown(1)) : 0;
        return cost + (of_model > 0 ? kOfModel + static_cast<double>(of_model) : 0);
    }

    const Coverage& model_;
    std::span<const LabelBox> labels_;
    std::span<const PixelBox> taken_;
    double step_;
    std::vector<std::optional<PlacedLabel>> placed_;
};

double side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

}  // namespace

bool overlap(const PixelBox& a, const PixelBox& b) {
    return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y;
}

bool meets(const PixelBox& box, const glm::dvec2& a, const glm::dvec2& b) {
    double first = 0, last = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        if (way == 0) {
            if (a[axis] < box.lo[axis] || a[axis] > box.hi[axis]) {
                return false;
            }
            continue;
        }
        const double in = (box.lo[axis] - a[axis]) / way, out = (box.hi[axis] - a[axis]) / way;
        first = std::max(first, std::min(in, out));
        last = std::min(last, std::max(in, out));
    }
    return first <= last;
}

bool cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

Coverage::Coverage(glm::ivec2 size)
    : size_(size), sums_((static_cast<std::size_t>(size.x) + 1) * (static_cast<std::size_t>(size.y) + 1), 0) {}

Coverage::Coverage(const layers::HostStack& stack) : Coverage(stack.size) {
    const auto row = static_cast<std::size_t>(size_.x) + 1;
    for (int y = 0; y < size_.y; ++y) {
        std::uint32_t in_row = 0;
        for (int x = 0; x < size_.x; ++x) {
            in_row += stack.layers > 0 && stack.at(0, x, y).depth > 0 ? 1 : 0;
            const std::size_t to = static_cast<std::size_t>(y + 1) * row + static_cast<std::size_t>(x) + 1;
            sums_[to] = sums_[to - row] + in_row;
        }
    }
}

std::int64_t Coverage::pixels(const PixelBox& box) const {
    const auto clamped = [&](const glm::dvec2& p) {
        return glm::ivec2(glm::clamp(p, glm::dvec2(0.0), glm::dvec2(size_)));
    };
    const glm::ivec2 lo = clamped(glm::floor(box.lo)), hi = clamped(glm::ceil(box.hi));
    const auto sum = [&](int x, int y) {
        return std::int64_t{
            sums_[static_cast<std::size_t>(y) * (static_cast<std::size_t>(size_.x) + 1) + static_cast<std::size_t>(x)]};
    };
    return sum(hi.x, hi.y) - sum(lo.x, hi.y) - sum(hi.x, lo.y) + sum(lo.x, lo.y);
}

std::optional<std::vector<PlacedLabel>> lay_out(const Coverage& model, std::span<const LabelBox> labels,
                                                std::span<const PixelBox> taken) {
    return Layout(model, labels, taken).run();
}

}  // namespace ui

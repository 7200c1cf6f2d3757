#include "ui/pipeline/annotation/annotation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "csg/solid/text_outline.h"
#include "ui/pipeline/annotation/callouts.h"
#include "ui/pipeline/annotation/glyph_painter.h"
#include "ui/pipeline/annotation/glyph_part.h"
#include "ui/pipeline/part_names.h"

namespace ui {

namespace {

/// What is to be placed, and how it is drawn then.
struct Pending {
    enum class Kind { Label, Callout, Legend, Bubble, Caption };
    Kind kind = Kind::Label;
    PlacedText text;
    csg::Rgba color;
    glm::dvec3 point{0.0};  ///< World: what its line leads to.
};

class Annotator {
  public:
    Annotator(const Model& model, const base::View& view, const Peel& peel, const Annotations& annotations,
              const glm::vec3& background)
        : model_(model), view_(view), peel_(peel), asked_(annotations), first_(peel(1)), coverage_(*first_) {
        const float light = background.r + background.g + background.b;
        ink_ = light > 1.2F ? csg::Rgba{0.1F, 0.1F, 0.12F, 1} : csg::Rgba{0.95F, 0.95F, 0.95F, 1};
        paper_ = light > 1.2F ? csg::Rgba{1, 1, 1, 1} : csg::Rgba{0.12F, 0.14F, 0.2F, 1};
    }

    Annotated run() {
        find_texts();
        try {
            place();
        } catch (const csg::solid::GeometryError& error) {
            throw ModelError(fmt::format("labels: {}", error.what()));
        }
        GlyphPainter painter(view_, front());
        for (const ArrowRequest& arrow : asked_.arrows) {
            painter.arrow(arrow, model_.box.empty() ? 1 : model_.box.diagonal());
        }
        for (std::size_t i = 0; i < asked_.frames.size(); ++i) {
            painter.frame(frames_[i], asked_.frames[i].width.value_or(0.15 * capitals_),
                          asked_.frames[i].color.value_or(kFrame));
        }
        for (const Pending& each : pending_) {
            draw(painter, each);
        }
        Annotated result;
        result.model = with_glyphs(model_, painter.glyphs());
        result.unseen = unseen_;
        for (Pending& each : pending_) {
            result.texts.push_back(std::move(each.text));
        }
        return result;
    }

  private:
    static constexpr csg::Rgba kFrame{0.85F, 0.2F, 0.15F, 1};

    /// Nearer than all there is.
    [[nodiscard]] double front() const {
        float nearest = 0;
        for (const float depth : first_->planes.empty() ? std::vector<float>() : first_->planes.front().depth) {
            nearest = std::max(nearest, depth);
        }
        const double distance = nearest > 0 ? view_.distance(nearest) : view_.camera().distance;
        return view_.orthographic() ? distance - 0.02 * std::max(model_.box.diagonal(), 1e-9) : 0.97 * distance;
    }

    void find_texts() {
        std::vector<std::vector<csg::PartId>> groups;
        std::vector<Pending> texts;
        for (std::size_t i = 0; i < asked_.labels.size(); ++i) {
            const LabelRequest& label = asked_.labels[i];
            Pending pending;
            pending.text.text = label.text;
            pending.text.label = i;
            groups.push_back(parts_selected(model_.scene, "--label", label.of));
            texts.push_back(pending);
        }
        const std::vector<Callout> callouts = asked_.callouts ? callouts_of(model_.scene) : std::vector<Callout>();
        for (const Callout& callout : callouts) {
            Pending pending;
            pending.kind = Pending::Kind::Callout;
            groups.push_back(callout.parts);
            texts.push_back(pending);
        }
        const auto anchors = anchors_of(groups);
        std::string legend;
        int number = 0;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            Pending& each = texts[i];
            if (!anchors[i]) {
                if (each.kind == Pending::Kind::Label) {
                    unseen_.push_back(each.text.label);
                }
                continue;
            }
            each.text.part = anchors[i];
            each.text.anchor = glm::dvec2(anchors[i]->pixel) + 0.5;
            each.text.parts = groups[i];
            each.point = anchors[i]->point;
            if (each.kind == Pending::Kind::Callout) {
                const Callout& callout = callouts[i - asked_.labels.size()];
                each.text.text = fmt::format("{}", ++number);
                legend += fmt::format("{}{}   {}", legend.empty() ? "" : "\n", number, callout.text);
            }
            pending_.push_back(each);
        }
        if (!legend.empty()) {
            Pending pending;
            pending.kind = Pending::Kind::Legend;
            pending.text.text = legend;
            pending_.push_back(pending);
        }
        for (const BubbleRequest& bubble : asked_.bubbles) {
            Pending pending;
            pending.kind = Pending::Kind::Bubble;
            pending.text.text = wrapped(bubble.text, 18);
            pending.text.anchor = seen_at(view_, bubble.at).pixel;
            pending.color = bubble.color.value_or(ink_);
            pending_.push_back(pending);
        }
        find_frames();
    }

    void find_frames() {
        constexpr double kAbout = 6;  // Pixels of room.
        for (const FrameRequest& frame : asked_.frames) {
            PixelBox box{glm::dvec2(INFINITY), glm::dvec2(-INFINITY)};
            for (const glm::dvec3& point : frame.points) {
                const glm::dvec2 seen = seen_at(view_, point).pixel;
                box.lo = glm::min(box.lo, seen);
                box.hi = glm::max(box.hi, seen);
            }
            frames_.push_back(box.grown(kAbout));
            if (!frame.text.empty()) {
                Pending pending;
                pending.kind = Pending::Kind::Caption;
                pending.text.text = frame.text;
                pending.text.anchor = {0.5 * (frames_.back().lo.x + frames_.back().hi.x), frames_.back().hi.y};
                pending.color = frame.color.value_or(kFrame);
                pending_.push_back(pending);
            }
        }
    }

    /// Of each group in a map of its own where a part is in several: labels may name the same parts.
    [[nodiscard]] std::vector<std::optional<PartAnchor>> anchors_of(
        const std::vector<std::vector<csg::PartId>>& groups) {
        std::vector<std::optional<PartAnchor>> anchors(groups.size());
        std::shared_ptr<const layers::HostStack> stack = first_;
        for (const bool all : {false, true}) {
            std::vector<char> done(groups.size(), 0);
            for (std::size_t i = 0; i < groups.size(); ++i) {
                done[i] = anchors[i] ? 1 : 0;
            }
            if (std::count(done.begin(), done.end(), 0) == 0) {
                break;
            }
            stack = all ? peel_(0) : stack;
            while (std::count(done.begin(), done.end(), 0) != 0) {
                std::vector<std::uint32_t> group_of(model_.scene.parts.size(), kNoGroup);
                std::vector<std::size_t> in_map;
                for (std::size_t i = 0; i < groups.size(); ++i) {
                    const bool free = std::all_of(groups[i].begin(), groups[i].end(),
                                                  [&](csg::PartId part) { return group_of[part] == kNoGroup; });
                    if (done[i] == 0 && free) {
                        for (const csg::PartId part : groups[i]) {
                            group_of[part] = static_cast<std::uint32_t>(in_map.size());
                        }
                        in_map.push_back(i);
                        done[i] = 1;
                    }
                }
                const auto found = part_anchors(model_, view_, *stack, group_of, in_map.size());
                for (std::size_t k = 0; k < in_map.size(); ++k) {
                    anchors[in_map[k]] = found[k];
                }
            }
        }
        return anchors;
    }

    void place() {
        constexpr double kSmallest = 6, kSmaller = 0.85, kOfPicture = 0.024, kAtFirst = 9;
        const glm::ivec2 size = view_.size();
        capitals_ = std::max(kAtFirst, kOfPicture * std::min(size.x, size.y));
        for (;; capitals_ *= kSmaller) {
            if (capitals_ < kSmallest) {
                throw ModelError("labels: there is no room for all of them; make the picture larger (--imgsize)");
            }
            shapes_.clear();
            std::vector<LabelBox> boxes;
            for (const Pending& each : pending_) {
                shapes_.push_back(text_shape(each.text.text, capitals_, fonts_));
                boxes.push_back(box_of(each, shapes_.back().size));
            }
            if (const auto placed = lay_out(coverage_, boxes)) {
                for (std::size_t i = 0; i < pending_.size(); ++i) {
                    pending_[i].text.place = (*placed)[i];
                }
                return;
            }
        }
    }

    [[nodiscard]] LabelBox box_of(const Pending& each, const glm::dvec2& text) const {
        const glm::dvec2 about = padding(each.kind);
        switch (each.kind) {
            case Pending::Kind::Callout:
                return {glm::dvec2(std::ceil(std::max(glm::length(text), 1.2 * text.y) + 2 * about.x)),
                        each.text.anchor, true};
            case Pending::Kind::Legend:
                return {glm::ceil(text + 2.0 * about), 0.5 * text, false};
            case Pending::Kind::Caption:
                return {glm::ceil(text + 2.0 * about), each.text.anchor + glm::dvec2(0, 0.5 * text.y + about.y), false,
                        false};
            case Pending::Kind::Label:
            case Pending::Kind::Bubble:
                break;
        }
        return {glm::ceil(text + 2.0 * about), each.text.anchor, true};
    }
    /// Between a text and its box.
    [[nodiscard]] glm::dvec2 padding(Pending::Kind kind) const {
        switch (kind) {
            case Pending::Kind::Bubble:
                return glm::dvec2(capitals_, 0.9 * capitals_);
            case Pending::Kind::Callout:
                return glm::dvec2(0.25 * capitals_);
            case Pending::Kind::Legend:
                return glm::dvec2(0.7 * capitals_);
            case Pending::Kind::Label:
            case Pending::Kind::Caption:
                break;
        }
        return {0.35 * capitals_, 0.2 * capitals_};
    }

    void draw(GlyphPainter& painter, const Pending& each) const {
        const auto index = static_cast<std::size_t>(&each - pending_.data());
        const PixelBox& box = each.text.place.box;
        const double line = std::max(0.6, 0.06 * capitals_);
        glm::dvec2 corner = box.lo + padding(each.kind);
        switch (each.kind) {
            case Pending::Kind::Label:
                painter.leader(each.text.anchor, each.text.part->layer > 0 ? &each.point : nullptr, each.text.place.end,
                               line, ink_);
                break;
            case Pending::Kind::Callout:
                painter.leader(each.text.anchor, each.text.part->layer > 0 ? &each.point : nullptr, each.text.place.end,
                               line, ink_);
                painter.plate({{circle(0.5 * (box.lo + box.hi), 0.5 * box.size().x)}}, paper_);
                painter.ring(circle(0.5 * (box.lo + box.hi), 0.5 * box.size().x),
                             circle(0.5 * (box.lo + box.hi), 0.5 * box.size().x - 2 * line), ink_);
                // Figures are as high as capitals, above the baseline.
                corner = 0.5 * (box.lo + box.hi - shapes_[index].size) - glm::dvec2(0, 0.15 * capitals_);
                break;
            case Pending::Kind::Bubble:
                painter.bubble(box, each.text.anchor, 2 * line, paper_, each.color);
                break;
            case Pending::Kind::Legend:
            case Pending::Kind::Caption:
                break;
        }
        painter.text(shapes_[index].outline, corner, each.kind == Pending::Kind::Caption ? each.color : ink_);
    }

    const Model& model_;
    const base::View& view_;
    const Peel& peel_;
    const Annotations& asked_;
    std::shared_ptr<const layers::HostStack> first_;
    Coverage coverage_;
    csg::Rgba ink_, paper_;
    csg::solid::FontLibrary fonts_;
    double capitals_ = 0;  ///< Pixels.
    std::vector<Pending> pending_;
    std::vector<TextShape> shapes_;  ///< Of these.
    std::vector<PixelBox> frames_;
    std::vector<std::size_t> unseen_;
};

}  // namespace

Annotated annotate(const Model& model, const base::View& view, const Peel& peel, const Annotations& annotations,
                   const glm::vec3& background) {
    return Annotator(model, view, peel, annotations, background).run();
}

}  // namespace ui

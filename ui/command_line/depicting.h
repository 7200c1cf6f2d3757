// What a run puts beside the model: glyphs of what moves, and of what is said of its parts.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "npr/picture.h"
#include "ui/command_line/language_run.h"
#include "ui/pipeline/annotation/annotation.h"
#include "ui/pipeline/motion/depiction.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {

/// Of --depict-rules. Throws UsageError where the file cannot be read, or is no file of rules.
[[nodiscard]] std::vector<Depiction> rules_of(const Options& options);

class Depicting {
  public:
    /// All must outlive it.
    Depicting(const Options& options, TimeLimit& limit, LanguageRun& language)
        : options_(options), limit_(limit), language_(language) {}

    /// Reads labels, arrows and the file of rules. Throws UsageError, or what annotations_of throws.
    void read();

    /// Of the tree at the time `now`, with the glyphs of what moves; the tree itself where none are asked for. Throws
    /// UsageError where depictions are of what is not there.
    [[nodiscard]] std::shared_ptr<const csg::Tree> depicted(std::shared_ptr<const csg::Tree> tree, double now);
    [[nodiscard]] bool depicts() const { return !depictions_.empty(); }

    /// What moves; looked for when it is first asked for.
    [[nodiscard]] const Motion& motion();

    /// The model with what is written into that picture; null where that is nothing. Throws ModelError.
    [[nodiscard]] std::shared_ptr<const Model> annotated(const Model& model, const npr::Picture& picture,
                                                         Renderer& renderer);

    [[nodiscard]] const Annotations& annotations() const { return annotations_; }
    /// Of glyphs in the model that depicted() gave last.
    [[nodiscard]] const std::vector<GlyphStyle>& styles() const { return styles_; }
    /// Those of another time.
    void set(Annotations annotations, std::vector<GlyphStyle> styles) {
        annotations_ = std::move(annotations);
        styles_ = std::move(styles);
    }

  private:
    [[nodiscard]] base::Camera camera_at(double time);

    const Options& options_;
    TimeLimit& limit_;
    LanguageRun& language_;
    std::vector<Depiction> depictions_;
    std::optional<Motion> motion_;
    Annotations annotations_;
    std::vector<GlyphStyle> styles_;
};

}  // namespace ui

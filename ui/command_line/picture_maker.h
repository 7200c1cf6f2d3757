// One picture of a run, with all that is drawn into it.
#pragma once

#include "base/image.h"
#include "npr/picture.h"
#include "ui/command_line/depicting.h"
#include "ui/command_line/language_run.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {

/// Of what the picture is.
struct PictureSubject {
    const Model& model;
    const Model& shown;  ///< Less what sections cut away.
    csg::Box box;        ///< For plans.
};

class PictureMaker {
  public:
    /// All must outlive it.
    PictureMaker(const Options& options, TimeLimit& limit, LanguageRun& language, ModelBuilder& builder,
                 Depicting& depicting)
        : options_(options), limit_(limit), language_(language), builder_(builder), depicting_(depicting) {}

    /// Sets the range of a radiograph to that of the thickest place, where it has none.
    void set_full_tone(const PictureSubject& of, npr::Picture& picture, Renderer& renderer) const;
    /// What is drawn of a flat model is without its lines, which are drawn into the picture.
    [[nodiscard]] static PictureRequest request_of(const PictureSubject& of, const npr::Picture& picture);

    /// Throws what Renderer::render and Depicting::annotated throw, UsageError where options do not go together.
    [[nodiscard]] base::Image image(const PictureSubject& of, npr::Picture& picture, Renderer& renderer);

  private:
    [[nodiscard]] base::Image thickness_image(const PictureSubject& of, PictureRequest request, Renderer& renderer);
    [[nodiscard]] base::Image plan_image(const PictureSubject& of, const PictureRequest& request, Renderer& renderer);
    void draw_centers(const PictureSubject& of, base::Image& image, const npr::Picture& picture) const;
    void draw_marks(const PictureSubject& of, base::Image& image, const npr::Picture& picture,
                    Renderer& renderer) const;

    const Options& options_;
    TimeLimit& limit_;
    LanguageRun& language_;
    ModelBuilder& builder_;
    Depicting& depicting_;
};

}  // namespace ui

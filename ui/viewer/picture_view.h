// The model's picture in the window: drawn step by step into a texture, shown from there in every frame.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "ui/pipeline/inspection/measured.h"
#include "ui/pipeline/picture/thickness_map.h"
#include "ui/pipeline/picture/view_marks.h"
#include "ui/pipeline/sections.h"
#include "ui/viewer/frame_plan.h"
#include "ui/viewer/label_layer.h"
#include "ui/viewer/render_thread.h"
#include "ui/viewer/selection.h"

namespace ui {

/// A step of a picture that is drawn, and shown from now on.
struct DrawnStep {
    PictureStep step;
    std::uint64_t version = 0;  ///< As it was given to draw().
    double seconds = 0;         ///< That it took.
    PictureStatistics statistics;
    std::shared_ptr<const ThicknessMap> thickness;  ///< Of a picture of thickness, without the tints.
    std::string error;                              ///< Why it could not be drawn; empty where it was.
    std::string unwritten;  ///< What of the annotations is not in it, and why; empty where all are.
    bool stopped = false;   ///< It was stopped: nothing new is to be seen, and the picture is to be begun anew.
};

struct SavedPicture {
    std::filesystem::path path;
    glm::ivec2 size{0};
    std::string error;  ///< Why it is not saved; empty where it is.
};

/// What a point is asked for.
enum class PickFor { Center, Navigation };

struct PickedPoint {
    std::optional<PickedSurface> surface;  ///< The nearest; none where there is nothing.
    PickFor purpose = PickFor::Center;     ///< As it was given.
};

/// What lies at a place, and next to it.
struct ProbedPlace {
    glm::dvec2 at{0};  ///< As it was given.
    std::optional<PickedSurface> surface;
    std::optional<Measured> face, edge, corner;
};

/// What is to be selected, nearest first.
struct PickedSurfaces {
    std::shared_ptr<const Model> model;  ///< As it was given.
    glm::dvec2 at{0};                    ///< As it was given.
    std::vector<SelectedSurface> surfaces;
};

using PictureResult = std::variant<DrawnStep, SavedPicture, PickedPoint, ProbedPlace, PickedSurfaces>;

/// Pictures are drawn in the window's context, at once; or, which is meant for OpenGL that is computed by the
/// processor, by a thread, and results come later.
class PictureView {
  public:
    /// The window's context must be current whenever this is used, and outlive it. `threaded`: draw on a thread of its
    /// own, where that can have a context. `wake` is called from that thread when take() has something.
    PictureView(const gl::Context& window, const goldfeather::EngineOptions& engine, bool threaded,
                std::function<void()> wake);

    // Each asks for something that take() gives later, maybe at once. While busy() nothing further is to be asked for.
    [[nodiscard]] bool busy() const { return thread_ && thread_->busy(); }
    /// One step of the picture that `request` asks for, with `marks` in it. `thickness`: in the tones of that, instead
    /// of the model's colors. What is `held` is so for all that is asked for afterwards.
    void draw(std::shared_ptr<const Model> model, PictureRequest request, const ViewMarks& marks,
              const std::optional<ThicknessRequest>& thickness, const PictureStep& step, std::uint64_t version,
              const HeldPart& held = {}, std::shared_ptr<const Annotations> annotations = nullptr);
    /// Ends the step that a thread is drawing, some milliseconds later, if it draws one.
    void stop_drawing() { drawing_.request_stop(); }
    /// Steps are drawn by a thread, and can be stopped.
    [[nodiscard]] bool threaded() const { return thread_ != nullptr; }
    /// Writes a picture of its own. The picture that is shown must be begun anew afterwards.
    void save(std::shared_ptr<const Model> model, PictureRequest request,
              const std::optional<ThicknessRequest>& thickness, std::filesystem::path path,
              std::shared_ptr<const Annotations> annotations = nullptr);
    /// See Renderer::pick.
    void pick(std::shared_ptr<const Model> model, npr::Sections sections, const base::Camera& camera,
              PickFor purpose = PickFor::Center);

    /// The nearest surface, and the edge and the corner next to it. `at` comes back with them.
    void probe(std::shared_ptr<const Model> model, npr::Sections sections, const base::Camera& camera,
               const glm::dvec2& at);

    /// All surfaces behind the camera's one pixel, with their places in the sources, which are the model's. `at` comes
    /// back with them.
    void select(std::shared_ptr<const Model> model, std::shared_ptr<const csg::scad::SourceSet> sources,
                npr::Sections sections, const base::Camera& camera, const glm::dvec2& at);

    /// What has been done since the last call.
    [[nodiscard]] std::vector<PictureResult> take();

    /// Fills a rectangle (pixels, from the lower left) of the framebuffer `target` (0: the window) with the picture; or
    /// all of it with the color, where nothing has been drawn yet.
    void show(GLuint target, glm::ivec2 corner, glm::ivec2 size, const glm::vec3& empty_color) const;

  private:
    void run(std::function<PictureResult(Renderer&)> task);
    /// What the sections leave of the model, for tasks.
    const Model& cut(const std::shared_ptr<const Model>& model, const npr::Sections& sections, Renderer& renderer);
    /// The model without its colors, which takes its place until another one is drawn.
    std::shared_ptr<const Model> plain(const std::shared_ptr<const Model>& model);
    /// Measures what the step of a picture of `shown`, the plain model less sections, sees.
    ThicknessMap measure(const Model& shown, const PictureRequest& request, const ThicknessRequest& thickness,
                         int sample, Renderer& renderer, const std::stop_token& stop);
    void resize(glm::ivec2 size);
    void upload(const base::Image& image);
    /// Draws marks into a picture. A task of the drawer.
    void mark(base::Image& image, const Model& model, const PictureRequest& request, const ViewMarks& marks,
              std::uint64_t version, Renderer& renderer);

    const gl::Functions& gl_;
    std::function<void()> wake_;
    gl::Texture texture_;
    gl::Framebuffer target_;
    bool flipped_ = false;  ///< The texture's first row is the upper one.
    bool drawn_ = false;
    std::mutex mutex_;
    std::vector<PictureResult> results_;
    std::optional<base::Image> image_;  ///< Drawn by the thread, not in the texture yet.
    std::optional<Renderer> renderer_;
    SectionedModel sectioned_;                      ///< Belongs to the tasks, as do …
    HeldPart held_;                                 ///< … what is held …
    std::shared_ptr<const Model> held_in_;          ///< … in the model that was drawn last, …
    std::shared_ptr<const Model> colored_, plain_;  ///< … the model of the picture in tones, that without colors, …
    std::unique_ptr<ThicknessGauge> gauge_;         ///< … of colored_, …
    std::shared_ptr<const Model> probed_;           ///< … the model that finder_ is of, …
    std::optional<EdgeFinder> finder_;
    LabelLayer labels_;                                     ///< … what is written into pictures, …
    std::shared_ptr<const layers::HostStack> first_layer_;  ///< … and what hides marks in a picture of …
    std::pair<std::uint64_t, int> first_layer_of_;          ///< … that version and width.
    std::stop_source drawing_;                              ///< Of the step asked for last.
    std::unique_ptr<RenderThread> thread_;                  ///< Last: its tasks use the above.
};

}  // namespace ui

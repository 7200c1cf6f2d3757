#include "ui/viewer/picture_view.h"

#include <array>
#include <utility>

#include "base/file.h"
#include "base/stop.h"
#include "gl/error.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

PictureView::PictureView(const gl::Context& window, const goldfeather::EngineOptions& engine, bool threaded,
                         std::function<void()> wake)
    : gl_(window.functions()), wake_(std::move(wake)), target_(gl_) {
    if (threaded) {
        try {
            thread_ = std::make_unique<RenderThread>(engine);
            return;
        } catch (const gl::Error&) {
            // The window's own context does as well, only that the window waits for it.
        }
    }
    renderer_.emplace(window, engine);
}

void PictureView::run(std::function<PictureResult(Renderer&)> task) {
    if (!thread_) {
        results_.push_back(task(*renderer_));
        return;
    }
    thread_->post([this, task = std::move(task)](Renderer& renderer) {
        PictureResult result = task(renderer);
        {
            std::scoped_lock lock(mutex_);
            results_.push_back(std::move(result));
        }
        wake_();
    });
}

const Model& PictureView::cut(const std::shared_ptr<const Model>& model, const npr::Sections& sections,
                              Renderer& renderer) {
    const Model& left =
        sectioned_.cut(plain_ && model == colored_ ? plain_ : model, sections, model == held_in_ ? held_ : HeldPart{});
    if (!sectioned_.change().empty()) {
        renderer.update(left, sectioned_.change());
        labels_.update(left, sectioned_.change());
    }
    return left;
}

std::shared_ptr<const Model> PictureView::plain(const std::shared_ptr<const Model>& model) {
    if (colored_ != model) {
        gauge_ = std::make_unique<ThicknessGauge>(*model);
        plain_ = without_colors(*model);
        colored_ = model;
    }
    return plain_;
}

ThicknessMap PictureView::measure(const Model& shown, const PictureRequest& request, const ThicknessRequest& thickness,
                                  int sample, Renderer& renderer, const std::stop_token& stop) {
    gauge_->measure(renderer, shown, request, thickness, sample, stop);
    return gauge_->map();
}

void PictureView::mark(base::Image& image, const Model& model, const PictureRequest& request, const ViewMarks& marks,
                       std::uint64_t version, Renderer& renderer) {
    const base::View view(request.camera, request.size, model.box.lo, model.box.hi);
    if (std::pair key(version, request.size.x); !first_layer_ || key != first_layer_of_) {
        first_layer_ = model.empty() ? std::make_shared<layers::HostStack>() : renderer.first_layer(model, view);
        first_layer_of_ = key;
    }
    const glm::vec3& ground = request.scheme.background;
    MarkColors colors;
    colors.axes = glm::vec3(ground.r + ground.g + ground.b < 1.5F ? 1.0F : 0.0F);
    draw_view_marks(image, marks, colors, view, model.geometry, *first_layer_);
}

void PictureView::draw(std::shared_ptr<const Model> model, PictureRequest request, const ViewMarks& marks,
                       const std::optional<ThicknessRequest>& thickness, const PictureStep& step, std::uint64_t version,
                       const HeldPart& held, std::shared_ptr<const Annotations> annotations) {
    const glm::ivec2 whole = request.size;
    request.size = glm::max((request.size + step.divisor - 1) / step.divisor, 1);
    const bool threaded = thread_ != nullptr;
    drawing_ = std::stop_source();
    // Where nobody could ask for a stop meanwhile, drawing need not look for it.
    const std::stop_token stop = threaded ? drawing_.get_token() : std::stop_token();
    run([this, threaded, stop, model = std::move(model), request = std::move(request), marks, thickness, held, step,
         version, whole, annotations = std::move(annotations)](Renderer& renderer) mutable {
        held_ = held;
        held_in_ = model;
        DrawnStep done{step, version, 0, {}, {}, {}, {}, false};
        Stopwatch watch;
        try {
            if (thickness) {
                (void)plain(model);
                request.scheme.face = request.scheme.cut = glm::vec3(1);
            } else {
                colored_ = plain_ = nullptr;
                gauge_.reset();
            }
            const Model& shown = cut(model, request.sections, renderer);
            const bool writes = annotations && !thickness && (step.divisor == 1 || !labels_.slow());
            PictureRequest all = request;
            all.size = whole;
            const Model& drawn = writes ? labels_.annotated(shown, all, annotations, version) : shown;
            done.unwritten = writes ? labels_.error() : "";
            renderer.draw_sample(drawn, request, step.sample, stop);
            if (threaded || !renderer.drawn_with_opengl() || marks.any() || thickness) {
                base::Image image = renderer.image();
                if (thickness) {
                    const ThicknessMap map = measure(shown, request, *thickness, step.sample, renderer, stop);
                    tint(image, map);
                    done.thickness = std::make_shared<const ThicknessMap>(ThicknessMap{map.range, {}, map.places});
                }
                if (marks.any()) {
                    mark(image, shown, request, marks, version, renderer);
                }
                std::scoped_lock lock(mutex_);
                image_ = std::move(image);
            } else {
                resize(request.size);
                renderer.resolve(target_.id(), {0, 0});
                gl_.Finish();
                drawn_ = true;
            }
        } catch (const base::Stopped&) {
            done.stopped = true;
        } catch (const std::exception& error) {
            done.error = error.what();
        }
        done.seconds = watch.lap() / 1000;
        done.statistics = renderer.statistics();
        return done;
    });
}

void PictureView::save(std::shared_ptr<const Model> model, PictureRequest request,
                       const std::optional<ThicknessRequest>& thickness, std::filesystem::path path,
                       std::shared_ptr<const Annotations> annotations) {
    run([this, model = std::move(model), request = std::move(request), thickness, path = std::move(path),
         annotations = std::move(annotations)](Renderer& renderer) mutable {
        SavedPicture done{path, request.size, {}};
        try {
            if (thickness) {
                (void)plain(model);
                request.scheme.face = request.scheme.cut = glm::vec3(1);
            }
            const Model& shown = cut(model, request.sections, renderer);
            LabelLayer labels;
            const Model& drawn = thickness ? shown : labels.annotated(shown, request, annotations, 0);
            base::Image image = renderer.render(drawn, request);
            if (thickness) {
                draw_thickness(image, thickness_map(renderer, *model, shown, request, *thickness),
                               request.scheme.background);
            }
            base::write_file(path, base::encode_png(image, {}, request.dots_per_inch));
        } catch (const std::exception& error) {
            done.error = error.what();
        }
        return done;
    });
}

void PictureView::pick(std::shared_ptr<const Model> model, npr::Sections sections, const base::Camera& camera,
                       PickFor purpose) {
    run([this, model = std::move(model), sections = std::move(sections), camera, purpose](Renderer& renderer) {
        PickedPoint picked{{}, purpose};
        try {
            const auto surfaces = renderer.pick(cut(model, sections, renderer), camera);
            picked.surface = surfaces.empty() ? std::nullopt : std::optional(surfaces.front());
        } catch (const std::exception&) {
            // The picture of the same model tells why it cannot be drawn.
        }
        return picked;
    });
}

void PictureView::probe(std::shared_ptr<const Model> model, npr::Sections sections, const base::Camera& camera,
                        const glm::dvec2& at) {
    run([this, model = std::move(model), sections = std::move(sections), camera, at](Renderer& renderer) {
        ProbedPlace probed{at, {}, {}, {}, {}};
        try {
            const Model& shown = cut(model, sections, renderer);
            const auto surfaces = renderer.pick(shown, camera);
            if (surfaces.empty()) {
                return probed;
            }
            probed.surface = surfaces.front();
            probed.face = measured_face(shown, surfaces.front());
            // Edges of faces that a section has made are not known.
            if (surfaces.front().surface.leaf < model->scene.leaves.size()) {
                if (probed_ != model) {
                    finder_.emplace(*model);
                    probed_ = model;
                }
                probed.edge = finder_->edge(surfaces.front());
                probed.corner = finder_->corner(surfaces.front());
            }
        } catch (const std::exception&) {
            // The picture of the same model tells why it cannot be drawn.
        }
        return probed;
    });
}

void PictureView::select(std::shared_ptr<const Model> model, std::shared_ptr<const csg::scad::SourceSet> sources,
                         npr::Sections sections, const base::Camera& camera, const glm::dvec2& at) {
    run([this, model = std::move(model), sources = std::move(sources), sections = std::move(sections), camera,
         at](Renderer& renderer) {
        PickedSurfaces picked{model, at, {}};
        try {
            const Model& shown = cut(model, sections, renderer);
            for (const PickedSurface& surface : renderer.pick(shown, camera, layers::kAllLayers)) {
                picked.surfaces.push_back(selected_surface(shown, *sources, surface));
            }
        } catch (const std::exception&) {
            picked.surfaces.clear();  // The picture of the same model tells why it cannot be drawn.
        }
        return picked;
    });
}

std::vector<PictureResult> PictureView::take() {
    std::optional<base::Image> image;
    std::vector<PictureResult> results;
    {
        std::scoped_lock lock(mutex_);
        image = std::exchange(image_, std::nullopt);
        results = std::exchange(results_, {});
    }
    if (image) {
        upload(*image);
    }
    return results;
}

void PictureView::resize(glm::ivec2 size) {
    if (!texture_ || texture_.size() != size) {
        texture_ = gl::Texture::make_2d(gl_, GL_RGBA8, size);
        target_.attach({&texture_});
    }
}

void PictureView::upload(const base::Image& image) {
    resize({image.width, image.height});
    gl_.TextureSubImage2D(texture_.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                          image.rgba.data());
    flipped_ = drawn_ = true;
}

void PictureView::show(GLuint target, glm::ivec2 corner, glm::ivec2 size, const glm::vec3& empty_color) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (!drawn_) {
        const std::array<float, 4> color{empty_color.r, empty_color.g, empty_color.b, 1};
        gl_.ClearNamedFramebufferfv(target, GL_COLOR, 0, color.data());
        return;
    }
    const glm::ivec2 drawn = texture_.size();
    const glm::ivec2 end = corner + size;
    const int lower = flipped_ ? drawn.y : 0;
    gl_.BlitNamedFramebuffer(target_.id(), target, 0, lower, drawn.x, drawn.y - lower, corner.x, corner.y, end.x, end.y,
                             GL_COLOR_BUFFER_BIT, drawn == size ? GL_NEAREST : GL_LINEAR);
}

}  // namespace ui

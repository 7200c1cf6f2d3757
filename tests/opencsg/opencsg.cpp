#include "tests/opencsg/opencsg.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <opencsg.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <optional>
#include <stdexcept>

namespace opencsg {

namespace {

/// A literal: draws the display list of its leaf.
class Literal final : public OpenCSG::Primitive {
  public:
    Literal(OpenCSG::Operation operation, unsigned convexity, GLuint list)
        : OpenCSG::Primitive(operation, convexity), list_(list) {}
    void render() override { glCallList(list_); }

  private:
    GLuint list_;
};

/// A compatibility context with a pixel buffer: OpenCSG draws with the fixed-function pipeline.
class Context {
  public:
    explicit Context(glm::ivec2 size) {
        display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) {
            throw std::runtime_error("no surfaceless EGL display");
        }
        const EGLint wanted[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_STENCIL_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglChooseConfig(display_, wanted, &config, 1, &count) || count == 0) {
            throw std::runtime_error("EGL has no configuration with pixel buffers, depth and stencil");
        }
        const EGLint surface[] = {EGL_WIDTH, size.x, EGL_HEIGHT, size.y, EGL_NONE};
        surface_ = eglCreatePbufferSurface(display_, config, surface);
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
        if (surface_ == EGL_NO_SURFACE || context_ == EGL_NO_CONTEXT) {
            throw std::runtime_error(fmt::format("EGL gives no compatibility context (0x{:x})", eglGetError()));
        }
        make_current();
        // OpenCSG calls OpenGL through GLEW, whose loader complains of a missing X display after it has loaded all.
        const auto glew_init = reinterpret_cast<unsigned (*)()>(dlsym(RTLD_DEFAULT, "glewInit"));
        if (glew_init == nullptr) {
            throw std::runtime_error("libopencsg does not use GLEW here");
        }
        constexpr unsigned kNoGlxDisplay = 4;
        if (const unsigned error = glew_init(); error != 0 && error != kNoGlxDisplay) {
            throw std::runtime_error(fmt::format("glewInit failed ({})", error));
        }
    }
    ~Context() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglDestroySurface(display_, surface_);
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    void make_current() const {
        if (!eglMakeCurrent(display_, surface_, surface_, context_)) {
            throw std::runtime_error(fmt::format("eglMakeCurrent failed (0x{:x})", eglGetError()));
        }
    }

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
};

/// A near and a far plane about the scene: OpenGL's usual depth needs both.
struct Range {
    double nearest, farthest;
};

Range depth_range(const base::View& view, const csg::Box& box) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 corner((i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                                (i & 4) != 0 ? box.hi.z : box.lo.z, 1.0);
        const double distance = -(view.eye_from_world() * corner).z;
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    const double margin = 1e-3 * std::max(farthest - nearest, 1e-6 * std::abs(farthest));
    nearest -= margin;
    farthest += margin;
    if (!view.orthographic()) {
        // An eye among the solids: a thousandth of the scene, as previews do.
        nearest = std::max(nearest, 1e-3 * std::max(farthest, box.diagonal()));
        farthest = std::max(farthest, 2 * nearest);
    }
    return {nearest, farthest};
}

class Engine final : public OpenCsg {
  public:
    explicit Engine(glm::ivec2 size) : context_(size) {}
    ~Engine() override {
        context_.make_current();
        forget();
        OpenCSG::freeResources();
    }

    void load(const csg::solid::Geometry& geometry, const std::vector<std::vector<goldfeather::Product>>& parts,
              const base::View& view, Algorithm algorithm) override {
        context_.make_current();
        forget();
        view_.emplace(view);
        range_ = depth_range(view, geometry.box);
        const glm::dvec3 center = geometry.box.empty() ? glm::dvec3(0.0) : geometry.box.center();
        eye_from_local_ = glm::translate(view.eye_from_world(), center);
        first_list_ = glGenLists(static_cast<GLsizei>(geometry.leaves.size()));
        list_count_ = static_cast<GLsizei>(geometry.leaves.size());
        for (std::size_t i = 0; i < geometry.leaves.size(); ++i) {
            compile(geometry, geometry.leaves[i], center, first_list_ + static_cast<GLuint>(i));
        }
        for (const auto& part : parts) {
            for (const goldfeather::Product& product : part) {
                add(geometry, product);
            }
        }
        OpenCSG::setOption(OpenCSG::AlgorithmSetting, algorithm == Algorithm::Goldfeather ? OpenCSG::Goldfeather
                                                      : algorithm == Algorithm::Scs       ? OpenCSG::SCS
                                                                                          : OpenCSG::Automatic);
    }

    void draw() override {
        context_.make_current();
        const glm::ivec2 size = view_->size();
        glViewport(0, 0, size.x, size.y);
        glClearColor(1, 1, 0.9F, 1);
        glClearDepth(1);
        glDepthMask(GL_TRUE);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        set_matrices(size);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        for (const auto& product : products_) {
            std::vector<OpenCSG::Primitive*> pointers;
            for (const auto& literal : product) {
                pointers.push_back(literal.get());
            }
            OpenCSG::render(pointers);
        }
        glDepthFunc(GL_EQUAL);
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        for (const auto& product : products_) {
            for (const auto& literal : product) {
                literal->render();
            }
        }
        glDisable(GL_LIGHTING);
        glDepthFunc(GL_LESS);
        glFinish();
    }

    Picture read() override {
        context_.make_current();
        Picture picture{view_->size(), {}};
        std::vector<float> depths(static_cast<std::size_t>(picture.size.x) * static_cast<std::size_t>(picture.size.y));
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(0, 0, picture.size.x, picture.size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
        const auto [n, f] = range_;
        for (const float d : depths) {
            const double z = d;
            picture.distance.push_back(d >= 1                  ? std::numeric_limits<double>::infinity()
                                       : view_->orthographic() ? n + z * (f - n)
                                                               : n * f / (f - z * (f - n)));
        }
        return picture;
    }

  private:
    void forget() {
        products_.clear();
        if (list_count_ > 0) {
            glDeleteLists(first_list_, list_count_);
            list_count_ = 0;
        }
    }

    static void compile(const csg::solid::Geometry& geometry, const csg::solid::PlacedLeaf& leaf,
                        const glm::dvec3& center, GLuint list) {
        glNewList(list, GL_COMPILE);
        glBegin(GL_TRIANGLES);
        for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
            const csg::solid::PlaneRef plane = leaf.planes[t];
            const glm::vec3 normal = geometry.planes.planes()[plane.index].normal * (plane.flipped ? -1.0 : 1.0);
            glNormal3fv(glm::value_ptr(normal));
            for (int corner = 0; corner < 3; ++corner) {
                const glm::vec3 p(leaf.points[leaf.triangles[t][corner]] - center);
                glVertex3fv(glm::value_ptr(p));
            }
        }
        glEnd();
        glEndList();
    }

    /// OpenCSG takes bounding boxes in normalized device coordinates; without one the whole screen is assumed.
    void add(const csg::solid::Geometry& geometry, const goldfeather::Product& product) {
        auto& literals = products_.emplace_back();
        for (const goldfeather::Literal& l : product.literals) {
            const csg::solid::PlacedLeaf& leaf = geometry.leaves[l.leaf];
            literals.push_back(std::make_unique<Literal>(l.complement ? OpenCSG::Subtraction : OpenCSG::Intersection,
                                                         leaf.solid->convex ? 1U : 8U, first_list_ + l.leaf));
            const base::View::Rectangle r = view_->screen_box(leaf.box.lo, leaf.box.hi);
            const auto ndc = [](int v, int size) {
                return 2.0F * static_cast<float>(v) / static_cast<float>(size) - 1;
            };
            literals.back()->setBoundingBox(ndc(r.x0, view_->size().x), ndc(r.y0, view_->size().y), -1,
                                            ndc(r.x1, view_->size().x), ndc(r.y1, view_->size().y), 1);
        }
    }

    void set_matrices(glm::ivec2 size) const {
        const auto [n, f] = range_;
        const double top = view_->half_height() * (view_->orthographic() ? 1 : n);
        const double right = top * size.x / size.y;
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        if (view_->orthographic()) {
            glOrtho(-right, right, -top, top, n, f);
        } else {
            glFrustum(-right, right, -top, top, n, f);
        }
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixd(glm::value_ptr(eye_from_local_));
    }

    Context context_;
    std::optional<base::View> view_;
    Range range_{1, 2};
    glm::dmat4 eye_from_local_{1.0};
    GLuint first_list_ = 0;
    GLsizei list_count_ = 0;
    std::vector<std::vector<std::unique_ptr<Literal>>> products_;
};

}  // namespace

bool built() {
    return true;
}

MaybeOpenCsg create(glm::ivec2 largest_size) {
    try {
        return {std::make_unique<Engine>(largest_size), {}};
    } catch (const std::exception& error) {
        return {nullptr, error.what()};
    }
}

}  // namespace opencsg

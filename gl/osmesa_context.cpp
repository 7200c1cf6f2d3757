// OSMesa is opened at run time: its library brings its own OpenGL, which must not meet EGL's at link time, and Mesa
// 25.1 no longer has it. Nothing but this file knows of it.
#include <dlfcn.h>

#include <array>

#include "gl/context.h"
#include "gl/error.h"

namespace gl {
namespace {

// OSMesa's interface; its own header cannot stand beside <GL/glcorearb.h>.
using OSMesaContext = void*;
using CreateContextAttribs = OSMesaContext (*)(const int* attributes, OSMesaContext share);
using DestroyContext = void (*)(OSMesaContext);
using MakeCurrent = GLboolean (*)(OSMesaContext, void* buffer, GLenum type, GLsizei width, GLsizei height);
using GetProcAddress = void (*(*)(const char* name))();
constexpr int kFormat = 0x22, kRgba = GL_RGBA, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34,
              kMajorVersion = 0x36, kMinorVersion = 0x37;

class OsmesaContext final : public Context {
  public:
    OsmesaContext() : Context(ContextKind::Osmesa) {
        for (const char* library : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
            if ((library_ = dlopen(library, RTLD_NOW | RTLD_LOCAL))) {
                break;
            }
        }
        if (!library_) {
            throw Error("OSMesa is not installed (libOSMesa.so.8)");
        }
        const auto create = symbol<CreateContextAttribs>("OSMesaCreateContextAttribs");
        destroy_ = symbol<DestroyContext>("OSMesaDestroyContext");
        activate_ = symbol<MakeCurrent>("OSMesaMakeCurrent");
        const auto address = symbol<GetProcAddress>("OSMesaGetProcAddress");
        const int attributes[] = {kFormat,       kRgba, kDepthBits,    0, kProfile, kCoreProfile,
                                  kMajorVersion, 4,     kMinorVersion, 5, 0};
        context_ = create(attributes, nullptr);
        if (!context_) {
            throw Error("OSMesa gives no OpenGL 4.5 core context");
        }
        make_current();
        functions_ = Functions::load([&](const char* n) { return reinterpret_cast<void*>(address(n)); });
    }

    ~OsmesaContext() override {
        if (context_) {
            destroy_(context_);
        }
        // The library stays loaded: LLVM's threads may still be leaving it.
    }

    void make_current() override {
        if (!activate_(context_, front_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
            throw Error("OSMesaMakeCurrent failed");
        }
    }

  private:
    template <typename Function>
    Function symbol(const char* name) {
        const auto found = reinterpret_cast<Function>(dlsym(library_, name));
        if (!found) {
            throw Error(std::string("OSMesa has no ") + name);
        }
        return found;
    }

    void* library_ = nullptr;
    OSMesaContext context_ = nullptr;
    DestroyContext destroy_ = nullptr;
    MakeCurrent activate_ = nullptr;
    std::array<unsigned char, 4> front_{};  ///< OSMesa wants a front buffer; nothing is drawn to it.
};

}  // namespace

std::unique_ptr<Context> create_osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

}  // namespace gl

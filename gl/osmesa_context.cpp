// OSMesa is opened at run time: its library brings its own OpenGL, which must not meet EGL's at link time, and Mesa
// 25.1 no longer has it. Nothing but this file knows of it.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>

#include "gl/context.h"
#include "gl/error.h"

namespace gl {
namespace {

class OsmesaContext final : public Context {
  public:
    OsmesaContext() : Context(ContextKind::Osmesa) {
        for (const char* library : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
            if ((library_ = dlopen(library, RTLD_NOW | RTLD_LOCAL)))
                break;
        if (!library_)
            throw Error("OSMesa is not installed (libOSMesa.so.8)");
        const auto create = symbol<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
        destroy_ = symbol<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
        activate_ = symbol<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
        const auto address = symbol<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  4,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  5,
                                  0};
        context_ = create(attributes, nullptr);
        if (!context_)
            throw Error("OSMesa gives no OpenGL 4.5 core context");
        make_current();
        functions_ = Functions::load([&](const char* n) { return reinterpret_cast<void*>(address(n)); });
    }

    ~OsmesaContext() override {
        if (context_)
            destroy_(context_);
        // The library stays loaded: LLVM's threads may still be leaving it.
    }

    void make_current() override {
        if (!activate_(context_, front_.data(), GL_UNSIGNED_BYTE, 1, 1))
            throw Error("OSMesaMakeCurrent failed");
    }

  private:
    template <typename Function>
    Function symbol(const char* name) {
        const auto found = reinterpret_cast<Function>(dlsym(library_, name));
        if (!found)
            throw Error(std::string("OSMesa has no ") + name);
        return found;
    }

    void* library_ = nullptr;
    OSMesaContext context_ = nullptr;
    decltype(&OSMesaDestroyContext) destroy_ = nullptr;
    decltype(&OSMesaMakeCurrent) activate_ = nullptr;
    std::array<unsigned char, 4> front_{};  ///< OSMesa wants a front buffer; nothing is drawn to it.
};

}  // namespace

std::unique_ptr<Context> create_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace gl

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <fmt/format.h>

#include <vector>

#include "gl/context.h"
#include "gl/error.h"

namespace gl {
namespace {

class EglContext final : public Context {
  public:
    EglContext() : Context(ContextKind::Egl) {
        // A real device first, then Mesa's surfaceless platform: both work without a display.
        std::string tried;
        for (EGLDisplay display : displays()) {
            if (open(display, tried)) {
                return;
            }
        }
        throw Error("EGL gives no OpenGL 4.5 core context (" + (tried.empty() ? "no display" : tried) + ")");
    }

    ~EglContext() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }

    void make_current() override {
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            throw Error(fmt::format("eglMakeCurrent failed (0x{:x})", eglGetError()));
        }
    }

  private:
    static std::vector<EGLDisplay> displays() {
        std::vector<EGLDisplay> found;
        const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
        const auto device_string =
            reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
        if (query && device_string) {
            EGLDeviceEXT devices[16];
            EGLint count = 0;
            if (query(16, devices, &count)) {
                for (EGLint i = 0; i < count; ++i) {
                    const char* extensions = device_string(devices[i], EGL_EXTENSIONS);
                    if (extensions && std::string(extensions).find("EGL_MESA_device_software") != std::string::npos) {
                        continue;
                    }
                    found.push_back(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
                }
            }
        }
        found.push_back(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        return found;
    }

    bool open(EGLDisplay display, std::string& tried) {
        const auto failed = [&](const char* what) {
            tried += fmt::format("{}{} 0x{:x}", tried.empty() ? "" : ", ", what, eglGetError());
            return false;
        };
        if (display == EGL_NO_DISPLAY) {
            return false;
        }
        if (!eglInitialize(display, nullptr, nullptr)) {
            return failed("eglInitialize");
        }
        if (!eglBindAPI(EGL_OPENGL_API)) {
            return failed("eglBindAPI");
        }
        const EGLint attributes[] = {
            EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context == EGL_NO_CONTEXT) {
            return failed("eglCreateContext");
        }
        if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
            failed("eglMakeCurrent");
            eglDestroyContext(display, context);
            return false;
        }
        display_ = display;
        context_ = context;
        functions_ = Functions::load([](const char* n) { return reinterpret_cast<void*>(eglGetProcAddress(n)); });
        return true;
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> create_egl_context() {
    return std::make_unique<EglContext>();
}

}  // namespace gl

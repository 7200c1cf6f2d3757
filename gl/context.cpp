#include "gl/context.h"

#include <filesystem>
#include <utility>

#include "gl/error.h"

namespace gl {
namespace {

std::string text(const GLubyte* s) {
    return s ? reinterpret_cast<const char*>(s) : "";
}

class AdoptedContext final : public Context {
  public:
    AdoptedContext(const SymbolLoader& loader, std::function<void()> activate)
        : Context(ContextKind::Window), activate_(std::move(activate)) {
        functions_ = Functions::load(loader);
    }
    void make_current() override { activate_(); }

  private:
    std::function<void()> activate_;
};

}  // namespace

const char* name(ContextKind kind) {
    switch (kind) {
        case ContextKind::Auto:
            return "auto";
        case ContextKind::Egl:
            return "egl";
        case ContextKind::Osmesa:
            return "osmesa";
        case ContextKind::Window:
            return "window";
    }
    return "";
}

std::string Context::renderer() const {
    return text(functions_.GetString(GL_RENDERER));
}
std::string Context::version() const {
    return text(functions_.GetString(GL_VERSION));
}

bool Context::software() const {
    const std::string r = renderer();
    for (const char* s : {"llvmpipe", "softpipe", "SWR", "swrast", "Software"}) {
        if (r.find(s) != std::string::npos) {
            return true;
        }
    }
    return false;
}

bool gpu_possible() {
    // Render nodes of the kernel's drivers, NVIDIA's own devices, and that of Windows' subsystem for Linux.
    for (const auto& [folder, prefix] : {std::pair{"/dev/dri", "renderD"}, {"/dev", "nvidia"}, {"/dev", "dxg"}}) {
        std::error_code error;
        for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
            if (at->path().filename().string().starts_with(prefix)) {
                return true;
            }
        }
    }
    return false;
}

std::unique_ptr<Context> create_context(ContextKind kind) {
    switch (kind) {
        case ContextKind::Egl:
            return create_egl_context();
        case ContextKind::Osmesa:
            return create_osmesa_context();
        case ContextKind::Window:
            throw Error("a window's context is adopted, not created");
        case ContextKind::Auto:
            break;
    }
    std::string first;
    try {
        return create_egl_context();
    } catch (const Error& e) {
        first = e.what();
    }
    try {
        return create_osmesa_context();
    } catch (const Error& e) {
        throw Error(first + "; " + e.what());
    }
}

std::unique_ptr<Context> adopt_context(const SymbolLoader& loader, std::function<void()> activate) {
    return std::make_unique<AdoptedContext>(loader, std::move(activate));
}

}  // namespace gl

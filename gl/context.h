// OpenGL 4.5 core contexts: without a display through EGL or OSMesa, or a window's own.
#pragma once

#include <memory>
#include <string>

#include "gl/functions.h"

namespace gl {

enum class ContextKind {
    Auto,    ///< EGL, and OSMesa where EGL cannot be had.
    Egl,     ///< EGL surfaceless: a GPU, or Mesa's software renderer.
    Osmesa,  ///< Mesa's off-screen renderer: software, no EGL, no display.
    Window,  ///< Made by somebody else and adopted.
};

/// "auto", "egl", "osmesa", "window".
[[nodiscard]] const char* name(ContextKind kind);

/// A current OpenGL context and its function table. Move-free: owners keep it in a unique_ptr and pass
/// `const Functions&` on. Everything made with it must be destroyed before it.
class Context {
  public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes the context current in the calling thread.
    virtual void make_current() = 0;

    [[nodiscard]] const Functions& functions() const { return functions_; }
    [[nodiscard]] ContextKind kind() const { return kind_; }
    [[nodiscard]] std::string renderer() const;  ///< As the driver names itself.
    [[nodiscard]] std::string version() const;
    /// True where OpenGL is computed by the CPU.
    [[nodiscard]] bool software() const;

  protected:
    explicit Context(ContextKind kind) : kind_(kind) {}
    Functions functions_;

  private:
    ContextKind kind_;
};

/// May a GPU compute OpenGL on this machine? False where the system has no device of one: any context would be
/// software.
[[nodiscard]] bool gpu_possible();

/// Makes a context and makes it current. Throws gl::Error saying what was tried and how it failed.
[[nodiscard]] std::unique_ptr<Context> create_context(ContextKind kind);

/// Adopts the window's context that is current in the calling thread, with the window system's symbol loader.
/// `make_current` calls `activate`.
[[nodiscard]] std::unique_ptr<Context> adopt_context(const SymbolLoader& loader, std::function<void()> activate);

// One file each.
[[nodiscard]] std::unique_ptr<Context> create_egl_context();
[[nodiscard]] std::unique_ptr<Context> create_osmesa_context();

}  // namespace gl

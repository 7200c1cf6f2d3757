#include "gl/functions.h"

#include <string>

#include "gl/error.h"

namespace gl {
namespace {

template <typename Function>
void find(Function& function, const SymbolLoader& loader, const char* name) {
    function = reinterpret_cast<Function>(loader(name));
    if (!function) {
        throw Error(std::string("this OpenGL has no function ") + name + "; OpenGL 4.5 core is needed");
    }
}

}  // namespace

Functions Functions::load(const SymbolLoader& loader) {
    Functions f;
#define CSGSCOPE_GL_FIND(type, name) find(f.name, loader, "gl" #name);
    CSGSCOPE_GL_FUNCTIONS(CSGSCOPE_GL_FIND)
#undef CSGSCOPE_GL_FIND
    return f;
}

}  // namespace gl

// The one exception of gl/: something that OpenGL could not give (a context, a program, a framebuffer).
#pragma once

#include <stdexcept>

namespace gl {

class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace gl

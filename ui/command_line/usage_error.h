// What is wrong with what the user asks for.
#pragma once

#include <stdexcept>

namespace ui {

/// What the user asked for cannot be done as asked; the text is for people.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace ui

// Running out of memory, and what for.
#pragma once

#include <memory>
#include <new>
#include <string>

namespace csg {

/// There is no memory for something. Never a reason to go on without it: it passes through to whoever began the run.
class OutOfMemory : public std::bad_alloc {
  public:
    /// `what_for`: "file:line: this object".
    explicit OutOfMemory(std::string what_for) : what_for_(std::make_shared<const std::string>(std::move(what_for))) {}
    /// What the memory was for.
    [[nodiscard]] const char* what() const noexcept override { return what_for_->c_str(); }

  private:
    std::shared_ptr<const std::string> what_for_;  ///< Shared: exceptions are copied, which must not fail.
};

}  // namespace csg

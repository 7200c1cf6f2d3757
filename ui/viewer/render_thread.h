// A renderer on a thread of its own, with an OpenGL context of its own: where the processor draws the pictures, the
// window does not wait for them.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "ui/pipeline/picture/renderer.h"

namespace ui {

class RenderThread {
  public:
    /// Must not throw.
    using Task = std::function<void(Renderer&)>;

    /// Waits until the thread has its context. Throws gl::Error where it can have none.
    explicit RenderThread(const goldfeather::EngineOptions& engine);
    /// Drops the tasks that wait, and waits for the one that runs.
    ~RenderThread() = default;
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    /// Tasks run one after the other.
    void post(Task task);
    /// A task runs or waits.
    [[nodiscard]] bool busy() const;

  private:
    void work(Renderer& renderer, const std::stop_token& end);

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Task> tasks_;
    bool works_ = false;
    std::jthread thread_;  ///< Last: it uses all of the above.
};

}  // namespace ui

#include "ui/viewer/render_thread.h"

#include <exception>
#include <future>
#include <utility>

namespace ui {

RenderThread::RenderThread(const goldfeather::EngineOptions& engine) {
    std::promise<void> ready;
    auto begun = ready.get_future();
    thread_ = std::jthread([this, engine, ready = std::move(ready)](const std::stop_token& end) mutable {
        // Context and renderer live and die on this thread, where the context is current.
        std::unique_ptr<gl::Context> context;
        std::optional<Renderer> renderer;
        try {
            if (gl::gpu_possible()) {
                context = gl::create_context(gl::ContextKind::Auto);
                renderer.emplace(*context, engine);
            } else {
                renderer.emplace(engine);
            }
        } catch (...) {
            ready.set_exception(std::current_exception());
            return;
        }
        ready.set_value();
        work(*renderer, end);
    });
    begun.get();
}

void RenderThread::work(Renderer& renderer, const std::stop_token& end) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, end, [this] { return !tasks_.empty(); }) && !end.stop_requested()) {
        const Task task = std::move(tasks_.front());
        tasks_.pop_front();
        works_ = true;
        lock.unlock();
        task(renderer);
        lock.lock();
        works_ = false;
    }
}

void RenderThread::post(Task task) {
    {
        std::scoped_lock lock(mutex_);
        tasks_.push_back(std::move(task));
    }
    changed_.notify_all();
}

bool RenderThread::busy() const {
    std::scoped_lock lock(mutex_);
    return works_ || !tasks_.empty();
}

}  // namespace ui

// A thread that works on the newest job only: a newer one stops the older, whose result is dropped.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace ui {

/// All members may be called from any thread.
template <typename Result>
class LatestJob {
  public:
    /// Must not throw; should end soon once its token is asked to stop.
    using Job = std::function<Result(std::stop_token)>;

    /// `wake` is called from the thread of the jobs whenever a result can be taken.
    explicit LatestJob(std::function<void()> wake = {})
        : wake_(std::move(wake)), thread_([this](std::stop_token stop) { work(stop); }) {}

    /// Stops the job that runs and waits for it.
    ~LatestJob() {
        std::scoped_lock lock(mutex_);
        next_.reset();
        running_.request_stop();
    }

    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    /// Drops what is not taken yet, asks the job that runs to stop, and works on `job` next.
    void start(Job job) {
        {
            std::scoped_lock lock(mutex_);
            next_ = std::move(job);
            result_.reset();
            running_.request_stop();
        }
        changed_.notify_all();
    }

    /// Works on `job` next, when the one that runs has ended and its result could be taken.
    void start_after(Job job) {
        {
            std::scoped_lock lock(mutex_);
            next_ = std::move(job);
        }
        changed_.notify_all();
    }

    /// Asks the job that runs to stop, and drops all others and what is not taken yet.
    void cancel() {
        std::scoped_lock lock(mutex_);
        next_.reset();
        result_.reset();
        running_.request_stop();
    }

    /// The result of the newest job, once.
    [[nodiscard]] std::optional<Result> take() {
        std::scoped_lock lock(mutex_);
        return std::exchange(result_, std::nullopt);
    }

    /// A job runs or waits to run.
    [[nodiscard]] bool busy() const {
        std::scoped_lock lock(mutex_);
        return next_.has_value() || works_;
    }

  private:
    void work(const std::stop_token& end) {
        std::unique_lock lock(mutex_);
        while (changed_.wait(lock, end, [this] { return next_.has_value(); })) {
            const Job job = *std::exchange(next_, std::nullopt);
            running_ = std::stop_source();
            works_ = true;
            lock.unlock();
            Result result = job(running_.get_token());
            lock.lock();
            works_ = false;
            if (!running_.stop_requested()) {
                result_ = std::move(result);
                lock.unlock();
                if (wake_) {
                    wake_();
                }
                lock.lock();
            }
        }
    }

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> next_;
    std::optional<Result> result_;
    std::stop_source running_;
    bool works_ = false;
    std::jthread thread_;  ///< Last: it uses all of the above.
};

}  // namespace ui

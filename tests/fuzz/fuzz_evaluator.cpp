// Any bytes are a program: evaluating it within small limits neither crashes, nor hangs, nor takes memory without
// bound.
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "csg/scad/scad.h"
#include "csg/scad/text/csg_text.h"

namespace {

using namespace csg::scad;

/// Stops an evaluation that takes longer than its time. One thread serves all of them.
class Watchdog {
  public:
    void watch(std::stop_source& evaluation) {
        const std::scoped_lock lock(mutex_);
        evaluation_ = &evaluation;
        deadline_ = std::chrono::steady_clock::now() + kLongest;
    }
    void leave() {
        const std::scoped_lock lock(mutex_);
        evaluation_ = nullptr;
    }

  private:
    static constexpr std::chrono::seconds kLongest{2};
    void run(const std::stop_token& done) {
        std::unique_lock lock(mutex_);
        while (!never_.wait_for(lock, done, std::chrono::milliseconds(200), [] { return false; }) &&
               !done.stop_requested()) {
            if (evaluation_ != nullptr && std::chrono::steady_clock::now() > deadline_) {
                evaluation_->request_stop();
            }
        }
    }
    std::mutex mutex_;
    std::condition_variable_any never_;
    std::stop_source* evaluation_ = nullptr;
    std::chrono::steady_clock::time_point deadline_;
    std::jthread thread_{[this](const std::stop_token& done) { run(done); }};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Watchdog watchdog;
    Request request;
    request.path = "fuzz.scad";
    request.text = std::string(reinterpret_cast<const char*>(data), size);
    request.reader = [](const std::string& path) -> ReadResult {
        return ReadError{true, "cannot read " + path + ": there are no files here"};
    };
    request.search_path.clear();
    request.limits.stack_bytes = std::size_t{32} << 20;
    request.limits.list_elements = 100'000;
    request.limits.nodes = 2'000;
    request.limits.tail_calls = 1'000;
    std::stop_source stop;
    request.stop = stop.get_token();
    watchdog.watch(stop);
    std::size_t bytes = 0;
    const Evaluation evaluation = evaluate(request, [&](const Message& message, const SourceSet& sources) {
        bytes += render_openscad(message, sources).size() + render(message, sources).size();
    });
    if (evaluation.ok) {
        bytes += csg_text(*evaluation.tree).size();
    }
    watchdog.leave();
    return 0;
}

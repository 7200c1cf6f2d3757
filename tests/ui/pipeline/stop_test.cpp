// Pictures that are asked to stop: they end soon, and leave nothing behind.
#include "base/stop.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <thread>

#include "tests/support/gl_test.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// A block, and so many balls in it in three directions, each cut out or not.
std::shared_ptr<const Model> bored_block(int side) {
    csg::TreeBuilder builder;
    builder.file("m.scad");
    const auto ball = builder.leaf(csg::Sphere{0.7, csg::Fineness{48, 12, 2}}, {});
    std::vector<csg::NodeId> nodes{builder.leaf(csg::Cube{glm::dvec3(side), false}, {})};
    for (int i = 0; i < side * side * side; ++i) {
        glm::dmat4 move(1.0);
        move[3] = {i % side + 0.53, i / side % side + 0.51, i / side / side + 0.49, 1};
        nodes.push_back(builder.transform(move, std::array{ball}, {}));
    }
    const auto root = builder.combine(csg::Operation::Difference, nodes, {});
    return ModelBuilder().build(std::make_shared<const csg::Tree>(builder.finish(root)));
}

struct Way {
    const goldfeather::EngineInfo* engine = nullptr;  ///< Null: no OpenGL at all.
    const char* style;
    int layers;
    int size;  ///< Of the picture: it takes some seconds at most.
};

std::vector<Way> ways() {
    using goldfeather::find_engine;
    return {{nullptr, "shaded", 0, 384},
            {nullptr, "blueprint", 0, 384},
            {nullptr, "sketch", 0, 384},
            {find_engine("lists-cpu"), "sketch", 0, 384},
            {find_engine("lists"), "shaded", 0, 256},
            {find_engine("goldfeather"), "blueprint", 2, 96},
            {find_engine("scs"), "shaded", 1, 128}};
}

PictureRequest request_of(const Way& way, int side, double distance = 16) {
    PictureRequest request;
    request.camera.target = glm::dvec3(2.5);
    request.camera.distance = distance;
    request.size = {side, side};
    request.draw_as(*npr::find_style(way.style));
    request.layers = way.layers;
    request.samples = 1;
    return request;
}

/// Asks for a stop after a while; when it did is known then.
class Alarm {
  public:
    explicit Alarm(Seconds delay)
        : thread_([this, delay](const std::stop_token& end) {
              std::unique_lock lock(mutex_);
              if (!never_.wait_for(lock, end, delay, [] { return false; }) && !end.stop_requested()) {
                  rang_ = Clock::now();
                  source_.request_stop();
              }
          }) {}
    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
    [[nodiscard]] Clock::time_point rang() const { return rang_; }

  private:
    std::mutex mutex_;
    std::condition_variable_any never_;
    std::stop_source source_;
    Clock::time_point rang_{};
    std::jthread thread_;
};

class StopTest : public test_support::GlTest {
  protected:
    [[nodiscard]] Renderer renderer(const Way& way) const {
        return way.engine ? Renderer(*context_, way.engine, Painter::OpenGl) : Renderer({}, Painter::Cpu);
    }
};

TEST_P(StopTest, EndsSoonAndTheNextPictureIsRight) {
    const auto model = bored_block(5);
    for (const Way& way : ways()) {
        Renderer drawing = renderer(way), fresh = renderer(way);
        // Of one size, so that what a stopped picture leaves would be seen beside the far model.
        const PictureRequest near = request_of(way, way.size), far = request_of(way, way.size, 70);
        const base::Image expected = fresh.render(*model, far);
        (void)drawing.render(*model, far);  // Programs are compiled, and the model is held.
        const auto begun = Clock::now();
        (void)drawing.render(*model, near);
        const Seconds whole = Clock::now() - begun;
        double longest = 0;
        int stopped = 0;
        for (int i = 0; i < 5; ++i) {
            const Alarm alarm(whole * (i / 6.0));
            try {
                (void)drawing.render(*model, near, alarm.token());
            } catch (const base::Stopped&) {
                longest = std::max(longest, Seconds(Clock::now() - alarm.rang()).count());
                ++stopped;
            }
            EXPECT_EQ(drawing.render(*model, far).rgba, expected.rgba) << way.style;
        }
        const auto name = way.engine != nullptr ? way.engine->name : "no OpenGL";
        std::cout << fmt::format("{}, {}: whole {:.0f} ms, {} stopped, at most {:.0f} ms after it was asked for\n",
                                 name, way.style, 1000 * whole.count(), stopped, 1000 * longest);
        EXPECT_GE(stopped, 2) << name << ' ' << way.style;
        // About 20 ms where nothing else runs; other tests do.
        EXPECT_LT(longest, std::max(0.2, 0.3 * whole.count())) << name << ' ' << way.style;
    }
}

TEST_P(StopTest, NothingIsBegunAfterIt) {
    const auto model = bored_block(2);
    std::stop_source stop;
    stop.request_stop();
    for (const Way& way : ways()) {
        Renderer drawing = renderer(way);
        EXPECT_THROW((void)drawing.render(*model, request_of(way, 64), stop.get_token()), base::Stopped) << way.style;
        const base::Image after = drawing.render(*model, request_of(way, 64));
        EXPECT_EQ(after.rgba, renderer(way).render(*model, request_of(way, 64)).rgba) << way.style;
        // A token that is never asked for draws in pieces, and the same.
        std::stop_source never;
        EXPECT_EQ(drawing.render(*model, request_of(way, 64), never.get_token()).rgba, after.rgba) << way.style;
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, StopTest, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace
}  // namespace ui

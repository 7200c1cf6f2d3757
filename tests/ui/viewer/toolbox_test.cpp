// Who gets input first: tools at hand, the tool in hand, then the camera; and what the tools of the window do with it.
#include "ui/viewer/toolbox.h"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

#include "tests/ui/viewer/small_model.h"

namespace ui {
namespace {

/// Takes drags left of the middle, if it is the handle; writes down what happens.
class Scribe : public Tool {
  public:
    explicit Scribe(std::string name, bool handle) : name_(std::move(name)), handle_(handle) {}

    void begin(ToolContext&) override { note("begin"); }
    void end(ToolContext&) override { note("end"); }
    bool hover(ToolContext&, const std::optional<glm::dvec2>& at) override { return at && handle_ && at->x < 100; }
    bool press(ToolContext&, const PointerEvent& event) override {
        const bool takes = handle_ && event.position.x < 100;
        if (takes) {
            note("press");
        }
        return takes;
    }
    void drag(ToolContext&, const glm::dvec2&) override { note("drag"); }
    void release(ToolContext&, const glm::dvec2&) override { note("release"); }
    void click(ToolContext&, const glm::dvec2&) override { note("click"); }
    bool key(ToolContext&, const KeyEvent& event) override { return !handle_ && event.key == GLFW_KEY_W; }
    void answer(ToolContext&, const ToolAnswer&) override { note("answer"); }

    static std::string& diary() {
        static thread_local std::string text;
        return text;
    }

  private:
    void note(const char* what) const { diary() += name_ + " " + what + ", "; }

    std::string name_;
    bool handle_;
};

class ToolboxTest : public testing::Test {
  protected:
    ToolboxTest() { Scribe::diary().clear(); }

    template <typename Use>
    void use(Use&& use) {
        ToolContext context{
            session_, {{0, 0}, {400, 400}}, 1, camera_, commands_, [this](int key) { return key == held_; }};
        use(context);
    }
    bool send(Toolbox& box, PointerKind kind, glm::dvec2 at, Button button = Button::Left, bool free = true) {
        PointerEvent event;
        event.kind = kind;
        event.position = at;
        event.button = kind == PointerKind::Move ? Button::None : button;
        bool taken = false;
        use([&](ToolContext& context) { taken = box.handle(context, event, free); });
        return taken;
    }

    Session session_{WindowOptions{}, [](const auto&, const auto&, const auto&) { return good_revision(); }, [] {}};
    base::Camera camera_;
    Commands commands_;
    int held_ = 0;
};

constexpr std::array kScribes{
    ToolInfo{"handle", {}, "", [] { return std::unique_ptr<Tool>(std::make_unique<Scribe>("handle", true)); }},
    ToolInfo{"first", Action::SelectTool, "",
             [] { return std::unique_ptr<Tool>(std::make_unique<Scribe>("first", false)); }},
    ToolInfo{"second", Action::FlyTool, "",
             [] { return std::unique_ptr<Tool>(std::make_unique<Scribe>("second", false)); }}};

TEST_F(ToolboxTest, ADragBelongsToTheToolThatTakesIt) {
    Toolbox box(kScribes);
    EXPECT_FALSE(send(box, PointerKind::Press, {200, 50})) << "the camera's";
    EXPECT_FALSE(send(box, PointerKind::Press, {50, 50}, Button::Left, false)) << "a panel lies over it";
    EXPECT_TRUE(send(box, PointerKind::Press, {50, 50}));
    EXPECT_TRUE(box.dragging());
    EXPECT_TRUE(send(box, PointerKind::Move, {600, 50})) << "also outside";
    EXPECT_FALSE(send(box, PointerKind::Release, {600, 50}, Button::Right));
    EXPECT_TRUE(send(box, PointerKind::Release, {600, 50}));
    EXPECT_FALSE(box.dragging());
    EXPECT_EQ(Scribe::diary(), "handle press, handle drag, handle release, ");
}

TEST_F(ToolboxTest, ClicksAndAnswersAreForTheToolInHand) {
    Toolbox box(kScribes);
    use([&](ToolContext& context) {
        box.click(context, {1, 1});
        EXPECT_FALSE(box.key(context, {{}, GLFW_KEY_S}));
        EXPECT_TRUE(box.key(context, {{}, GLFW_KEY_W}));
        EXPECT_FALSE(box.use(context, Action::Quit));
        EXPECT_FALSE(box.cancel(context)) << "nothing is to be given up";
        EXPECT_TRUE(box.use(context, Action::FlyTool));
        box.answer(context, {});
        EXPECT_EQ(box.used(), Action::FlyTool);
        EXPECT_TRUE(box.cancel(context));
        EXPECT_EQ(box.used(), Action::SelectTool);
        EXPECT_TRUE(box.hover(context, glm::dvec2(50, 50)));
        EXPECT_FALSE(box.hover(context, glm::dvec2(150, 50)));
    });
    EXPECT_EQ(Scribe::diary(), "first click, first end, second begin, second answer, second end, first begin, ");
}

TEST_F(ToolboxTest, TheViewCubeLooksFromWhatIsClickedAndTurnsWhereItIsDragged) {
    Toolbox box;
    camera_.rotation = {55, 0, 25};
    // Its middle is 56 from the corner; the upper face is seen 25 * sin(55°) above it.
    const glm::dvec2 top(344, 36);
    EXPECT_TRUE(send(box, PointerKind::Press, top));
    EXPECT_TRUE(send(box, PointerKind::Release, top));
    ASSERT_EQ(commands_.size(), 1U);
    EXPECT_EQ(std::get<LookFrom>(commands_[0]).side, glm::dvec3(0, 0, 1));
    // The corner of the three faces that are seen.
    const glm::dmat3 turn(camera_.eye_from_world());
    const glm::dvec3 corner = 24.0 * (turn * glm::dvec3(1, -1, 1));
    const glm::dvec2 there = glm::dvec2(344, 56) + glm::dvec2(corner.x, -corner.y);
    (void)send(box, PointerKind::Press, there);
    (void)send(box, PointerKind::Release, there);
    ASSERT_EQ(commands_.size(), 2U);
    EXPECT_EQ(std::get<LookFrom>(commands_[1]).side, glm::dvec3(1, -1, 1));
    EXPECT_TRUE(send(box, PointerKind::Press, top));
    EXPECT_TRUE(send(box, PointerKind::Move, top + glm::dvec2(20, 0)));
    EXPECT_TRUE(send(box, PointerKind::Release, top + glm::dvec2(20, 0)));
    EXPECT_EQ(commands_.size(), 2U);
    EXPECT_NEAR(camera_.rotation.z, 25 - 14, 1e-9);
    EXPECT_FALSE(send(box, PointerKind::Press, {100, 300})) << "beside it";
}

TEST_F(ToolboxTest, FlyingTurnsAboutTheEye) {
    Toolbox box;
    camera_.projection = base::Projection::Orthographic;
    use([&](ToolContext& context) { (void)box.use(context, Action::FlyTool); });
    EXPECT_EQ(camera_.projection, base::Projection::Perspective);
    const glm::dvec3 eye = camera_.eye();
    EXPECT_TRUE(send(box, PointerKind::Press, {200, 200}));
    EXPECT_TRUE(send(box, PointerKind::Move, {240, 210}));
    EXPECT_NE(camera_.rotation, base::Camera{}.rotation);
    EXPECT_LT(glm::distance(camera_.eye(), eye), 1e-9);
    held_ = GLFW_KEY_W;
    use([&](ToolContext& context) {
        EXPECT_FALSE(box.advance(context, 0.1)) << "there is no model to fly through";
        EXPECT_TRUE(box.key(context, {{GLFW_KEY_S, 0}, GLFW_KEY_S})) << "not the next style";
        EXPECT_FALSE(box.key(context, {{GLFW_KEY_S, GLFW_MOD_CONTROL}, GLFW_KEY_S}));
    });
}

TEST(Tools, EachIsListedOnce) {
    std::vector<std::string> names;
    for (const ToolInfo& each : tools()) {
        names.emplace_back(each.name);
        if (each.action) {
            EXPECT_NE(std::string(each.hint) == "", each.action != Action::SelectTool) << each.name;
        }
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace ui

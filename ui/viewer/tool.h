// A tool: what the pointer and the keys do in the picture before the camera gets them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ui/pipeline/inspection/measured.h"
#include "ui/pipeline/picture/pick.h"
#include "ui/viewer/commands.h"
#include "ui/viewer/input.h"
#include "ui/viewer/layout.h"
#include "ui/viewer/session.h"
#include "ui/viewer/theme.h"

namespace ui {

/// What lies at a place that a tool has asked for.
struct ToolAnswer {
    glm::dvec2 at{0};                            ///< From the window's corner, as it was asked.
    std::optional<PickedSurface> surface;        ///< The nearest; none where there is nothing.
    std::optional<Measured> face, edge, corner;  ///< That surface, and what is next to the place.
};

/// What a tool sees, and what it may do. Good for one call.
struct ToolContext {
    const Session& session;
    Rectangle picture;  ///< Units of the window; places that tools are given count from the window's corner.
    float scale;        ///< Of the interface, 1 for a common display.
    base::Camera& camera;
    Commands& commands;                 ///< What the tool asks for is done at the end of the frame.
    std::function<bool(int key)> held;  ///< Keys as GLFW numbers them, by their place.
    /// What lies there is wanted: Tool::answer has it some frames later.
    std::optional<glm::dvec2> question{};
};

/// What draws over the picture, behind the panels.
struct ToolPainter {
    ImDrawList& list;
    const Fonts& fonts;
    float scale;
};

/// A drag belongs to the tool whose press() took it, until its button is released; what no tool takes is the camera's.
/// Tools change the camera, and nothing else but by commands.
class Tool {
  public:
    Tool() = default;
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    /// It is taken in hand, and put down.
    virtual void begin(ToolContext& /*context*/) {}
    virtual void end(ToolContext& /*context*/) {}

    /// The pointer moves over the picture with nothing held; `at` is nothing where it has left. True where what draw()
    /// shows is another by that: nothing is drawn anew otherwise.
    virtual bool hover(ToolContext& /*context*/, const std::optional<glm::dvec2>& /*at*/) { return false; }
    /// True: the drag that begins is this tool's.
    virtual bool press(ToolContext& /*context*/, const PointerEvent& /*event*/) { return false; }
    virtual void drag(ToolContext& /*context*/, const glm::dvec2& /*at*/) {}
    virtual void release(ToolContext& /*context*/, const glm::dvec2& /*at*/) {}
    /// The left button was pressed and released without a drag between, and press() had not taken it.
    virtual void click(ToolContext& /*context*/, const glm::dvec2& /*at*/) {}
    /// True: the tool has used the wheel.
    virtual bool scroll(ToolContext& /*context*/, const PointerEvent& /*event*/) { return false; }
    /// True: the tool has used the key, which is no shortcut then.
    virtual bool key(ToolContext& /*context*/, const KeyEvent& /*event*/) { return false; }
    /// What is under way is given up. False where nothing is: then the tool itself is put down.
    virtual bool cancel(ToolContext& /*context*/) { return false; }
    /// Something goes on by itself, such as a flight while a key is held; `seconds` have passed since the frame before.
    /// True where it is to be called again.
    virtual bool advance(ToolContext& /*context*/, double /*seconds*/) { return false; }
    /// To a question; those that were asked while another was being answered are dropped but for the last.
    virtual void answer(ToolContext& /*context*/, const ToolAnswer& /*answer*/) {}
    /// What it has found, in words, to be copied; empty where it has nothing.
    [[nodiscard]] virtual std::string text() const { return {}; }

    virtual void draw(const ToolContext& /*context*/, const ToolPainter& /*painter*/) const {}
};

}  // namespace ui

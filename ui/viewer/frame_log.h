// One line of JSON for each frame that the window shows, for tests and benchmarks.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "base/camera.h"

namespace ui {

struct FrameRecord {
    double time = 0;        ///< Seconds since the window opened, when the frame was shown.
    double ms = 0;          ///< Wall time of the frame.
    double picture_ms = 0;  ///< Of that, for the model's picture; 0 where the frame shows the one before.
    int samples = 0;        ///< In the picture that is shown, of …
    int wanted_samples = 0;
    bool current = false;          ///< That picture is of this frame's camera, model and style, not of those before.
    int divisor = 1;               ///< The picture's resolution is the window's divided by this.
    glm::ivec2 size{0};            ///< Of the picture on the screen, in pixels.
    std::uint64_t generation = 0;  ///< Of the model; 0: none.
    std::string style;
    std::string engine;  ///< That drew the picture; empty before the first.
    std::string state;   ///< Of the document: "evaluating", "good", "failed" or "gone".
    bool evaluating = false;
    std::string selected;  ///< "lid.scad:12", the call of the leaf that is selected; empty: none is.
    int step = 0;          ///< Of $t.
    int text_line = -1;    ///< That the text panel points to, 0: all of the text; -1: it is not shown.
    std::string tool;      ///< ToolInfo::name of the one in hand.
    std::string found;     ///< Tool::text of it.
    int edits = 0;         ///< Steps that can be undone.
    bool unsaved = false;  ///< The text is not that of the file.
    /// Of the inspections.
    struct Inspection {
        std::string task;     ///< That is under way: "check", "measure", "changes"; empty: none.
        double range = 0;     ///< Of the tones of thickness that are seen; 0: none are.
        int thin_places = 0;  ///< That are marked.
        int findings = -1;    ///< Of the last check; -1: there is none.
        double volume = 0;    ///< Of the model, as measured last.
        int changed_parts = -1;
        std::string marked;  ///< The finding or thin place that was clicked.
        std::string error;   ///< Of the last task.
    } inspection;
    /// Of motion and labels.
    struct Dynamics {
        int searches = 0;    ///< That were begun for what moves.
        int bodies = -1;     ///< That move; -1: it is not known.
        int depictions = 0;  ///< That the model has.
        int labels = 0;      ///< Labels, bubbles and frames that are wanted in the picture.
        std::string error;   ///< The first of any text.
    } dynamics;
    base::Camera camera;
};

class FrameLog {
  public:
    /// Opens the file anew; an empty path logs nothing. Throws std::runtime_error where it cannot be opened.
    explicit FrameLog(const std::string& path);
    void write(const FrameRecord& record);

  private:
    std::ofstream file_;
};

}  // namespace ui

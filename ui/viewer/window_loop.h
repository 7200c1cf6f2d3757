// The window at work: input in, commands done, frames out, and rest in between.
#pragma once

#include <memory>
#include <string>

#include "ui/pipeline/stopwatch.h"
#include "ui/viewer/camera_flight.h"
#include "ui/viewer/customizer_panel.h"
#include "ui/viewer/dynamics_panel.h"
#include "ui/viewer/export_form.h"
#include "ui/viewer/export_job.h"
#include "ui/viewer/frame_log.h"
#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/interface.h"
#include "ui/viewer/navigator.h"
#include "ui/viewer/open_form.h"
#include "ui/viewer/palette.h"
#include "ui/viewer/panels.h"
#include "ui/viewer/picture_view.h"
#include "ui/viewer/recent_files.h"
#include "ui/viewer/session.h"
#include "ui/viewer/settings_form.h"
#include "ui/viewer/text_panel.h"
#include "ui/viewer/toolbox.h"
#include "ui/viewer/tree_panel.h"
#include "ui/viewer/window.h"

namespace ui {

class WindowLoop {
  public:
    explicit WindowLoop(const WindowOptions& options);
    /// Until the window is closed.
    WindowEnd run();

  private:
    void frame(const Input& input);
    [[nodiscard]] bool only_hovers(const Input& input);
    /// Ends what is under way, but for a picture that takes too long.
    WindowEnd finish();
    [[nodiscard]] double seconds() const;  ///< Since the window opened.
    /// Of a place in the window, in pixels of its framebuffer.
    [[nodiscard]] glm::ivec2 pixel_corner(const Rectangle& place) const;
    [[nodiscard]] glm::ivec2 pixel_size(const Rectangle& place) const;
    [[nodiscard]] Layout draw_interface(Commands& commands);
    void navigate(const Input& input, Commands& commands);
    void press_keys(const Input& input, Commands& commands);
    /// What goes on without input: flights.
    void advance(Commands& commands);
    void use_tools(const std::function<void(ToolContext&)>& use, Commands& commands);
    /// The camera's picture of the one pixel at a place of the picture.
    [[nodiscard]] base::Camera narrowed(const glm::dvec2& at);
    void perform(const Command& command);
    /// Asks first where something is not saved, what is to become of that. True where it is asked.
    bool asks_before(const Command& command);
    void leave(Leave::How how);
    /// As the file is called, and whether it is saved.
    void renew_title();
    /// False where it is nothing that a tool is concerned with.
    bool perform_by_tools(Action action);
    void select(const glm::dvec2& at);
    void copy(Action action);
    void inspect(const InspectionCommand& command);
    /// What is there is selected, marked, and brought into the middle; `turns`: and the camera to where it is seen.
    void show(const InspectedPlace& place, bool turns);
    void open(const OpenFile& file);
    void export_model(const ExportModel& what);
    void export_frames();
    /// True where an export has ended.
    bool receive_export();
    void save_picture(const WritePicture& what);
    [[nodiscard]] PictureRequest with_glyph_styles(PictureRequest request) const;
    void plan_picture(glm::ivec2 size);
    void draw_picture();
    /// Takes what has become of what the picture's drawer was asked for. True where something is new.
    bool receive();
    void receive(const DrawnStep& drawn);
    void receive(const SavedPicture& saved);
    void receive(const PickedPoint& picked);
    void receive(const ProbedPlace& probed);
    void receive(const PickedSurfaces& picked);
    void log(double frame_ms);

    FrameLog log_;  ///< First: a path that cannot be written is told before the window opens.
    GlfwWindow window_;
    std::unique_ptr<gl::Context> context_;
    Interface interface_;
    InputQueue input_;
    Rectangle picture_place_;  ///< In the last frame.
    bool hovers_ = false;      ///< All that happened last was the pointer moving over the picture.
    PictureView picture_;
    Session session_;
    Inspection inspection_;
    Navigator navigator_;
    Toolbox toolbox_;
    std::optional<glm::dvec2> question_;  ///< Of a tool, from the window's corner, not asked yet.
    bool asked_ = false;                  ///< One is, and its answer is to come.
    CameraFlight flight_;
    double advanced_ = 0;    ///< When advance() was called last.
    bool advances_ = false;  ///< Something goes on without input.
    CustomizerPanel customizer_panel_;
    TextPanel text_panel_;
    TreePanel tree_panel_;
    InspectionPanel inspection_panel_;
    DynamicsPanel dynamics_panel_;
    RecentFiles recent_;
    OpenForm open_form_;
    ExportForm export_form_;
    SettingsForm settings_form_;
    PaletteForm palette_;
    std::optional<Command> leaving_;  ///< That waits for the answer.
    std::string title_;               ///< As it was set last.
    ExportJob export_job_;
    SaveForm save_form_;
    FramePlan plan_;
    std::optional<PictureStep> drawing_;  ///< Asked of picture_, and not received yet.
    PictureRequest wanted_;
    ViewMarks wanted_marks_;
    HeldPart wanted_held_;
    std::optional<ThicknessRequest> wanted_thickness_;
    std::shared_ptr<const Annotations> wanted_annotations_;
    std::shared_ptr<const Model> wanted_model_;
    PictureInfo info_;
    std::uint64_t wanted_version_ = 0, shown_version_ = 0;  ///< Count the pictures that were wanted.
    double picture_ms_ = 0;                                 ///< Spent on steps since the frame before.
    std::string note_;
    float console_height_ = 0;
    std::optional<int> counted_;  ///< Seconds of the evaluation that runs, as they were drawn last.
    int frames_to_draw_ = 0;
    int saving_ = 0;  ///< Pictures that are being saved.
    bool quit_ = false;
    std::chrono::steady_clock::time_point opened_ = std::chrono::steady_clock::now();
};

}  // namespace ui

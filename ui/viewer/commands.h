// What can be done in the window. Keys, menus and panels all give commands; the session carries them out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "csg/scad/customizer/customizer.h"
#include "goldfeather/choice.h"
#include "npr/parameter.h"
#include "ui/pipeline/editable_model.h"
#include "ui/pipeline/picture/picture_request.h"
#include "ui/viewer/dynamics_commands.h"
#include "ui/viewer/inspection_commands.h"
#include "ui/viewer/selection.h"

namespace ui {

enum class Action {
    Open,  ///< Opens the form.
    Reload,
    Cancel,  ///< The evaluation that runs.
    CopyCamera,
    Save,         ///< The program, as it has been edited.
    SavePicture,  ///< Opens the form.
    Export,       ///< Opens the form.
    Quit,
    Undo,
    Redo,
    Duplicate,  ///< The statement that is selected.
    DeleteSelected,
    Palette,
    MirrorX,  ///< Through the middle of what is selected.
    MirrorY,
    MirrorZ,
    RowX,  ///< Three of it, along an axis.
    RowY,
    RowZ,
    CircleZ,  ///< Six of it, about the z axis.
    Group,
    Ungroup,
    MakeUnion,  ///< Of the operation that is selected.
    MakeDifference,
    MakeIntersection,
    MakeHull,
    MakeMinkowski,
    MarkHighlight,  ///< `#` is put before what is selected, or taken away.
    MarkBackground,
    MarkOnly,
    MarkDisabled,
    AddCube,
    AddSphere,
    AddCylinder,
    AddCone,
    AddText,
    AddExtrusion,
    ToggleHole,  ///< What is added is taken away from what is selected.
    ViewAll,
    ResetView,
    LookAtOrigin,
    Top,
    Bottom,
    Left,
    Right,
    Front,
    Back,
    Diagonal,
    ToggleProjection,
    ZoomIn,
    ZoomOut,
    TurnLeft,
    TurnRight,
    TurnUp,
    TurnDown,
    NextStyle,
    PreviousStyle,
    MoreLayers,
    FewerLayers,
    SelectTool,  ///< Takes the tool in hand; see tools().
    MoveTool,
    TurnTool,
    SizeTool,
    ScaleTool,
    FlyTool,
    MeasureTool,
    CopyFound,  ///< What the tool has found, in words.
    ToggleAxes,
    ToggleScales,
    ToggleGrid,
    ToggleCube,
    TogglePanel,
    ToggleText,
    ToggleCustomizer,
    ToggleTree,
    ToggleAnimation,
    PlayPause,
    StepBack,
    StepOn,
    ToggleInspection,
    ToggleDynamics,
    ToggleConsole,
    Settings,  ///< Opens the form.
    ClearConsole,
    CopyConsole,
    Help,
    Close,  ///< What lies over the picture: the form, the help.
};

/// A key with its modifiers, as GLFW numbers them; letters as they are printed on the keyboard.
struct Chord {
    int key = 0;  ///< 0: none.
    int modifiers = 0;
    bool operator==(const Chord&) const = default;
};

// What the controls of the panels give.
struct SetStyle {
    std::size_t style = 0;
};
struct SetParameter {
    std::size_t parameter = 0;  ///< Of the style that is shown.
    npr::Value value;
};
struct ResetParameters {};
struct SetScheme {
    std::size_t scheme = 0;
};
struct SetTransparency {
    npr::Transparency transparency = npr::Transparency::Exact;
};
struct SetTransparencyParameter {
    std::size_t parameter = 0;  ///< Of the model that is shown.
    npr::Value value;
};
/// What parts are made of, and the light in them, in volume.
struct SetMedia {
    std::vector<npr::PartMedium> media;
    npr::MediumLight light;
};
struct SetLayers {
    int layers = -1;
};
struct SetSamples {
    int samples = 4;
};
struct SetSections {
    npr::Sections sections;  ///< Sides and corners go by the camera of now.
};
/// The eye goes that way from where the camera looks: to a side, an edge or a corner of a cube.
struct LookFrom {
    glm::dvec3 side{0, 0, 1};  ///< World coordinates, of any length.
};
/// What is seen at a place of the picture, from its upper left corner.
struct SelectAt {
    glm::dvec2 at{0};
};
/// The place of a text in the text panel.
struct ShowText {
    TextPlace place;
};
/// The file in the user's editor; line and column count from 1.
struct EditText {
    std::string path;
    std::uint32_t line = 1, column = 1;
};
/// Shows what the call does.
struct Explain {
    CallAt call;
};
/// Another of the surfaces behind the point that was clicked.
struct StepSelection {
    int by = 1;
};
/// A call in the model that is shown, of which that is the text and the place ("lid.scad:12").
struct SelectCall {
    csg::OccurrenceId occurrence = csg::kNoOccurrence;
    TextPlace text;
    std::string place;
};
/// What the call makes, wherever it is called from, is left out, or shown again.
struct HideCall {
    CallAt call;
    bool hidden = true;
};
/// Nothing but what the call makes; nothing: all of the model.
struct ShowAlone {
    std::optional<CallAt> call;
};
// Of the animation.
struct SetStep {
    int step = 0;
};
struct SetSteps {
    int steps = 100;
};
struct SetRate {
    double steps_per_second = 20;
};
struct ExportFrames {};
// Of editing by hand.
/// What is held lies there, for as long as it is held; nothing: it goes back.
struct HoldPart {
    HeldPart held;
};
/// It has been put there: the text is to follow.
struct PutPart {
    HeldPart held;
};
/// Another of the ways to edit the text takes the place of the one that was taken; none: there is no more to choose.
struct TakeWay {
    std::optional<std::size_t> way;
};
/// A number of the main file's text becomes another while it is dragged.
struct SetNumber {
    csg::scad::ByteRange bytes;  ///< As they were when the drag began.
    std::string text;
    bool begins = true;  ///< A step of its own, which those after it are part of.
    std::string name;    ///< "h"
};
/// The main file has that text now, by typing.
struct TypeText {
    std::string text;
};
/// What the statement makes that the byte of the main file's text is in.
struct SelectByte {
    std::size_t byte = 0;
};
struct ResolveConflict {
    std::size_t conflict = 0;
    bool take_theirs = false;
};
/// What a killed program has left is taken, or thrown away.
struct Recover {
    bool take = true;
};
/// What is to be done with what is not saved, before it is gone.
struct Leave {
    enum class How { Save, Discard, Stay };
    How how = How::Stay;
};
struct OpenFile {
    std::filesystem::path path;
};
struct SetCustomized {
    std::string parameter;
    csg::scad::CustomizerParameter::Value value;
};
struct ResetCustomized {
    std::string parameter;  ///< Empty: all of them.
};
/// What is done with a parameter set of that name.
struct UseParameterSet {
    std::string name;
};
struct SaveParameterSet {
    std::string name;
};
struct DeleteParameterSet {
    std::string name;
};
struct SetEngine {
    const goldfeather::EngineInfo* engine = nullptr;  ///< Null: chosen for each picture.
};
struct WritePicture {
    std::filesystem::path path;
    PictureRequest picture;
};

/// How the mouse moves the camera.
struct SetMouse {
    std::size_t preset = 0;  ///< Of mouse_presets().
};

struct SetLightTheme {
    bool light = false;
};
struct SetTextSize {
    double size = 1;  ///< One of kTextSizes.
};
/// The action has that key, and no other.
struct SetKey {
    Action action = Action::Open;
    Chord chord;
};
struct ResetKeys {};

struct ExportModel {
    std::filesystem::path path;
};

using Command = std::variant<Action, SetStyle, SetParameter, ResetParameters, SetScheme, SetTransparency,
                             SetTransparencyParameter, SetMedia, SetLayers, SetSamples, SetSections, LookFrom, SelectAt,
                             Explain, ShowText, EditText, StepSelection, OpenFile, SetCustomized, ResetCustomized,
                             UseParameterSet, SaveParameterSet, DeleteParameterSet, SetEngine, WritePicture,
                             ExportModel, SetMouse, SetLightTheme, SetTextSize, SetKey, ResetKeys, SelectCall, HideCall,
                             ShowAlone, SetStep, SetSteps, SetRate, ExportFrames, HoldPart, PutPart, TakeWay, SetNumber,
                             TypeText, SelectByte, ResolveConflict, Recover, Leave, InspectionCommand, DynamicsCommand>;
using Commands = std::vector<Command>;

/// "Ctrl+Shift+V"
[[nodiscard]] std::string text(const Chord& chord);

struct ActionInfo {
    Action action;
    const char* menu;  ///< The menu that it is in.
    const char* label;
    Chord keys[3];  ///< By default; the first is shown in menus. See Keys.
    /// base::Camera::rotation, of actions that look from a standard view.
    std::optional<glm::dvec3> from{};
};

/// All actions, menu by menu.
[[nodiscard]] std::span<const ActionInfo> actions();
/// ActionInfo::from of the action.
[[nodiscard]] std::optional<glm::dvec3> looks_from(Action action);

}  // namespace ui

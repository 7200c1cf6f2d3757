// The parts of the interface. Each draws from state it is given and adds to `commands` what the user asks for; none
// changes anything else. To be called between ImGui::NewFrame and ImGui::Render.
#pragma once

#include <optional>
#include <string>

#include "ui/viewer/session.h"
#include "ui/viewer/theme.h"

namespace ui {

/// What is known of the picture on the screen.
struct PictureInfo {
    int samples = 0, wanted_samples = 0;
    int divisor = 1;
    glm::ivec2 size{0};                ///< Pixels.
    double ms = 0;                     ///< Of the last step.
    goldfeather::EngineChoice engine;  ///< That drew it, and why.
    goldfeather::WalkStats walk;
    std::string error;  ///< Why it could not be drawn; empty where it was.
};

/// Gives its height. `tool`: the action of that in hand.
float draw_menu_bar(const Session& session, const PictureInfo& picture, Action tool, Commands& commands);

/// Style, parameters, colors, layers, samples, camera, figures of the model and of the picture.
void draw_panel(const Rectangle& place, const Session& session, const PictureInfo& picture, const Fonts& fonts,
                Commands& commands);

/// What the parts of the model are made of, in pictures of bodies of media; nothing in others.
void draw_media(const Session& session, Commands& commands);

/// The legend of a radiograph, in the lower left corner of the picture beside the axes; nothing in other styles.
void draw_thickness_legend(const Rectangle& place, const Session& session, const Fonts& fonts, float scale);

/// A control for a parameter of a style; gives true and the new value where the user has changed it.
bool draw_parameter(const npr::Parameter& parameter, npr::Value& value);

/// Messages. `height` follows the drag of its upper edge.
void draw_console(const Rectangle& place, const Session& session, const Fonts& fonts, float& height,
                  Commands& commands);

/// State of the document on the left, where an evaluation that takes long can be canceled, of the picture on the
/// right. `note`: what was done last.
void draw_status(const Rectangle& place, const Session& session, const PictureInfo& picture, const std::string& note,
                 Commands& commands);

/// Over the picture, behind everything else: what is wrong, and the axes.
void draw_overlay(const Rectangle& place, const Session& session, const PictureInfo& picture, const Fonts& fonts,
                  float scale);

/// Over the picture: the shapes of what is selected, as they are before others cut them.
void draw_ghost(const Rectangle& place, const Session& session, float scale);

void draw_animation(const Rectangle& place, const Animation& animation, Commands& commands);

/// The point that is selected, and over the lower edge of the picture what it is of and the calls that made it, each of
/// which shows its text.
void draw_selection(const Rectangle& place, const Session& session, const Fonts& fonts, float scale,
                    Commands& commands);

/// Over the picture: how the text follows what was moved, where edits and the file contradict each other, and what
/// becomes of what is not saved.
void draw_editing(const Rectangle& place, const Session& session, const Fonts& fonts, float scale, Commands& commands);

/// Mouse and keys, as they are set.
void draw_help(const Settings& settings, const Fonts& fonts, Commands& commands);

/// The form for saving a picture; keeps what was typed.
class SaveForm {
  public:
    /// `first`: whose background is proposed.
    SaveForm(std::string proposed_path, const npr::Picture& first);

    /// `shown`: the picture on the screen, whose size is proposed.
    void draw(const PictureRequest& shown, Commands& commands);
    /// Another path is proposed; what was typed goes.
    void propose(std::string path);
    /// Why the last try failed; what is typed then goes to the form again.
    void set_error(std::string error);

  private:
    void fields(const PictureRequest& shown, bool& save);
    [[nodiscard]] bool buttons(bool& save);
    void try_to_save(const PictureRequest& shown, Commands& commands);

    std::string path_;
    std::optional<glm::ivec2> size_;  ///< As it was typed; none: that of the picture on the screen.
    int samples_ = 0;
    bool transparent_;        ///< No background.
    bool focus_ = false;      ///< The path is to be typed next.
    std::string overwrites_;  ///< The path that is there already, as was told; saving once more replaces it.
    std::string error_;
};

}  // namespace ui

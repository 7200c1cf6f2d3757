// The panels show the state and give commands: a robot moves the mouse over ImGui without a window.
#include "ui/viewer/panels.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <chrono>
#include <thread>

#include "tests/support/temporary_folder.h"
#include "tests/ui/viewer/small_model.h"

namespace ui {
namespace {

constexpr Rectangle kPlace{{0, 0}, {320, 1400}};

class Panels : public testing::Test {
  protected:
    Panels() {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = {1280, 1400};
        apply_theme(1, false);
        fonts_ = load_fonts(1);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        WindowOptions options;
        options.source.path = folder_.write("model.scad", "");
        options.picture.draw_as(*npr::find_style("blueprint"));
        session_ = std::make_unique<Session>(
            options, [](const auto&, const auto&, const auto&) { return good_revision(); }, [] {});
    }
    ~Panels() override { ImGui::DestroyContext(); }

    /// One frame of the panel with the mouse at a place; carries out its commands.
    void frame(ImVec2 mouse, bool pressed) {
        ImGuiIO& io = ImGui::GetIO();
        io.DeltaTime = 0.02F;
        io.MousePos = mouse;
        io.MouseDown[0] = pressed;
        ImGui::NewFrame();
        commands_.clear();
        draw(commands_);
        ImGui::Render();
        for (const Command& command : commands_) {
            all_.push_back(command);
            session_->perform(command);
        }
    }
    virtual void draw(Commands& commands) { draw_panel(kPlace, *session_, info_, fonts_, commands); }

    void wait_for_model() {
        for (int now = 0; !session_->document().model() && now < 2000; ++now) {
            session_->update(now);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ASSERT_TRUE(session_->document().model());
    }
    /// Where the control is found by moving the mouse over the panel; fails the test where it is not.
    ImVec2 find(const char* window, ImGuiID id) {
        frame({-100, -100}, false);
        const ImGuiWindow* found = ImGui::FindWindowByName(window);
        for (float y = found->Pos.y + 1; y < found->Pos.y + found->Size.y; y += 5) {
            for (float x = found->Pos.x + 5; x < found->Pos.x + found->Size.x; x += 16) {
                frame({x, y}, false);
                if (ImGui::GetHoveredID() == id) {
                    return {x, y};
                }
            }
        }
        ADD_FAILURE() << "no such control";
        return {0, 0};
    }
    /// The identity of a control of the panel: its path of names or numbers.
    static ImGuiID id(const char* name) { return ImGui::FindWindowByName("Drawing")->GetID(name); }
    ImGuiID parameter_id(const char* name) const {
        ImGuiWindow& window = *ImGui::FindWindowByName("Drawing");
        const ImGuiID style = window.GetID(static_cast<int>(session_->view().style()));
        return ImHashStr(name, 0, style);
    }
    void click(ImVec2 at) {
        frame(at, false);
        frame(at, true);
        frame(at, false);
        frame(at, false);
    }
    const npr::Value& value(const char* name) const {
        const npr::Parameters& values = session_->view().picture.parameters;
        return values.at(*values.find(name));
    }

    test_support::TemporaryFolder folder_;
    Fonts fonts_;
    std::unique_ptr<Session> session_;
    PictureInfo info_;
    Commands commands_, all_;
};

TEST_F(Panels, WithoutInputNothingIsAskedFor) {
    for (int i = 0; i < 5; ++i) {
        frame({-100, -100}, false);
        EXPECT_TRUE(commands_.empty());
    }
}

TEST_F(Panels, AButtonChoosesTheStyle) {
    frame({-100, -100}, false);
    click(find("Drawing", id("Shaded")));
    EXPECT_EQ(session_->view().picture.style->name, "shaded");
}

TEST_F(Panels, AToggleIsTurnedOn) {
    ASSERT_FALSE(std::get<bool>(value("grid")));
    frame({-100, -100}, false);
    const npr::Parameters& values = session_->view().picture.parameters;
    const auto& grid = values.list()[*values.find("grid")];
    click(find("Drawing", parameter_id((std::string(grid.label) + "##grid").c_str())));
    EXPECT_TRUE(std::get<bool>(value("grid")));
}

TEST_F(Panels, ASliderIsDraggedAndStaysInItsRange) {
    frame({-100, -100}, false);
    const float before = std::get<float>(value("width"));
    const ImVec2 at = find("Drawing", parameter_id("##width"));
    frame(at, true);
    frame({at.x + 60, at.y}, true);
    EXPECT_NE(std::get<float>(value("width")), before);
    frame({at.x + 5000, at.y}, true);
    frame({at.x + 5000, at.y}, false);
    EXPECT_EQ(std::get<float>(value("width")), 4);
    click(find("Drawing", parameter_id("Reset parameters")));
    EXPECT_EQ(std::get<float>(value("width")), before);
}

TEST_F(Panels, AChoiceIsMadeInAList) {
    frame({-100, -100}, false);
    ASSERT_EQ(std::get<int>(value("ground")), 0);
    click(find("Drawing", parameter_id("##ground")));
    ImGuiWindow* list = ImGui::FindWindowByName("##Combo_00");
    ASSERT_NE(list, nullptr);
    // `find` moves the mouse over the open list, which stays open until something is clicked.
    click(find("##Combo_00", list->GetID("white")));
    EXPECT_EQ(std::get<int>(value("ground")), 1);
}

TEST_F(Panels, LayersAreChosenWhereTheStyleDoesNot) {
    frame({-100, -100}, false);
    click(find("Drawing", id("As the style needs")));
    EXPECT_EQ(session_->view().picture.layers, 0) << "all";
    frame({-100, -100}, false);
    session_->see_layers(*cube_model(), 4);
    const ImVec2 at = find("Drawing", id("##layers"));
    frame(at, true);
    frame({kPlace.corner.x + 2, at.y}, true);
    frame({kPlace.corner.x + 2, at.y}, false);
    EXPECT_EQ(session_->view().picture.layers, 1);
}

TEST_F(Panels, PartsAreMadeMedia) {
    session_->perform(SetStyle{0});
    wait_for_model();
    session_->perform(SetTransparency{npr::Transparency::Volume});
    frame({-100, -100}, false);
    const ImGuiID media = id("media"), part = ImHashStr("model", 0, media);
    const ImVec2 box = find("Drawing", ImHashStr("##medium", 0, part));
    click(box);
    ASSERT_EQ(session_->view().picture.media.size(), 1U);
    EXPECT_EQ(session_->view().picture.media[0].part, "model");
    const float before = *session_->view().picture.media[0].attenuation;
    const ImVec2 slider = find("Drawing", ImHashStr("##tau", 0, part));
    frame(slider, true);
    frame({kPlace.corner.x + 30, slider.y}, true);
    frame({kPlace.corner.x + 30, slider.y}, false);
    ASSERT_EQ(session_->view().picture.media.size(), 1U);
    EXPECT_LT(*session_->view().picture.media[0].attenuation, before);
    const ImVec2 light = find("Drawing", ImHashStr("##ambient", 0, media));
    frame(light, true);
    frame({kPlace.corner.x + 2, light.y}, true);
    frame({kPlace.corner.x + 2, light.y}, false);
    EXPECT_EQ(session_->view().picture.medium_light.ambient, 0);
    click(box);
    EXPECT_TRUE(session_->view().picture.media.empty());
}

/// Over pictures of the style that shows thickness, and no others.
class Legend : public Panels {
  protected:
    void draw(Commands& /*commands*/) override {
        draw_thickness_legend({{0, 0}, {600, 600}}, *session_, fonts_, 1);
        drawn_ = ImGui::GetBackgroundDrawList()->VtxBuffer.Size;
    }
    int drawn_ = 0;
};

TEST_F(Legend, IsOfRadiographs) {
    wait_for_model();
    frame({-100, -100}, false);
    EXPECT_EQ(drawn_, 0);
    const npr::StyleInfo* radiograph = npr::find_style("radiograph");
    session_->perform(SetStyle{static_cast<std::size_t>(radiograph - npr::styles().data())});
    frame({-100, -100}, false);
    EXPECT_GT(drawn_, 64 * 4) << "tones and numbers";
}

TEST_F(Panels, EveryKindOfParameterHasAControl) {
    // Parameters of all styles are drawn without a change of their own accord.
    for (std::size_t style = 0; style < npr::styles().size(); ++style) {
        session_->perform(SetStyle{style});
        frame({-100, -100}, false);
        frame({-100, -100}, false);
        EXPECT_TRUE(commands_.empty()) << npr::styles()[style].name;
    }
}

class ConsolePanel : public Panels {
  protected:
    void draw(Commands& commands) override {
        draw_console({{0, 1350 - height_}, {900, height_}}, *session_, fonts_, height_, commands);
    }
    float height_ = 150;
};

TEST_F(ConsolePanel, ItsButtonsAskForCopyingAndClearing) {
    frame({-100, -100}, false);
    const ImGuiID copy = ImGui::FindWindowByName("Console")->GetID("Copy");
    click(find("Console", copy));
    const ImGuiID clear = ImGui::FindWindowByName("Console")->GetID("Clear");
    click(find("Console", clear));
    ASSERT_EQ(all_.size(), 2U);
    EXPECT_EQ(std::get<Action>(all_[0]), Action::CopyConsole);
    EXPECT_EQ(std::get<Action>(all_[1]), Action::ClearConsole);
}

TEST_F(ConsolePanel, ItsEdgeIsDragged) {
    frame({400, 1202}, false);
    frame({400, 1202}, true);
    frame({400, 1100}, true);
    EXPECT_NEAR(height_, 250, 1);
}

class Form : public Panels {
  protected:
    void draw(Commands& commands) override { form_.draw(shown_, commands); }
    static PictureRequest shown() {
        PictureRequest picture;
        picture.draw_as(*npr::find_style("edges"));
        picture.size = {640, 480};
        picture.samples = 1;
        return picture;
    }
    static PictureRequest first() {
        PictureRequest picture;
        picture.transparent_background = true;
        return picture;
    }
    PictureRequest shown_ = shown();
    SaveForm form_{"picture.png", first()};
};

TEST_F(Form, ProposesThePictureAndGivesItBack) {
    frame({-100, -100}, false);
    frame({-100, -100}, false);
    click(find("Save picture", ImGui::FindWindowByName("Save picture")->GetID("Save")));
    ASSERT_EQ(all_.size(), 1U);
    const auto& write = std::get<WritePicture>(all_[0]);
    EXPECT_EQ(write.path, "picture.png");
    PictureRequest expected = shown_;
    expected.samples = 4;
    expected.transparent_background = true;
    EXPECT_EQ(write.picture, expected);
}

TEST_F(Form, IsClosed) {
    frame({-100, -100}, false);
    frame({-100, -100}, false);
    click(find("Save picture", ImGui::FindWindowByName("Save picture")->GetID("Cancel")));
    ASSERT_EQ(all_.size(), 1U);
    EXPECT_EQ(std::get<Action>(all_[0]), Action::Close);
}

class OtherParts : public Panels {
  protected:
    void draw(Commands& commands) override {
        (void)draw_menu_bar(*session_, info_, Action::SelectTool, commands);
        draw_overlay({{0, 30}, {900, 600}}, *session_, info_, fonts_, 1);
        draw_status({{0, 1370}, {1280, 30}}, *session_, info_, "note", commands_);
        draw_help({}, fonts_, commands);
    }
};

class MenuBar : public Panels {
  protected:
    void draw(Commands& commands) override { (void)draw_menu_bar(*session_, info_, Action::SelectTool, commands); }
    /// Opens the menu and clicks an item.
    void choose(const char* menu, const char* item) {
        frame({-100, -100}, false);
        const ImGuiWindow* bar = ImGui::FindWindowByName("##MainMenuBar");
        const ImGuiID menus = ImHashStr("##menubar", 0, bar->ID);
        click(find("##MainMenuBar", ImHashStr(menu, 0, menus)));
        const ImGuiWindow* list = ImGui::FindWindowByName("##Menu_00");
        ASSERT_NE(list, nullptr);
        click(find("##Menu_00", ImHashStr(item, 0, list->ID)));
    }
};

TEST_F(MenuBar, ChoosesTheEngine) {
    info_.engine = {goldfeather::find_engine("lists-cpu"), "as estimated"};
    EXPECT_EQ(session_->view().picture.engine, nullptr);
    choose("Engine", "goldfeather");
    EXPECT_EQ(session_->view().picture.engine, goldfeather::find_engine("goldfeather"));
    EXPECT_EQ(session_->view().request({8, 8}).engine, goldfeather::find_engine("goldfeather"));
    choose("Engine", "Automatic");
    EXPECT_EQ(session_->view().picture.engine, nullptr);
}

TEST_F(OtherParts, HelpIsClosedByItsCross) {
    frame({-100, -100}, false);
    frame({-100, -100}, false);
    EXPECT_TRUE(all_.empty());
    const ImGuiWindow* help = ImGui::FindWindowByName("Keys and mouse");
    click({help->Pos.x + help->Size.x - 15, help->Pos.y + 12});
    ASSERT_EQ(all_.size(), 1U);
    EXPECT_EQ(std::get<Action>(all_[0]), Action::Close);
}

}  // namespace
}  // namespace ui

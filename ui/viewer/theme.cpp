#include "ui/viewer/theme.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string>

namespace ui {

namespace {

constexpr float kTextSize = 15, kMonoSize = 14;  // Pixels on a common display.

/// What file names, echoes and our own texts need: Latin, Greek, Cyrillic, punctuation, arrows, mathematics, shapes.
const ImWchar* glyph_ranges() {
    static constexpr std::array<ImWchar, 17> kRanges{0x20,   0x24F,  0x370,  0x52F,  0x1E00, 0x1EFF,
                                                     0x2000, 0x206F, 0x20A0, 0x20BF, 0x2190, 0x22FF,
                                                     0x25A0, 0x25FF, 0xFFFD, 0xFFFD, 0};
    return kRanges.data();
}

/// The first of the files that is there; empty where none is.
std::string find_font(std::initializer_list<const char*> names) {
    for (const char* name : names) {
        for (const char* root : {"/usr/share/fonts/", "/usr/local/share/fonts/"}) {
            std::error_code ignored;
            if (std::string path = std::string(root) + name; std::filesystem::is_regular_file(path, ignored)) {
                return path;
            }
        }
    }
    return {};
}

ImFont* load(const std::string& path, float size, ImFont* instead) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    ImFont* font =
        path.empty() ? nullptr : atlas.AddFontFromFileTTF(path.c_str(), std::round(size), &config, glyph_ranges());
    if (font == nullptr && instead != nullptr) {
        return instead;
    }
    if (font == nullptr) {
        ImFontConfig built_in;
        built_in.SizePixels = std::round(size);
        font = atlas.AddFontDefault(&built_in);
    }
    return font;
}

/// The colors that all others are made of.
struct Palette {
    ImVec4 text, faint, ground, popup, title, border, raised, high;
    ImVec4 accent, pressed, bright;  ///< Of what is chosen, held, and dragged.
};

Palette palette_of(bool light) {
    if (light) {
        return {{0.11F, 0.12F, 0.14F, 1},  {0.40F, 0.43F, 0.47F, 1}, {0.94F, 0.945F, 0.95F, 1},
                {0.98F, 0.98F, 0.985F, 1}, {0.88F, 0.89F, 0.91F, 1}, {0.76F, 0.78F, 0.81F, 1},
                {0.83F, 0.845F, 0.87F, 1}, {0.76F, 0.79F, 0.83F, 1}, {0.10F, 0.38F, 0.78F, 1},
                {0.55F, 0.73F, 0.97F, 1},  {0.15F, 0.45F, 0.88F, 1}};
    }
    return {{0.88F, 0.89F, 0.91F, 1}, {0.56F, 0.59F, 0.64F, 1}, {0.125F, 0.137F, 0.157F, 1}, {0.15F, 0.165F, 0.19F, 1},
            {0.17F, 0.19F, 0.22F, 1}, {0.26F, 0.28F, 0.32F, 1}, {0.20F, 0.22F, 0.25F, 1},    {0.26F, 0.29F, 0.33F, 1},
            {0.30F, 0.58F, 0.94F, 1}, {0.24F, 0.48F, 0.80F, 1}, {0.45F, 0.70F, 1.0F, 1}};
}

void set_colors(ImGuiStyle& style, const Palette& palette) {
    const auto& [text, faint, ground, popup, title, border, raised, high, accent, pressed, bright] = palette;
    const auto set = [&](std::initializer_list<ImGuiCol_> which, const ImVec4& color) {
        for (const ImGuiCol_ each : which) {
            style.Colors[each] = color;
        }
    };
    set({ImGuiCol_Text}, text);
    set({ImGuiCol_TextDisabled}, faint);
    set({ImGuiCol_WindowBg, ImGuiCol_MenuBarBg}, ground);
    set({ImGuiCol_ChildBg}, {0, 0, 0, 0});
    set({ImGuiCol_PopupBg}, popup);
    set({ImGuiCol_Border, ImGuiCol_Separator}, border);
    set({ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header}, raised);
    set({ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered}, high);
    set({ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive}, pressed);
    set({ImGuiCol_CheckMark, ImGuiCol_SeparatorHovered}, accent);
    set({ImGuiCol_SeparatorActive}, bright);
    // The value is read through the grab.
    set({ImGuiCol_SliderGrab}, {accent.x, accent.y, accent.z, 0.55F});
    set({ImGuiCol_SliderGrabActive}, {bright.x, bright.y, bright.z, 0.65F});
    set({ImGuiCol_TextSelectedBg}, {accent.x, accent.y, accent.z, 0.4F});
    set({ImGuiCol_TitleBg, ImGuiCol_TitleBgActive}, title);
    set({ImGuiCol_ScrollbarBg}, {0, 0, 0, 0});
    set({ImGuiCol_ScrollbarGrab}, raised);
    set({ImGuiCol_ModalWindowDimBg}, {0, 0, 0, 0.35F});
}

}  // namespace

void apply_theme(float scale, bool light) {
    ImGuiStyle style;
    light ? ImGui::StyleColorsLight(&style) : ImGui::StyleColorsDark(&style);
    set_colors(style, palette_of(light));
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.ScrollbarSize = 12;
    style.GrabMinSize = 12;
    style.WindowRounding = 0;
    style.FrameRounding = 4;
    style.PopupRounding = 4;
    style.GrabRounding = 3;
    style.WindowBorderSize = 0;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

Fonts load_fonts(float scale) {
    ImGui::GetIO().Fonts->Clear();
    Fonts fonts;
    fonts.text = load(find_font({"truetype/noto/NotoSans-Regular.ttf", "truetype/dejavu/DejaVuSans.ttf",
                                 "dejavu-sans-fonts/DejaVuSans.ttf", "TTF/DejaVuSans.ttf",
                                 "truetype/liberation/LiberationSans-Regular.ttf",
                                 "truetype/liberation2/LiberationSans-Regular.ttf"}),
                      kTextSize * scale, nullptr);
    fonts.bold =
        load(find_font({"truetype/noto/NotoSans-Bold.ttf", "truetype/dejavu/DejaVuSans-Bold.ttf",
                        "dejavu-sans-fonts/DejaVuSans-Bold.ttf", "TTF/DejaVuSans-Bold.ttf",
                        "truetype/liberation/LiberationSans-Bold.ttf", "truetype/liberation2/LiberationSans-Bold.ttf"}),
             kTextSize * scale, fonts.text);
    fonts.mono = load(find_font({"truetype/dejavu/DejaVuSansMono.ttf", "dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
                                 "TTF/DejaVuSansMono.ttf", "truetype/noto/NotoSansMono-Regular.ttf",
                                 "truetype/liberation/LiberationMono-Regular.ttf",
                                 "truetype/liberation2/LiberationMono-Regular.ttf"}),
                      kMonoSize * scale, nullptr);
    return fonts;
}

}  // namespace ui

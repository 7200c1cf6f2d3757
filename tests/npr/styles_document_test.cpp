// docs/STYLES.md is written from the lists of styles and parameters. CSGSCOPE_UPDATE_GOLDENS=1 in the environment
// writes it anew; tools/styles does so and draws its pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "base/file.h"
#include "base/image.h"
#include "npr/style.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using npr::Parameter;
using npr::ParameterKind;

const fs::path kDocs = fs::path(CSGSCOPE_SOURCE_DIR) / "docs";

std::string range(const Parameter& p) {
    switch (p.kind) {
        case ParameterKind::Number:
        case ParameterKind::Integer:
            return fmt::format("{} to {}", p.min, p.max);
        case ParameterKind::Toggle:
            return "on, off";
        case ParameterKind::Color:
            return "#rrggbb";
        case ParameterKind::Choice:
            break;
    }
    return fmt::format("{}", fmt::join(p.choices, ", "));
}

/// A value that shows what the parameter does: far from the default.
std::string telling_value(const Parameter& p) {
    const bool low = p.kind != ParameterKind::Color && p.kind != ParameterKind::Toggle &&
                     std::visit(
                         [&](const auto& initial) {
                             if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(initial)>>) {
                                 return static_cast<float>(initial) - p.min > p.max - static_cast<float>(initial);
                             }
                             return false;
                         },
                         p.initial);
    const float end = low ? p.min : p.max;
    switch (p.kind) {
        case ParameterKind::Number:
            return npr::text(p, end);
        case ParameterKind::Integer:
            return npr::text(p, static_cast<int>(end));
        case ParameterKind::Toggle:
            return npr::text(p, !std::get<bool>(p.initial));
        case ParameterKind::Color:
            return "#c03020";
        case ParameterKind::Choice:
            break;
    }
    return npr::text(p, (std::get<int>(p.initial) + 1) % static_cast<int>(p.choices.size()));
}

/// What is set in the picture of a parameter.
std::string telling_settings(std::string_view style, const Parameter& p) {
    static const std::map<std::string, std::string, std::less<>> others{
        {"blueprint grid-spacing", "--set grid=on --set grid-spacing=32"},
        {"blueprint layers", "--set layers=2"},
        {"radiograph colors", "--set colors=heat"},
        {"radiograph part", "--parts top --set part=2"},
        {"radiograph range", "--set range=60"},
        {"sketch paper", "--set paper=#24342f --set ink=#f4f1e4"},
        {"sketch seed", "--set seed=2"},
        {"xray layers", "--set layers=2"},
    };
    const auto other = others.find(fmt::format("{} {}", style, p.name));
    return other != others.end() ? other->second : fmt::format("--set {}={}", p.name, telling_value(p));
}

std::string picture(std::string_view options, std::string_view name) {
    return fmt::format("![{}](pictures/styles/{}.png)", options, name);
}

std::string document() {
    std::string text =
        "# Styles\n\n"
        "Every style with its parameters, as `npr/` has them; `--style NAME` chooses one, `--set NAME=VALUE` sets a\n"
        "parameter, and the window's panel shows the same. `tools/styles` writes this file and draws its pictures, of\n"
        "`tools/styles.scad`; `tests/npr/styles_document_test` holds it to the program.\n";
    for (const npr::StyleInfo& style : npr::styles()) {
        const std::string options = fmt::format("--style {}", style.name);
        text += fmt::format("\n## {}\n{}{}.\n\n{}\n", style.name, style.label,
                            &style == &npr::styles().front() ? " (the default)" : "", picture(options, style.name));
        if (style.parameters.empty()) {
            text += "\nNo parameters.\n";
            continue;
        }
        text += "\n| parameter | | range | default | |\n| --- | --- | --- | --- | --- |\n";
        for (const Parameter& p : style.parameters) {
            const std::string settings = telling_settings(style.name, p);
            text +=
                fmt::format("| `{}` | {} | {} | {} | {} `{}` |\n", p.name, p.label, range(p), npr::text(p, p.initial),
                            picture(options + ' ' + settings, fmt::format("{}_{}", style.name, p.name)), settings);
        }
    }
    return text;
}

TEST(StylesDocument, IsOfThisProgram) {
    const std::string text = document();
    const fs::path file = kDocs / "STYLES.md";
    const char* update = std::getenv("CSGSCOPE_UPDATE_GOLDENS");
    if (update != nullptr && *update == '1') {
        base::write_file(file, text);
        return;
    }
    EXPECT_EQ(test_support::read_file(file), text) << "tools/styles writes it anew";
    for (const npr::StyleInfo& style : npr::styles()) {
        const auto drawn = [&](const std::string& name) {
            return base::read_png(kDocs / "pictures/styles" / (name + ".png")).width > 0;
        };
        EXPECT_TRUE(drawn(std::string(style.name)));
        for (const Parameter& p : style.parameters) {
            EXPECT_TRUE(drawn(fmt::format("{}_{}", style.name, p.name))) << p.name;
        }
    }
}

}  // namespace

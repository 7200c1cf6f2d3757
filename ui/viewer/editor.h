// The editor of those who have one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ui {

/// What runs `editor` ($VISUAL: a command, perhaps with options) with the file at a line and column, both from 1. Known
/// editors are told them in their own way, others as +LINE; those of a terminal get one.
[[nodiscard]] std::vector<std::string> editor_command(std::string_view editor, const std::string& path,
                                                      std::uint32_t line, std::uint32_t column);

/// Runs $VISUAL, else $EDITOR, and does not wait for it. Gives for people why it cannot; empty where it does.
[[nodiscard]] std::string open_editor(const std::string& path, std::uint32_t line, std::uint32_t column);

}  // namespace ui

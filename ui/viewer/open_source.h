// What can be opened in the window.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/viewer/revision.h"

namespace ui {

/// By its suffix: a program, or a mesh or drawing that programs can import.
[[nodiscard]] bool can_open(const std::filesystem::path& path);

/// The file, absolute, as `before` was evaluated; of a mesh or drawing the program that imports it. What was said of
/// the file before (definitions, sections, customized values) goes.
[[nodiscard]] Source opened(const std::filesystem::path& path, const Source& before);

struct FolderEntry {
    std::string name;
    bool folder = false;
    bool operator==(const FolderEntry&) const = default;
};
/// Folders and files that can_open() in it, folders first, by name; hidden ones are left out. Empty where the folder
/// cannot be read. At most 10,000.
[[nodiscard]] std::vector<FolderEntry> entries_of(const std::filesystem::path& folder);

}  // namespace ui

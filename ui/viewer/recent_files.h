// The files that were opened last, from one run to the next.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ui {

/// The list is kept where the desktop keeps such things; what cannot be read or written there is nobody's trouble.
class RecentFiles {
  public:
    static constexpr std::size_t kMost = 10;

    /// `file`: one path a line, the last first; need not be there. Empty: nothing is kept.
    explicit RecentFiles(std::filesystem::path file = state_file());

    /// To the front; what another run has added since stays.
    void add(const std::filesystem::path& opened);
    /// Those that are there still.
    [[nodiscard]] std::span<const std::string> paths() const { return paths_; }

    /// $XDG_STATE_HOME/csgscope/recent, by default below ~/.local/state; empty where there is no home.
    [[nodiscard]] static std::filesystem::path state_file();

  private:
    void read();

    std::filesystem::path file_;
    std::vector<std::string> paths_;
};

}  // namespace ui

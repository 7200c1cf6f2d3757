// The keys of the actions, as the user has them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/viewer/commands.h"

namespace ui {

class Keys {
  public:
    /// The first is shown in menus; none: it has none.
    [[nodiscard]] std::vector<Chord> of(Action action) const;
    /// "Ctrl+S", or nothing.
    [[nodiscard]] std::string first_text(Action action) const;
    /// The action of a key; none where it has none.
    [[nodiscard]] std::optional<Action> action_of(const Chord& chord) const;

    /// The action has these from now on; others that had one of them lose it.
    void set(Action action, std::vector<Chord> chords);
    /// As they are by default.
    void reset() { changed_.clear(); }

    /// Those that are not as by default.
    [[nodiscard]] const std::map<Action, std::vector<Chord>>& changed() const { return changed_; }

    bool operator==(const Keys&) const = default;

  private:
    std::map<Action, std::vector<Chord>> changed_;
};

/// "Ctrl+Shift+V" as text() writes it; nothing where it is no key.
[[nodiscard]] std::optional<Chord> chord_of(std::string_view text);

}  // namespace ui

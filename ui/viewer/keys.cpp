#include "ui/viewer/keys.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

std::vector<Chord> default_keys(Action action) {
    std::vector<Chord> chords;
    for (const ActionInfo& each : actions()) {
        for (const Chord& chord : each.keys) {
            if (each.action == action && chord.key != 0) {
                chords.push_back(chord);
            }
        }
    }
    return chords;
}

/// Takes it from the front of the text, if it is there.
bool take(std::string_view& text, std::string_view front) {
    const bool there = text.substr(0, front.size()) == front && text.size() > front.size();
    text.remove_prefix(there ? front.size() : 0);
    return there;
}

}  // namespace

std::vector<Chord> Keys::of(Action action) const {
    const auto found = changed_.find(action);
    return found != changed_.end() ? found->second : default_keys(action);
}

std::string Keys::first_text(Action action) const {
    const std::vector<Chord> chords = of(action);
    return chords.empty() ? "" : text(chords[0]);
}

std::optional<Action> Keys::action_of(const Chord& chord) const {
    for (const ActionInfo& each : actions()) {
        const std::vector<Chord> chords = of(each.action);
        if (std::find(chords.begin(), chords.end(), chord) != chords.end()) {
            return each.action;
        }
    }
    return std::nullopt;
}

void Keys::set(Action action, std::vector<Chord> chords) {
    for (const Chord& chord : chords) {
        if (const auto other = action_of(chord); other && *other != action) {
            std::vector<Chord> left = of(*other);
            std::erase(left, chord);
            changed_[*other] = std::move(left);
        }
    }
    if (chords == default_keys(action)) {
        changed_.erase(action);
    } else {
        changed_[action] = std::move(chords);
    }
}

std::optional<Chord> chord_of(std::string_view written) {
    Chord chord;
    std::string_view rest = written;
    for (bool more = true; more;) {
        more = false;
        for (const auto& [name, bit] : {std::pair("Ctrl+", GLFW_MOD_CONTROL), std::pair("Alt+", GLFW_MOD_ALT),
                                        std::pair("Super+", GLFW_MOD_SUPER), std::pair("Shift+", GLFW_MOD_SHIFT)}) {
            if (take(rest, name)) {
                chord.modifiers |= bit;
                more = true;
            }
        }
    }
    // Whatever has the same text is the same key; none is called '+' but '=' with Shift.
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
        for (const int modifiers : {chord.modifiers, chord.modifiers | GLFW_MOD_SHIFT}) {
            if (key != '+' && text({key, modifiers}) == written) {
                return Chord{key, modifiers};
            }
        }
    }
    return std::nullopt;
}

}  // namespace ui

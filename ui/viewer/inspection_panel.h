// Thickness, checks, measures and changes, in the place of the drawing panel.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ui/viewer/inspection.h"
#include "ui/viewer/session.h"
#include "ui/viewer/theme.h"

namespace ui {

/// What the tabs draw from.
struct InspectionView {
    const Session& session;
    const Inspection& inspection;
    const Fonts& fonts;
};

/// What is a part, as a list offers it.
struct PartChoice {
    int chosen = 0;

    /// `automatic`: text of the first entry, which leaves the choice to the caller.
    void draw(const char* automatic);
    [[nodiscard]] csg::PartRule rule(const csg::PartRule& automatic) const;
};

/// Walls and gaps in tones, with the thinnest places.
class ThicknessTab {
  public:
    void draw(const InspectionView& view, Commands& commands);

  private:
    bool fixed_ = false;  ///< The range is that …
    double range_ = 5;
};

/// What to look for, and what was found.
class ChecksTab {
  public:
    void draw(const InspectionView& view, Commands& commands);
    [[nodiscard]] CheckRequest request() const;
    [[nodiscard]] bool asks() const;  ///< For anything.

  private:
    struct Limit {
        bool on = false;
        double value = 0;
    };
    void limits();
    void clearances();
    void findings(const InspectionView& view, Commands& commands);

    Limit wall_{true, 0.8}, gap_{false, 0.3}, feature_{false, 0.8}, interference_{false, 0}, overhang_{false, 45},
        least_volume_{false, 0}, most_volume_{false, 1000};
    bool no_effect_ = true, coincident_ = true, sized_ = false;
    std::array<double, 3> size_{200, 200, 200};
    std::vector<Clearance> clearances_;
    PartChoice parts_;
    std::size_t clicked_ = ~std::size_t{0};
};

/// Volume, area, centroid, box and moments.
class MeasuresTab {
  public:
    void draw(const InspectionView& view, Commands& commands);

  private:
    PartChoice parts_;
    int precision_ = 0;
};

/// What has changed since.
class ChangesTab {
  public:
    void draw(const InspectionView& view, Commands& commands);

  private:
    std::string path_, error_;
    PartChoice parts_;
    std::shared_ptr<const csg::Tree> kept_;  ///< The state that was kept to compare with.
};

class InspectionPanel {
  public:
    void draw(const Rectangle& place, const InspectionView& view, Commands& commands);

  private:
    ThicknessTab thickness_;
    ChecksTab checks_;
    MeasuresTab measures_;
    ChangesTab changes_;
};

/// Over the picture: the thin places with their sizes and the legend of their tones, and what was clicked of findings.
void draw_inspected(const Rectangle& place, const InspectionView& view, float scale);

/// The volumes, areas, … as the panel shows them, line by line.
[[nodiscard]] std::string text_of(const MeasuresAnswer& answer);

// What the tabs have in common.

void ask(Commands& commands, InspectionCommand command);
/// A button that begins a task, or gives up the one that runs. True where it is to begin.
[[nodiscard]] bool task_button(const char* label, const char* task, const Inspection& inspection, Commands& commands);
/// Why there is no answer, or that it is of an older model.
void tell_state(const InspectionAnswer& answer, const Session& session);

}  // namespace ui

// What the model is made of, call by call: selects, hides, and shows one thing alone.
#pragma once

#include <set>
#include <string>

#include "ui/viewer/session.h"
#include "ui/viewer/theme.h"
#include "ui/viewer/tree_rows.h"

namespace ui {

/// Keeps what was typed and what is folded. To be drawn between ImGui::NewFrame and ImGui::Render.
class TreePanel {
  public:
    void draw(const Rectangle& place, const Session& session, const Fonts& fonts, Commands& commands);

  private:
    void renew(const Session& session);
    void row(const TreeRow& row, bool selected, Commands& commands);

    std::shared_ptr<const Model> model_;  ///< That the rows are of.
    std::vector<TreeRow> rows_;
    std::vector<std::size_t> shown_;  ///< Of these: not folded, and not filtered away.
    std::set<csg::OccurrenceId> folded_;
    std::string filter_;
    bool renews_ = false;                                 ///< shown_ is to be made anew.
    csg::OccurrenceId scrolled_to_ = csg::kNoOccurrence;  ///< The selected row that was brought into sight.
};

}  // namespace ui

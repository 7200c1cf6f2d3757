// Pictures whose parts are drawn in styles of their own.
#pragma once

#include "npr/part_notes.h"

namespace npr {

/// Paints pictures that have part_styles: what all styles note is put over each other by depth, and in `volume` the
/// media of all parts lie between.
class PartPainter {
  public:
    /// As Paint.
    void operator()(const CpuFrame& frame);

  private:
    PartNotes notes_;
};

}  // namespace npr

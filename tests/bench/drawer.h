// What draws a model in benchmarks: our engines, and OpenCSG.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/context.h"
#include "goldfeather/engine_set.h"
#include "layers/texture_stack.h"
#include "tests/opencsg/opencsg.h"
#include "ui/pipeline/model.h"

namespace bench {

/// One engine holding one model.
class Drawer {
  public:
    virtual ~Drawer() = default;
    /// What is not to be timed: to be called for each new view.
    virtual void prepare(const base::View& view) = 0;
    /// Draws the first `layers` surfaces (kAllLayers: all) and waits for them. The view is that prepared for, but for
    /// its jitter. Gives false where the engine has left the picture to another one.
    virtual bool draw(const base::View& view, int layers) = 0;
    /// How many surfaces each pixel of the last picture has, rows from bottom to top.
    [[nodiscard]] virtual std::vector<int> counts() = 0;
    /// The distance of the first one from the eye's plane; infinite where there is none.
    [[nodiscard]] virtual std::vector<double> distances() = 0;
};

/// What drawers share. Contexts and programs are made once.
class DrawerSet {
  public:
    /// `context` must outlive the set. `largest`: side of the largest picture, for OpenCSG.
    DrawerSet(gl::Context& context, int largest);

    /// "lists-cpu", "lists", "goldfeather", "scs", "OpenCSG Goldfeather", "OpenCSG SCS".
    [[nodiscard]] static const std::vector<std::string>& names();
    /// One of these names; null where the model is nothing for the engine: no sum of products, or one that takes it
    /// minutes. The model must outlive the drawer, and one drawer of OpenCSG the next.
    [[nodiscard]] std::unique_ptr<Drawer> make(const std::string& name, const ui::Model& model);
    /// Why OpenCSG is left out; empty where it is not.
    [[nodiscard]] const std::string& missing() const { return missing_; }

  private:
    gl::Context& context_;
    goldfeather::EngineSet engines_;
    std::unique_ptr<opencsg::OpenCsg> opencsg_;
    std::string missing_;
};

}  // namespace bench

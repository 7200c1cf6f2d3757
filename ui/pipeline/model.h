// A model made ready for drawing: everything between a CSG tree and the GPU.
#pragma once

#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"
#include "goldfeather/choice.h"
#include "goldfeather/products.h"
#include "npr/section.h"
#include "ui/pipeline/mesh/exact_operations.h"

namespace csg::scad {
class LoadedProgram;
}

namespace ui {

/// The model cannot be drawn as asked; the text begins with file:line:column where the place is known.
class ModelError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct ModelStatistics {
    std::size_t leaves = 0, parts = 0, triangles = 0, planes = 0;
    double products_unpruned = 0;  ///< What plain rewriting would give; saturates at 1e18.
    std::size_t products = 0, literals = 0, pruned_products = 0, pruned_literals = 0;
    double place_ms = 0, normalize_ms = 0;  ///< Wall time.
};

/// Immutable, without OpenGL; drawn by any number of renderers.
struct Model {
    std::shared_ptr<const csg::Tree> tree;
    std::shared_ptr<const csg::scad::LoadedProgram> program;  ///< Whose text made it; null where none did.
    csg::Scene scene;
    csg::solid::Geometry geometry;
    std::vector<std::vector<goldfeather::Product>> products;  ///< By part; an empty part has none.
    std::string over_budget;                                  ///< Why a part has no products; empty where all have.
    csg::Box box;                       ///< Encloses the solid; empty where nothing is to be seen.
    bool flat = false;                  ///< An outline in the plane, and nothing else (Showing::Result only).
    std::vector<std::string> warnings;  ///< With file:line where known.
    std::vector<std::string> failures;  ///< Objects that are left out or not whole; with file:line too.
    ModelStatistics statistics;
    std::uint64_t generation = 0;  ///< Counts the models of the process: which one a renderer holds.

    [[nodiscard]] bool empty() const { return box.empty(); }
};

/// Throws ModelError with all failures of the model, one a line, where it has any: nothing may be exported that is not
/// all of what was asked for.
void need_whole(const Model& model);

/// What the choice of an engine goes by. `layers`: wanted (0: all).
[[nodiscard]] goldfeather::EngineConditions engine_conditions(const Model& model, bool software_renderer, int layers);

/// Builds models; keeps the meshes of leaves from one to the next, so that an edit builds only what it changed.
class ModelBuilder {
  public:
    explicit ModelBuilder(goldfeather::Budget budget = {}) : budget_(budget) {}

    /// In previews outlines by themselves are slabs of thickness 1, as in OpenSCAD's; in results they are next to flat.
    void show(csg::Showing showing) { showing_ = showing; }

    /// What is a part of the models to come; the whole solid, unless something else is said.
    void divide(csg::PartRule parts) { parts_ = std::move(parts); }

    /// Cuts the models to come by parts of them, as far as sections say so; for what else they say see sections.h.
    void cut(npr::Sections sections) { sections_ = std::move(sections); }

    /// A part with more products than the budget allows is left to the engines that need none. Throws base::Stopped
    /// where `stop` asked for it.
    [[nodiscard]] std::shared_ptr<const Model> build(std::shared_ptr<const csg::Tree> tree,
                                                     const std::stop_token& stop = {},
                                                     std::shared_ptr<const csg::scad::LoadedProgram> program = {});

    /// A flat model (ui/pipeline/mesh/outline.h) as one region of the plane; its warnings and failures are those of the
    /// model. Throws ModelError where nothing is left of it, or its objects cannot be put together, base::Stopped
    /// where `stop` asked for it.
    [[nodiscard]] std::shared_ptr<const csg::solid::Outline> outline(const Model& model,
                                                                     const std::stop_token& stop = {});

    /// What the meshes kept from one model to the next take.
    [[nodiscard]] csg::solid::SolidCache::Size cache_size() const { return solids_.size(); }

  private:
    goldfeather::Budget budget_;
    csg::Showing showing_ = csg::Showing::Preview;
    csg::PartRule parts_;
    npr::Sections sections_;
    csg::solid::SolidCache solids_{exact_operations()};
};

}  // namespace ui

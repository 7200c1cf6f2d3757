// From where a place of a model is seen.
#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "ui/pipeline/model.h"

namespace ui {

/// Asks by rays, in double precision. For one thread at a time.
class SightFinder {
  public:
    explicit SightFinder(std::shared_ptr<const Model> model);
    ~SightFinder();
    SightFinder(const SightFinder&) = delete;
    SightFinder& operator=(const SightFinder&) = delete;

    /// A direction (of length 1) from the point, maybe on a face, to an eye that nothing of the model hides it from:
    /// `wish`, or of some around it the nearest to that; `wish` where there is none.
    [[nodiscard]] glm::dvec3 from(const glm::dvec3& point, const glm::dvec3& wish);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ui

// How much of each pixel a model covers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/camera.h"
#include "ui/pipeline/model.h"

namespace bench {

/// By kSide × kSide samples, each decided exactly (lists on the CPU, which the tests hold against the ray caster).
class ExactCoverage {
  public:
    static constexpr int kSide = 4096;
    ExactCoverage(const ui::Model& model, const base::Camera& camera);

    /// The share of the covered area by which a picture of side × side pixels differs, in percent; `side` divides
    /// kSide. `shown`: how much of each pixel is drawn, 0 to 1.
    [[nodiscard]] double error_percent(int side, std::span<const double> shown) const;
    /// The samples that differ, over those that the other covers, in percent.
    [[nodiscard]] double difference_percent(const ExactCoverage& other) const;

  private:
    std::vector<std::uint8_t> hits_;
};

}  // namespace bench

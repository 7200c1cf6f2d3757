// What a model is made of, part by part. Internal to ui/pipeline.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ui/pipeline/model.h"

namespace ui {

struct PartProducts {
    std::vector<goldfeather::Product> products;  ///< None for an empty part, nor for one over the budget.
    std::string over_budget;                     ///< Why there are none; empty where there are.
    csg::Box box;                                ///< Encloses the part.
};

/// `boxes`: of the leaves. What was done is added to `sum`.
[[nodiscard]] PartProducts products_of(const Model& model, const csg::Part& part, std::span<const csg::Box> boxes,
                                       const goldfeather::Budget& budget, ModelStatistics& sum);

/// For Model::generation.
[[nodiscard]] std::uint64_t next_generation();

}  // namespace ui

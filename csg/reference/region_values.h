// Which regions of a complex are solid, and whose the surfaces between them are.
#pragma once

#include <stop_token>
#include <vector>

#include "csg/reference/cell_complex.h"
#include "csg/reference/expression_value.h"

namespace csg::reference {

struct RegionValues {
    std::vector<char> solid;     ///< By region.
    std::vector<LeafId> owners;  ///< By cell; of those with the solid on one side only.
};

/// Goes through the regions from neighbor to neighbor; the winding numbers, and by them the expression, are changed
/// only by what each cell on the way tells. So it takes as long as there are cells, however many leaves, and memory for
/// the leaves and for the regions, not for one with the other. Throws Undecided where a cell does not lead from its one
/// region to the other, whichever way they were reached (told by sums of random weights of 64 bits), and base::Stopped.
[[nodiscard]] RegionValues evaluate_regions(const CellComplex& complex, const GroupExpression& expression,
                                            const InsideRule& rule, const std::stop_token& stop = {});

}  // namespace csg::reference

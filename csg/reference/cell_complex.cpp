#include "csg/reference/cell_complex.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/stop.h"
#include "csg/reference/disjoint_sets.h"

namespace csg::reference {
namespace {

class Builder {
  public:
    Builder(const ComplexSpace& space, const std::stop_token& stop) : space_(space), paced_(stop) {}

    CellComplex build(std::vector<PlaneCells> planes) {
        take_cells(std::move(planes));
        const std::vector<ComplexSide>& sides = complex_.sides;
        DisjointSets regions(2 * complex_.cells.size()), pieces(complex_.cells.size());
        for (std::size_t i = 0, j; i < sides.size(); i = j) {
            paced_();
            for (j = i + 1; j < sides.size() && sides[j].lo == sides[i].lo && sides[j].hi == sides[i].hi; ++j) {
                pieces.unite(sides[i].cell, sides[j].cell);
            }
            space_.sort_around(std::span(complex_.sides).subspan(i, j - i), complex_.cells);
            for (std::size_t k = i; k < j; ++k) {
                const ComplexSide &s = sides[k], &next = sides[k + 1 < j ? k + 1 : i];
                regions.unite(2 * s.cell + (s.left ? 0u : 1u), 2 * next.cell + (next.left ? 1u : 0u));
            }
        }
        number_regions(regions);
        find_pieces(pieces);
        return std::move(complex_);
    }

  private:
    void take_cells(std::vector<PlaneCells> planes) {
        for (std::uint32_t p = 0; p < planes.size(); ++p) {
            const auto first = static_cast<std::uint32_t>(complex_.cells.size());
            for (PlaneCells::Cell& cell : planes[p].cells) {
                complex_.cells.push_back({p, std::move(cell.covers), std::move(cell.triangles), 0, 0});
            }
            for (const PlaneCells::Side& s : planes[p].sides) {
                complex_.sides.push_back({s.lo, s.hi, first + s.cell, s.left});
            }
        }
        std::sort(complex_.sides.begin(), complex_.sides.end(), [](const ComplexSide& a, const ComplexSide& b) {
            return std::tie(a.lo, a.hi, a.cell, a.left) < std::tie(b.lo, b.hi, b.cell, b.left);
        });
    }

    void number_regions(DisjointSets& sides) {
        SetNumbers region(sides);
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            complex_.cells[c].above = region(2 * c);
            complex_.cells[c].below = region(2 * c + 1);
        }
        complex_.regions = region.count();
    }

    /// Where no ray from one of a piece's cells tells, others are asked.
    void find_pieces(DisjointSets& pieces) {
        constexpr int kMostCells = 16;
        std::vector<signed char> left(complex_.cells.size(), kMostCells);  // By what stands for the piece; 0: known.
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            paced_();
            signed char& tries = left[pieces.find(c)];
            if (tries == 0) {
                continue;
            }
            if (auto windings = space_.windings_above(complex_.cells[c])) {
                complex_.pieces.emplace_back(complex_.cells[c].above, std::move(*windings));
                tries = 0;
            } else if (--tries == 0) {
                throw_untold();
            }
        }
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            if (left[pieces.find(c)] != 0) {
                throw_untold();
            }
        }
    }

    [[noreturn]] static void throw_untold() { throw Undecided("no ray from a face tells what is in front of it"); }

    const ComplexSpace& space_;
    base::PacedStop paced_;
    CellComplex complex_;
};

}  // namespace

CellComplex make_complex(std::vector<PlaneCells> cells, const ComplexSpace& space, const std::stop_token& stop) {
    return Builder(space, stop).build(std::move(cells));
}

}  // namespace csg::reference

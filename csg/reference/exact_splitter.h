// Splits the segments of one plane where they cross, in exact arithmetic. For this library's own files.
#pragma once

#include <unordered_map>

#include "csg/reference/exact_segments.h"

namespace csg::reference {

class ExactSplitter {
  public:
    ExactSplitter(ExactSegments& segments, std::uint32_t plane);

    /// A sweep finds the segments that come near each other.
    void split(const std::stop_token& stop);

  private:
    struct Item {
        std::uint32_t segment, from, to;
        glm::dvec2 lo, hi;
    };

    /// The side of the line from → to that a point is on.
    int turn(std::uint32_t from, std::uint32_t to, std::uint32_t point);
    const ExactKernel::Point_2& picture(std::uint32_t point);
    void meet(const Item& s, const Item& t);
    [[nodiscard]] bool overlap(const Item& s, const Item& t);

    ExactSegments& segments_;
    std::uint32_t plane_;
    std::vector<Item> items_;
    std::unordered_map<std::uint32_t, ExactKernel::Point_2> pictures_;
};

}  // namespace csg::reference

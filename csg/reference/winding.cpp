#include "csg/reference/winding.h"

namespace csg::reference {
InsideRule::InsideRule(const LeafGroup& group) {
    even_odd_.reserve(group.leaves.size());
    for (const solid::PlacedLeaf* leaf : group.leaves) {
        even_odd_.push_back(!leaf->solid->closed);
    }
}

Covers InsideRule::sum(const Covers& a, const Covers& b, std::int32_t sign) const {
    Covers result;
    result.reserve(a.size() + b.size());
    for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        Cover c;
        if (j == b.size() || (i < a.size() && a[i].leaf < b[j].leaf)) {
            c = a[i++];
        } else if (i == a.size() || b[j].leaf < a[i].leaf) {
            c = {b[j].leaf, reduced(b[j].leaf, sign * b[j].count)};
            ++j;
        } else {
            c = {a[i].leaf, reduced(a[i].leaf, a[i].count + sign * b[j].count)};
            ++i, ++j;
        }
        if (c.count != 0) {
            result.push_back(c);
        }
    }
    return result;
}

}  // namespace csg::reference

// Which smooth surfaces of its leaf a plane belongs to: the table `group_words` (layers/surface_table.h). Valid in
// shaders and, within a struct with the same names, in C++.
//
// A word for each plane comes first. Where the plane is one leaf's and of one surface of it, as most are, that is the
// group: two bits for the stretch of a surface that comes back to itself in a corner, 22 for the surface among those of
// its leaf, 7 for its bend in half degrees. Else it tells where a list is: how many pairs there are, then these, of a
// leaf and a group, in order.

const uint kListOfGroups = 0x80000000u;

// The groups of a plane on a leaf: every other word from `first` on.
struct Groups {
    uint first;
    uint count;
};

Groups groups_of(uint plane, uint leaf) {
    Groups g;
    g.first = plane;
    g.count = 1u;
    uint word = group_words[plane];
    if ((word & kListOfGroups) == 0u)
        return g;
    uint list = word & ~kListOfGroups;
    uint count = group_words[list];
    uint low = 0u;
    uint high = count;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (group_words[list + 1u + 2u * middle] < leaf)
            low = middle + 1u;
        else
            high = middle;
    }
    g.first = list + 2u + 2u * low;
    g.count = 0u;
    while (low + g.count < count && group_words[list + 1u + 2u * (low + g.count)] == leaf)
        ++g.count;
    return g;
}

// Do two planes of a leaf belong to one surface, smooth where they meet?
bool one_surface(Groups a, Groups b) {
    uint i = 0u;
    uint j = 0u;
    while (i < a.count && j < b.count) {
        uint s = group_words[a.first + 2u * i] & 0xffffffu;
        uint t = group_words[b.first + 2u * j] & 0xffffffu;
        if (s >> 2 == t >> 2 && max(s, t) - min(s, t) <= 1u)
            return true;
        if (s < t)
            ++i;
        else
            ++j;
    }
    return false;
}

// Radians: how much the surface bends from this plane to the next of it, at most.
float bend_of(Groups g) {
    return g.count == 0u ? 0.0f : float(group_words[g.first] >> 24 & 127u) * (0.5f * 0.017453293f);
}

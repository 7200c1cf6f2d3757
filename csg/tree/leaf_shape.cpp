#include "csg/tree/leaf_shape.h"

#include "csg/tree/hash.h"

namespace csg {
namespace {

std::uint64_t mix(std::uint64_t seed, const glm::dvec3& v) {
    return csg::mix(csg::mix(csg::mix(seed, v.x), v.y), v.z);
}

std::uint64_t mix(std::uint64_t seed, const Fineness& f) {
    return csg::mix(csg::mix(csg::mix(seed, f.fn), f.fa), f.fs);
}

struct Hasher {
    std::uint64_t seed;

    std::uint64_t operator()(const Cube& c) const { return csg::mix(mix(seed, c.size), std::uint64_t{c.center}); }
    std::uint64_t operator()(const Sphere& s) const { return mix(csg::mix(seed, s.radius), s.fineness); }
    std::uint64_t operator()(const Cylinder& c) const {
        std::uint64_t h = csg::mix(csg::mix(csg::mix(seed, c.height), c.radius1), c.radius2);
        return mix(csg::mix(h, std::uint64_t{c.center}), c.fineness);
    }
    std::uint64_t operator()(const std::shared_ptr<const Polyhedron>& p) const {
        std::uint64_t h = csg::mix(seed, std::uint64_t{p->points.size()});
        for (const glm::dvec3& point : p->points)
            h = mix(h, point);
        for (const auto& face : p->faces) {
            h = csg::mix(h, std::uint64_t{face.size()});
            for (const std::uint32_t index : face)
                h = csg::mix(h, std::uint64_t{index});
        }
        return csg::mix(h, std::uint64_t{p->convexity});
    }
};

}  // namespace

std::uint64_t content_hash(const LeafShape& shape) {
    return std::visit(Hasher{csg::mix(std::uint64_t{0x1eaf}, std::uint64_t{shape.index()})}, shape);
}

}  // namespace csg

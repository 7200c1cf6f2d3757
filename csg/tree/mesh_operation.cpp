#include "csg/tree/mesh_operation.h"

#include "csg/tree/hash.h"

namespace csg {
namespace {

std::uint64_t mix(std::uint64_t seed, const std::optional<unsigned>& number) {
    return csg::mix(seed, number ? std::uint64_t{*number} + 1 : 0);
}

struct OperationHasher {
    std::uint64_t seed;

    std::uint64_t operator()(const LinearExtrude& e) const {
        std::uint64_t h = csg::mix(csg::mix(seed, e.height), e.direction);
        h = csg::mix(
            h, std::uint64_t{e.has_direction} | std::uint64_t{e.center} << 1 | std::uint64_t{e.twist.has_value()} << 2);
        h = csg::mix(csg::mix(h, e.twist.value_or(0)), e.scale.x);
        h = mix(mix(csg::mix(h, e.scale.y), e.slices), e.segments);
        return mix(csg::mix(h, std::uint64_t{e.convexity}), e.fineness);
    }
    std::uint64_t operator()(const RotateExtrude& e) const {
        return mix(csg::mix(csg::mix(csg::mix(seed, e.angle), e.start), std::uint64_t{e.convexity}), e.fineness);
    }
    std::uint64_t operator()(const Offset& o) const {
        return mix(csg::mix(csg::mix(seed, static_cast<std::uint64_t>(o.corner)), o.distance), o.fineness);
    }
    std::uint64_t operator()(const Fill&) const { return seed; }
    std::uint64_t operator()(const Projection& p) const {
        return csg::mix(seed, static_cast<std::uint64_t>(p.convexity) << 1 | std::uint64_t{p.cut});
    }
    std::uint64_t operator()(const Hull&) const { return seed; }
    std::uint64_t operator()(const Minkowski& m) const {
        return csg::mix(seed, static_cast<std::uint64_t>(m.convexity));
    }
    std::uint64_t operator()(const Resize& r) const {
        std::uint64_t h = csg::mix(seed, r.size);
        for (const bool automatic : r.automatic) {
            h = csg::mix(h, std::uint64_t{automatic});
        }
        return csg::mix(h, static_cast<std::uint64_t>(r.convexity));
    }
    std::uint64_t operator()(const Render& r) const { return csg::mix(seed, static_cast<std::uint64_t>(r.convexity)); }
    std::uint64_t operator()(const Roof& r) const {
        return mix(csg::mix(csg::mix(seed, std::string_view(r.method)), std::uint64_t{r.convexity}), r.fineness);
    }
};

}  // namespace

std::uint64_t content_hash(const MeshOperation& operation) {
    return std::visit(OperationHasher{csg::mix(std::uint64_t{0x3e54}, std::uint64_t{operation.index()})}, operation);
}

}  // namespace csg

// The leaves of a scene as meshes in the world, with canonical planes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "csg/solid/mesh_operations.h"
#include "csg/solid/plane_table.h"
#include "csg/solid/remarks.h"
#include "csg/solid/room.h"
#include "csg/solid/solid.h"
#include "csg/tree/dimension.h"
#include "csg/tree/scene.h"

namespace csg::solid {

/// One leaf occurrence in the world. A mirroring transform has turned the triangles around, so that they are again
/// counter-clockwise seen from outside.
struct PlacedLeaf {
    std::shared_ptr<const Solid> solid;
    std::vector<glm::dvec3> points;     ///< World coordinates.
    std::vector<glm::uvec3> triangles;  ///< Into `points`.
    std::vector<PlaneRef> planes;       ///< One per triangle.
    std::vector<FacetGroup> groups;     ///< The same, of a leaf that has been cut; else they are the solid's.
    Box box;                            ///< World coordinates; empty where the leaf has no volume.
    Plane face;                         ///< Outwards: that of the first triangles, better than their corners tell it.
    std::uint32_t face_triangles = 0;   ///< So many of them.
};

/// By triangle; empty where each plane is a surface of its own.
[[nodiscard]] std::span<const FacetGroup> groups_of(const PlacedLeaf& leaf);

/// All leaves of a scene, indexed by LeafId, and their planes.
struct Geometry {
    std::vector<PlacedLeaf> leaves;
    PlaneTable planes;
    Box box;                            ///< Of all leaves together.
    std::optional<glm::dvec3> center;   ///< Of what becomes floats; none: that of the box.
    double flat = 1;                    ///< Thickness of outlines.
    std::vector<std::string> warnings;  ///< With file:line where known.
    std::vector<std::string> failures;  ///< Objects that are left out or not whole; with file:line too.
};

struct NodeGeometry;
struct Tools;
class FontLibrary;

/// Keeps solids and the geometry of nodes by content hash, so that an edit rebuilds only what changed. For one thread
/// at a time. Throws OutOfMemory. What is given a `stop` throws base::Stopped soon after it is asked for; nothing half
/// made is kept then.
class SolidCache {
  public:
    /// Without `operations`, what needs booleans of meshes fails.
    explicit SolidCache(std::shared_ptr<const MeshOperations> operations = nullptr);
    ~SolidCache();
    SolidCache(const SolidCache&) = delete;
    SolidCache& operator=(const SolidCache&) = delete;

    /// Of a shape that is solid by itself: cube, sphere, cylinder, polyhedron.
    std::shared_ptr<const Solid> get(const LeafShape& shape, const std::stop_token& stop = {});
    /// Of any node; `by_node` are the dimensions of the tree's nodes. What there is to say about it and what is below
    /// it is appended, with file:line where known.
    std::shared_ptr<const Solid> get(const Tree& tree, NodeId node, const std::vector<Dimension>& by_node,
                                     Remarks& remarks, const std::stop_token& stop = {});
    /// The whole tree as one region of the plane; null where its first object is solid or there is none. Remarks as
    /// above.
    std::shared_ptr<const Outline> outline(const Tree& tree, Remarks& remarks, const std::stop_token& stop = {});
    /// Appends what there is to say of the outlines that a scene leaves out among solids, and of what is below them.
    void tell_left_out(const Tree& tree, const Scene& scene, const std::vector<Dimension>& by_node, Remarks& remarks,
                       const std::stop_token& stop = {});
    struct Size {
        std::size_t entries = 0, bytes = 0;  ///< Bytes of points and triangles.
    };
    [[nodiscard]] Size size() const;
    /// Forgets what was not asked for since the last trim.
    void trim();

  private:
    struct Entry;
    const NodeGeometry& geometry(const Tree& tree, NodeId node, const std::vector<Dimension>& by_node, Remarks& remarks,
                                 const std::stop_token& stop);
    [[nodiscard]] Tools tools(const std::stop_token& stop);

    std::shared_ptr<const MeshOperations> operations_;
    std::unique_ptr<FontLibrary> fonts_;
    std::unordered_map<std::uint64_t, Entry> entries_;
    std::uint32_t generation_ = 0;
};

/// Places every leaf. Transforms run in double precision; a matrix that is not finite or is projective makes the leaf
/// empty, and a failure, and so do coordinates beyond doubles; one with zero determinant makes it a leaf without
/// volume. A leaf thinner than what coordinates as large as the scene's can tell apart is a failure, too. Outlines are
/// slabs of thickness `flat` about their plane, whatever scales it. `room`: of the scene that this one was edited from.
/// Throws base::Stopped where `stop` asked for it.
[[nodiscard]] Geometry place(const Tree& tree, const Scene& scene, SolidCache& cache, double flat = 1,
                             const std::stop_token& stop = {}, const Room& room = {});

}  // namespace csg::solid

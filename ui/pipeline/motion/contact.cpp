#include "ui/pipeline/motion/contact.h"

#include <algorithm>
#include <memory>

#include "base/stop.h"
#include "csg/reference/boolean.h"
#include "csg/solid/placed.h"
#include "ui/pipeline/mesh/exact_operations.h"
#include "ui/pipeline/motion/approach.h"
#include "ui/pipeline/motion/rigid_mesh.h"

namespace ui {

namespace {

/// Meshes of bodies, and of what stands still, each from the tree in which it was first there.
class BodyMeshes {
  public:
    BodyMeshes(const Motion& motion, const std::stop_token& stop) : motion_(motion), stop_(stop) {}

    /// As it was first there, in the world.
    std::unique_ptr<const RigidMesh> of(const MovingBody& body) {
        return mesh(*body.tree,
                    [&](csg::LeafId leaf) { return std::binary_search(body.leaves.begin(), body.leaves.end(), leaf); });
    }
    /// Piece by piece, so that what a body rests on does not hide what else it comes to.
    std::vector<std::unique_ptr<const RigidMesh>> still() {
        std::vector<char> moves;
        for (const MovingBody& body : motion_.bodies) {
            if (body.tree == motion_.tree) {
                for (const csg::LeafId leaf : body.leaves) {
                    moves.resize(std::max(moves.size(), std::size_t{leaf} + 1), 0);
                    moves[leaf] = 1;
                }
            }
        }
        return mesh(*motion_.tree, [&](csg::LeafId leaf) { return leaf >= moves.size() || moves[leaf] == 0; })
            ->pieces();
    }

  private:
    /// The tree's solid, as if all leaves that are not meant were empty.
    template <typename Meant>
    std::unique_ptr<const RigidMesh> mesh(const csg::Tree& tree, const Meant& meant) {
        const csg::Scene scene = csg::make_scene(tree);
        csg::solid::Geometry geometry = csg::solid::place(tree, scene, solids_, 1, stop_);
        for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
            if (!meant(leaf)) {
                csg::solid::PlacedLeaf& placed = geometry.leaves[leaf];
                placed.points.clear();
                placed.triangles.clear();
                placed.planes.clear();
                placed.box = {};
            }
        }
        try {
            auto made = csg::reference::make_mesh(scene, geometry, {.method = {}, .threads = 1, .stop = stop_});
            return std::make_unique<const RigidMesh>(std::move(made.mesh.points), std::move(made.mesh.triangles));
        } catch (const std::runtime_error&) {
            // Without a closed mesh, by the surfaces of its leaves.
            std::vector<glm::dvec3> points;
            std::vector<glm::uvec3> triangles;
            for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
                for (const glm::uvec3& t : leaf.triangles) {
                    triangles.push_back(t + static_cast<unsigned>(points.size()));
                }
                points.insert(points.end(), leaf.points.begin(), leaf.points.end());
            }
            return std::make_unique<const RigidMesh>(std::move(points), std::move(triangles));
        }
    }

    const Motion& motion_;
    const std::stop_token& stop_;
    csg::solid::SolidCache solids_{exact_operations()};
};

}  // namespace

std::vector<Contact> contacts_of(const Motion& motion, const MovingBody& body,
                                 const std::function<bool(const std::string& name)>& meant, double from, double to,
                                 const std::stop_token& stop) {
    BodyMeshes meshes(motion, stop);
    std::vector<Contact> contacts;
    const auto own = meshes.of(body);
    const auto look = [&](const RigidMesh& other, const MovingBody* moving, const std::string& name) {
        if (own->empty() || other.empty()) {
            return;
        }
        for (const Touch& touch : Approach(motion, {*own, &body}, {other, moving}, stop).find(from, to)) {
            contacts.push_back({touch.time, touch.point, name});
        }
    };
    for (const MovingBody& other : motion.bodies) {
        if (&other != &body && meant(other.name)) {
            look(*meshes.of(other), &other, other.name);
        }
    }
    if (meant("")) {
        for (const auto& piece : meshes.still()) {
            look(*piece, nullptr, "");
        }
    }
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const Contact& a, const Contact& b) { return a.time < b.time; });
    return contacts;
}

}  // namespace ui

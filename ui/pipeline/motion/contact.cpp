#include "ui/pipeline/motion/contact.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/stop.h"
#include "csg/reference/boolean.h"
#include "csg/solid/placed.h"
#include "ui/pipeline/mesh/exact_operations.h"
#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/course.h"
#include "ui/pipeline/motion/rigid_mesh.h"
#include "ui/pipeline/motion/rigid_motion.h"

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

/// One of two: a body that moves, or what stands still.
struct ContactSide {
    const RigidMesh& mesh;
    const MovingBody* body = nullptr;

    [[nodiscard]] std::optional<glm::dmat4> at(const Motion& motion, double time) const {
        return body != nullptr ? Course(motion, *body).at(time) : glm::dmat4(1.0);
    }
    /// The highest speed of any of its points between two times of one interval: that of a corner of its box, since
    /// velocities are affine in place.
    [[nodiscard]] double speed(const Motion& motion, double from, double to) const {
        if (body == nullptr) {
            return 0;
        }
        const auto a = at(motion, from), b = at(motion, to);
        if (!a || !b) {
            return 0;
        }
        constexpr int kPieces = 8;
        double most = 0;
        for (const glm::dvec3& corner : corners_of(mesh.box())) {
            double length = 0;
            glm::dvec3 before(*a * glm::dvec4(corner, 1));
            for (int k = 1; k <= kPieces; ++k) {
                const glm::dvec3 next(between(*a, *b, double{1} * k / kPieces) * glm::dvec4(corner, 1));
                length += glm::distance(before, next);
                before = next;
            }
            most = std::max(most, length);
        }
        constexpr double kChords = 1.03;  // Arcs are longer than chords: of half a turn in eight by 0.6 %.
        return kChords * most / (to - from);
    }
};

class Approach {
  public:
    Approach(const Motion& motion, ContactSide a, ContactSide b, const std::stop_token& stop)
        : motion_(motion), a_(a), b_(b), stop_(stop) {
        // What the motion is off by between samples, of either.
        touching_ = 2 * motion.error + kRounding * std::max(1e-300, a.mesh.box().diagonal() + b.mesh.box().diagonal());
    }

    void find(double from, double to, std::vector<Contact>& out) {
        std::vector<double> times{from};
        for (const double t : motion_.times) {
            if (t > from && t < to) {
                times.push_back(t);
            }
        }
        times.push_back(to);
        bool apart = false;  // Before the first time nothing is known.
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            const double begin = times[i], end = times[i + 1];
            const auto first = near(begin);
            if (!first) {
                apart = true;  // What is not there touches nothing.
                continue;
            }
            if (first->distance > touching_) {
                apart = true;
            }
            if (apart) {
                apart = !advance(begin, end, out);
            }
        }
    }

  private:
    static constexpr double kRounding = 1e-9;

    [[nodiscard]] std::optional<RigidMesh::Near> near(double time) const {
        base::end_if_asked(stop_);
        const auto a = a_.at(motion_, time), b = b_.at(motion_, time);
        return a && b ? std::optional(RigidMesh::nearest(a_.mesh, *a, b_.mesh, *b)) : std::nullopt;
    }

    /// From where they are apart on to where they are not any more; false where that is not before the end.
    bool advance(double begin, double end, std::vector<Contact>& out) const {
        const double speed = a_.speed(motion_, begin, end) + b_.speed(motion_, begin, end);
        if (!(speed > 0)) {
            return false;
        }
        std::optional<Contact> best;
        double least = touching_;
        constexpr int kMostSteps = 1000;
        double time = begin;
        for (int step = 0; step < kMostSteps && time < end; ++step) {
            const auto here = near(time);
            if (!here || (best && here->distance > least)) {
                break;  // They have touched, and part again.
            }
            if (here->distance <= least) {
                least = here->distance;
                best = Contact{time, 0.5 * (here->a + here->b), ""};
            }
            const double longest = here->distance / speed;
            if (best && longest < kRounding * (end - begin)) {
                break;
            }
            time += std::max(longest, kRounding * (end - begin));
        }
        if (best) {
            out.push_back(*best);
        }
        return best.has_value();
    }

    const Motion& motion_;
    ContactSide a_, b_;
    const std::stop_token& stop_;
    double touching_ = 0;
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
        std::vector<Contact> found;
        Approach(motion, {*own, &body}, {other, moving}, stop).find(from, to, found);
        for (Contact& contact : found) {
            contact.with = name;
            contacts.push_back(contact);
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

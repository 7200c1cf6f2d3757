// What of a model moves while $t runs, and how: the assembled information about dynamics of Nienhaus 2005, section 7.4,
// from nothing but the program.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "csg/tree/box.h"
#include "csg/tree/scene.h"
#include "csg/tree/tree.h"

namespace ui {

/// The tree at a time; null where there is none, which ends the search.
using TreeAtTime = std::function<std::shared_ptr<const csg::Tree>(double time)>;

struct MotionRequest {
    double from = 0, to = 1;  ///< Of $t; from < to.
    /// World units: what lies between two samples is told by the screw between them to within this. Absent: 1e-4 of the
    /// model's diagonal.
    std::optional<double> error;
    std::size_t most_samples = 4096;
    bool derivatives = true;  ///< Velocities and accelerations too: four more runs for each sample.
};

/// How a body is at a sample, against where it was when it was first there.
struct Pose {
    glm::dmat4 motion{1.0};
    glm::dvec3 center{0.0};  ///< Of its box, moved along.
    /// Per unit of $t; absent where it is not asked for, or there is a jump within four steps of a 1/1024 of the time.
    std::optional<glm::dvec3> velocity, acceleration, turning;  ///< `turning`: the axis, as long as radians per unit.
};

/// Something that does not come to be step by step.
struct MotionEvent {
    enum class Kind { Jumps, Appears, Vanishes };
    Kind kind = Kind::Jumps;
    double after = 0, before = 0;  ///< It happens between these times.
    double distance = 0;           ///< World units: how far a jump moves what it moves most.
};

/// A subtree that moves as one.
struct MovingBody {
    std::string name;           ///< Of the module it is made by, or of its shape; no two have the same.
    csg::SourceLocation where;  ///< Of the call that it is moved as a whole by; `file` is of Motion::tree.
    csg::Box box;               ///< World units; when it was first there.
    /// The tree in which it was first there, its topmost node, and what led that node's coordinates to the world.
    std::shared_ptr<const csg::Tree> tree;
    csg::NodeId top = csg::kNoNode;
    glm::dmat4 to_world{1.0};
    std::vector<csg::LeafId> leaves;   ///< Its own, in the scene of `tree`, increasing.
    csg::Rgba color;                   ///< Of its first leaf.
    std::vector<glm::dvec3> extremes;  ///< Its points that reach farthest along many directions; world units, then.
    std::vector<std::optional<Pose>> poses;  ///< By sample; none where it is not there.
    std::vector<MotionEvent> events;         ///< By time.
    bool changes_shape = false;              ///< Besides, or instead of, moving.
};

struct Motion {
    std::shared_ptr<const csg::Tree> tree;  ///< That of the first time.
    std::vector<double> times;              ///< Of the samples, increasing.
    std::vector<MovingBody> bodies;         ///< In the order of the text's run.
    std::size_t leaves = 0, still = 0;      ///< All that were ever there; those that never moved.
    double error = 0;                       ///< World units: the largest found between samples.
    bool complete = true;                   ///< Else more samples were needed than allowed.
};

/// Samples where the motion wants them: an interval is halved, not in the middle, until the screw between its ends
/// tells where everything is within. Throws std::runtime_error where there is no tree at a time, base::Stopped where it
/// was asked for.
[[nodiscard]] Motion find_motion(const TreeAtTime& tree_at, const MotionRequest& request,
                                 const std::stop_token& stop = {});

}  // namespace ui

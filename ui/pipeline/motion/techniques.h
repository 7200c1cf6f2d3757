// The depiction techniques, each from what a body does to glyphs in the scene. Internal to the depictions.
#pragma once

#include <vector>

#include "csg/tree/additions.h"
#include "csg/tree/leaf_shape.h"
#include "ui/pipeline/motion/course.h"
#include "ui/pipeline/motion/depiction.h"

namespace ui {

/// Where they put them.
struct DepictionStage {
    const DepictionSource& source;
    double size = 0;  ///< World units: how far what moves reaches.
    /// Per unit of $t: how the bodies of one depiction go together; 0 of one alone.
    glm::dvec3 onward{0.0};
    std::vector<csg::Addition> additions;
    std::vector<BubbleRequest> bubbles;
    std::vector<FrameRequest> frames;
    std::vector<GlyphStyle> styles;

    void add(csg::Polyhedron mesh, const csg::Rgba& color);
};

/// What one depiction says of one body.
struct DepictionTask {
    const Depiction& what;
    double from = 0, to = 1;  ///< Of $t.
    double radius = 1;        ///< World units, of arrows and lines.
};

inline constexpr csg::Rgba kGlyphColor{0.85F, 0.2F, 0.15F, 1};
/// Of the size: how near points of curves are to each other.
inline constexpr double kCurveStep = 0.01;

// Each throws std::runtime_error where the body does not do what the technique shows.
void draw_path(DepictionStage& stage, const DepictionTask& task, const Course& course);
void draw_trails(DepictionStage& stage, const DepictionTask& task, const Course& course);
/// `several`: ghosts; else one at the end.
void draw_images(DepictionStage& stage, const DepictionTask& task, const Course& course, bool several);
void draw_rotation(DepictionStage& stage, const DepictionTask& task, const MovingBody& body);
void draw_collisions(DepictionStage& stage, const DepictionTask& task, const MovingBody& body,
                     const std::stop_token& stop);
void draw_frame(DepictionStage& stage, const DepictionTask& task, const Course& course);
void draw_speech(DepictionStage& stage, const DepictionTask& task, const Course& course);
/// Of the program's camera; there is no body.
void draw_camera(DepictionStage& stage, const DepictionTask& task);

/// A direction across another, of length 1.
[[nodiscard]] glm::dvec3 perpendicular(const glm::dvec3& direction);
/// A tube of one radius.
[[nodiscard]] csg::Polyhedron plain_tube(std::span<const glm::dvec3> curve, double radius);

}  // namespace ui

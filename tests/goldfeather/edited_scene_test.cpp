// Scenes that are edited beside such as are made from nothing, by every engine.
#include "csg/solid/editable_scene.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <optional>

#include "goldfeather/engine_set.h"
#include "layers/texture_stack.h"
#include "tests/goldfeather/edited_scene.h"
#include "tests/random/build_model.h"
#include "tests/support/gl_test.h"

namespace {

using csg::ExpressionKind;
using csg::solid::EditableScene;
using edited_scene::difference;
using edited_scene::kUnused;
using edited_scene::numbers_of_planes;
using edited_scene::occurrence_at;
using edited_scene::Path;
using edited_scene::Subject;
using random_tree::Model;

constexpr glm::ivec2 kSize{40, 40};

/// A leaf that is put to the node at a path of a model.
struct Addition {
    Path path;
    ExpressionKind operation;
    csg::LeafShape shape;
    glm::dmat4 matrix;
    csg::solid::AddedId id = 0;
};

csg::Operation operation_of(ExpressionKind kind) {
    return kind == ExpressionKind::Union          ? csg::Operation::Union
           : kind == ExpressionKind::Intersection ? csg::Operation::Intersection
                                                  : csg::Operation::Difference;
}

Model* node_at(Model& model, const Path& path) {
    Model* at = &model;
    for (const std::uint32_t child : path) {
        at = &at->children[child];
    }
    return at;
}

void collect(Model& model, Path& path, std::vector<Path>& nodes, std::vector<Path>& leaves) {
    nodes.push_back(path);
    if (model.operation == csg::Operation::Leaf) {
        leaves.push_back(path);
    }
    for (std::uint32_t i = 0; i < model.children.size(); ++i) {
        path.push_back(i);
        collect(model.children[i], path, nodes, leaves);
        path.pop_back();
    }
}

/// Every leaf below a transformation of its own.
Model loosened(Model model) {
    if (model.operation == csg::Operation::Leaf) {
        return random_tree::matrix(glm::dmat4(1.0), std::move(model));
    }
    for (Model& child : model.children) {
        child = loosened(std::move(child));
    }
    return model;
}

/// The model with everything that was added; what was added deeper first.
Model with(const Model& model, std::span<const Addition> additions) {
    Model result = model;
    std::vector<const Addition*> order;
    for (const Addition& a : additions) {
        order.push_back(&a);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const Addition* a, const Addition* b) { return a->path.size() > b->path.size(); });
    for (const Addition* a : order) {
        Model* const at = node_at(result, a->path);
        Model first = std::move(*at);
        *at = random_tree::combine(operation_of(a->operation),
                                   {std::move(first), random_tree::matrix(a->matrix, random_tree::leaf(a->shape))});
    }
    return result;
}

class Edits {
  public:
    Edits(std::uint64_t seed, bool modifiers) : random_(seed) {
        random_tree::Options options;
        options.modifiers = modifiers;
        options.wound = seed % 3 == 0;
        options.most_leaves = seed % 2 == 0 ? 40 : 14;
        model_ = loosened(random_tree::make_model(random_, options));
        Path path;
        collect(model_, path, nodes_, leaves_);
    }
    [[nodiscard]] int pick(std::size_t n) { return static_cast<int>(random_() % n); }

    [[nodiscard]] glm::dmat4 matrix() {
        const double off = pick(3) == 0 ? 0.1 : 0;  // Coplanar with nothing, mostly.
        const auto grid = [&] { return static_cast<double>(pick(5) - 2) + off; };
        const glm::dmat4 shift = glm::translate(glm::dmat4(1.0), {grid(), grid(), grid()});
        switch (pick(12)) {
            case 0:
                return glm::rotate(shift, 0.1 * grid(), glm::dvec3(1, 2, 3));
            case 1:
                return glm::rotate(shift, glm::radians(90.0), glm::dvec3(0, 0, 1));
            case 2:
                return glm::scale(shift, glm::dvec3(1, -1, 1));
            case 3:
                return glm::scale(shift, glm::dvec3(1, 0, 1));
            case 4:
                return glm::scale(shift, glm::dvec3(pick(4) == 0 ? 1e5 : 7));
            case 5:
                return glm::dmat4(1.0);
            default:
                return shift;
        }
    }
    [[nodiscard]] csg::LeafShape shape() {
        if (pick(2) == 0) {
            return csg::Cube{{1.0 + pick(4), 1.0 + pick(4), 1.0 + pick(4)}, pick(2) == 0};
        }
        return csg::Sphere{1.0 + pick(3), {}};
    }

    /// Changes the model, and tells the scene so.
    void step(EditableScene& scene, csg::solid::SolidCache& cache, bool structure) {
        const int kind = structure ? pick(6) : 5;
        if (kind == 0) {
            add(scene, cache);
        } else if (kind == 1 && !additions_.empty()) {
            const auto gone = additions_.begin() + pick(additions_.size());
            scene.remove(gone->id);
            additions_.erase(gone);
        } else {
            for (int moves = 1 + pick(2); moves > 0; --moves) {
                move();
            }
        }
        // Where all leaves are now, as the tree says it.
        const csg::Scene now = csg::make_scene(random_tree::make_tree(result()));
        for (csg::LeafId leaf = 0; leaf < now.leaves.size(); ++leaf) {
            scene.move(leaf, now.leaves[leaf].to_world);
        }
    }
    [[nodiscard]] Model result() const { return with(model_, additions_); }
    [[nodiscard]] const Model& model() const { return model_; }
    std::mt19937_64& random() { return random_; }

  private:
    void add(EditableScene& scene, csg::solid::SolidCache& cache) {
        Addition a{nodes_[static_cast<std::size_t>(pick(nodes_.size()))], static_cast<ExpressionKind>(1 + pick(3)),
                   shape(), matrix()};
        csg::Site site{0, occurrence_at(scene.scene(), a.path)};
        if (site.occurrence == csg::kNoOccurrence || csg::expression_at(scene.scene(), site) == csg::kNoExpression) {
            return;
        }
        a.id = scene.add(site, a.operation, cache.get(a.shape), a.matrix);
        additions_.push_back(a);
    }
    void move() {
        const auto leaf = static_cast<std::size_t>(pick(leaves_.size() + additions_.size()));
        if (leaf < leaves_.size()) {
            Path path = leaves_[leaf];
            path.pop_back();
            node_at(model_, path)->matrix = matrix();
        } else {
            additions_[leaf - leaves_.size()].matrix = matrix();
        }
    }

    std::mt19937_64 random_;
    Model model_;
    std::vector<Path> nodes_, leaves_;
    std::vector<Addition> additions_;
};

class EditedScenes : public testing::TestWithParam<const goldfeather::EngineInfo*> {
  protected:
    void SetUp() override {
        if (info().capabilities.needs_opengl) {
            auto made = test_support::try_context(gl::ContextKind::Egl);
            if (!made.context) {
                test_support::skip_or_fail("no OpenGL: " + made.reason);
                return;
            }
            context_ = std::move(made.context);
        }
        engines_.emplace(goldfeather::EngineSettings{.gl = context_ ? &context_->functions() : nullptr, .threads = 2});
    }
    [[nodiscard]] static const goldfeather::EngineInfo& info() { return *GetParam(); }
    [[nodiscard]] std::unique_ptr<goldfeather::PreparedScene> prepare(const Subject& subject) {
        return engines_->prepare(subject.input(), info());
    }
    void update(std::unique_ptr<goldfeather::PreparedScene>& prepared, const Subject& subject,
                const csg::solid::SceneChange& change) {
        if (!prepared->update(change)) {
            prepared = prepare(subject);
        }
    }
    [[nodiscard]] std::shared_ptr<const layers::HostStack> draw(goldfeather::PreparedScene& prepared,
                                                                const base::View& view) {
        goldfeather::WalkStats ignored;
        const layers::Stack stack = prepared.draw(view, info().capabilities.most_layers == 1 ? 1 : 0, ignored);
        // A copy: the memory of a stack is used again.
        return stack.host ? std::make_shared<layers::HostStack>(*stack.host)
                          : layers::in_main_memory(context_->functions(), stack);
    }
    [[nodiscard]] base::View view_of(const Subject& subject, const base::Camera& camera) const {
        return {camera, kSize, subject.geometry.box.lo, subject.geometry.box.hi};
    }

    csg::solid::SolidCache cache_;
    std::unique_ptr<gl::Context> context_;
    std::optional<goldfeather::EngineSet> engines_;
};

TEST_P(EditedScenes, AreAsIfMadeFromNothing) {
    const bool slow = info().capabilities.needs_opengl;
    std::size_t kept = 0, all = 0, surfaces = 0;
    for (std::uint64_t seed = 1; seed <= (slow ? 25 : 150); ++seed) {
        const bool structure = seed % 4 != 0;
        Edits edits(seed, !structure);
        Subject edited(edits.model(), cache_);
        if (edited.scene.parts.empty()) {
            continue;
        }
        EditableScene scene(edited.scene, edited.geometry);
        auto prepared = prepare(edited);
        for (int step = 0; step < (slow ? 6 : 12); ++step) {
            edits.step(scene, cache_, structure);
            const csg::solid::SceneChange change = scene.commit();
            kept += change.all_planes ? 0 : 1;
            ++all;
            edited.normalize();
            update(prepared, edited, change);

            const Subject made(edits.result(), cache_, scene.room());
            const std::string where = fmt::format("seed {}, step {}\n{}", seed, step, scad_text(edits.result()));
            ASSERT_EQ(difference(edited.scene, made.scene), "") << where;
            ASSERT_EQ(difference(edited.geometry, made.geometry), "") << where;
            if (made.geometry.box.empty()) {
                continue;
            }
            const base::Camera camera =
                random_tree::make_camera(edits.random(), made.geometry.box.lo, made.geometry.box.hi);
            const base::View view = view_of(made, camera);
            const auto drawn = draw(*prepared, view);
            const auto fresh = prepare(made);
            const auto found = drawn->surfaces();
            surfaces += static_cast<std::size_t>(
                std::count_if(found.begin(), found.end(), [](const layers::Surface& s) { return s.depth > 0; }));
            ASSERT_EQ(difference(edited.geometry, *drawn, *draw(*fresh, view)), "") << where;
        }
    }
    EXPECT_GT(kept, all / 5) << "planes are often kept";
    EXPECT_GT(surfaces, 100 * all);
}

/// Two boxes beside each other, each a part, and one behind, shown as background.
Model three_parts() {
    Model behind = random_tree::box({0, 8, 0}, {9, 2, 4});
    behind.modifiers.background = true;
    return random_tree::combine(
        csg::Operation::Union,
        {random_tree::combine(csg::Operation::Difference,
                              {random_tree::box({0, 0, 0}, {4, 4, 4}), random_tree::box({1, 1, -1}, {2, 2, 6})}),
         behind});
}

base::Camera from_the_side(const Subject& subject) {
    base::Camera camera = base::camera_between({30, -40, 50}, {3, 2, 1});
    base::view_all(camera, subject.geometry.box.lo, subject.geometry.box.hi, true);
    return camera;
}

TEST_P(EditedScenes, AreSectionedPartByPart) {
    for (const csg::solid::Plane& plane :
         {csg::solid::Plane{{0, 0, 1}, 2}, csg::solid::Plane{{0, 0, 1}, 0}, csg::solid::Plane{{0.6, 0, 0.8}, 2.5}}) {
        Subject edited(three_parts(), cache_);
        ASSERT_EQ(edited.scene.parts.size(), 2U);
        EditableScene scene(edited.scene, edited.geometry);
        auto prepared = prepare(edited);
        const base::Camera camera = from_the_side(edited);
        const csg::solid::Geometry before = edited.geometry;
        const auto whole = draw(*prepared, view_of(edited, camera));

        // Elsewhere first: a section is dragged to its place.
        std::vector<csg::solid::AddedId> sections;
        for (csg::PartId part = 0; part < 2; ++part) {
            sections.push_back(
                scene.add({part}, ExpressionKind::Intersection, csg::solid::Plane{{0, 0, 1}, 3.3}, {1, 0, 0, 1}));
        }
        csg::solid::SceneChange change = scene.commit();
        edited.normalize();
        update(prepared, edited, change);
        for (const csg::solid::AddedId section : sections) {
            scene.move(section, plane);
        }
        change = scene.commit();
        EXPECT_FALSE(change.structure);
        EXPECT_EQ(change.leaves.size(), 2U) << "nothing but the sections";
        edited.normalize();
        update(prepared, edited, change);

        const base::View view = view_of(edited, camera);
        const auto cut = draw(*prepared, view);
        bool face = false;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const layers::Surface s = cut->at(0, x, y);
                if (s.depth == 0) {
                    continue;
                }
                const base::View::Ray ray = view.ray(x, y);
                const glm::dvec3 p = ray.origin + view.distance(s.depth) * ray.direction;
                ASSERT_LT(glm::dot(plane.normal, p), plane.offset + 1e-3) << "what is beyond is gone";
                const csg::solid::Plane& own = edited.geometry.planes.planes()[s.plane];
                face = face || own == plane || own == csg::solid::Plane{-plane.normal, -plane.offset};
            }
        }
        EXPECT_EQ(face, plane.offset > 0) << "the cut has exactly that plane";

        for (const csg::solid::AddedId section : sections) {
            scene.remove(section);
        }
        change = scene.commit();
        edited.normalize();
        update(prepared, edited, change);
        EXPECT_EQ(difference(edited.geometry, before), "");
        EXPECT_EQ(difference(edited.geometry, *draw(*prepared, view_of(edited, camera)), *whole), "");
    }
}

TEST_P(EditedScenes, DoNotShowWhatIsHidden) {
    Subject edited(three_parts(), cache_);
    EditableScene scene(edited.scene, edited.geometry);
    auto prepared = prepare(edited);
    const base::View view = view_of(edited, from_the_side(edited));
    const auto whole = draw(*prepared, view);
    for (csg::PartId part = 0; part < 2; ++part) {
        scene.show(part, false);
        csg::solid::SceneChange change = scene.commit();
        EXPECT_EQ(change.parts, std::vector<csg::PartId>{part});
        update(prepared, edited, change);
        const auto rest = draw(*prepared, view);
        std::size_t left = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const layers::Surface s = rest->at(0, x, y), w = whole->at(0, x, y);
                left += s.depth > 0 ? 1U : 0U;
                ASSERT_TRUE(s.depth == 0 || edited.scene.leaves[s.leaf].part != part);
                if (w.depth > 0 && edited.scene.leaves[w.leaf].part != part) {
                    ASSERT_EQ(s, w) << "what was in front stays as it was";
                }
            }
        }
        EXPECT_GT(left, 10U);
        scene.show(part, true);
        update(prepared, edited, scene.commit());
        EXPECT_EQ(difference(edited.geometry, *draw(*prepared, view), *whole), "");
    }
    scene.show(0, false);
    scene.show(1, false);
    update(prepared, edited, scene.commit());
    const auto nothing = draw(*prepared, view);
    for (const layers::Surface& s : nothing->surfaces()) {
        ASSERT_EQ(s.depth, 0);
    }
}

/// A plate with holes in a row, two apart.
Model row_of_holes(int count) {
    std::vector<Model> all{random_tree::box({0, 0, 0}, {2.0 * count, 2, 1})};
    for (int i = 0; i < count; ++i) {
        all.push_back(
            loosened(random_tree::at({2 * i + 0.5, 0.5, -1}, random_tree::leaf(csg::Cube{{1, 1, 3}, false}))));
    }
    return random_tree::combine(csg::Operation::Difference, all);
}

TEST(EditableScenes, MergePlanesWhereALeafComesToLieInThoseOfAnother) {
    csg::solid::SolidCache cache;
    Subject edited(row_of_holes(12), cache);
    EditableScene scene(edited.scene, edited.geometry);
    const auto plane_of = [&](csg::LeafId leaf) {  // That of its first triangle across y.
        for (const csg::solid::PlaneRef& plane : edited.geometry.leaves[leaf].planes) {
            if (std::abs(edited.geometry.planes.planes()[plane.index].normal.y) > 0.5) {
                return plane.index;
            }
        }
        return kUnused;
    };
    const auto in_use = [&] {
        const std::vector<std::uint32_t> numbers = numbers_of_planes(edited.geometry);
        return numbers.size() - static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), kUnused));
    };
    const std::size_t together = in_use();
    const glm::dmat4 rest = edited.scene.leaves[7].to_world;
    ASSERT_EQ(plane_of(7), plane_of(8));
    scene.move(7, glm::translate(rest, {0.01, 0.02, 0.03}));
    csg::solid::SceneChange change = scene.commit();
    EXPECT_EQ(change.leaves, std::vector<csg::LeafId>{7});
    EXPECT_NE(plane_of(7), plane_of(8));
    EXPECT_EQ(in_use(), together + 4);
    scene.move(7, rest);
    (void)scene.commit();
    EXPECT_EQ(plane_of(7), plane_of(8));
    EXPECT_EQ(in_use(), together);
}

TEST(EditableScenes, ChangeNothingElseAndDoNotGrow) {
    csg::solid::SolidCache cache;
    Subject edited(row_of_holes(60), cache);
    EditableScene scene(edited.scene, edited.geometry);
    const glm::dmat4 rest = edited.scene.leaves[30].to_world;
    std::size_t renumbered = 0, most = 0;
    const std::size_t planes = edited.geometry.planes.planes().size();
    for (int i = 0; i < 10000; ++i) {
        scene.move(30, glm::rotate(glm::translate(rest, {0.3 * std::sin(0.1 * i), 0.001 * i, 0.01}), 0.01 * i,
                                   glm::dvec3(0, 0, 1)));
        const csg::solid::SceneChange change = scene.commit();
        ASSERT_EQ(change.leaves, std::vector<csg::LeafId>{30});
        ASSERT_LE(change.planes.size(), 6U);
        renumbered += change.all_planes ? 1 : 0;
        most = std::max(most, edited.geometry.planes.planes().size());
    }
    EXPECT_LE(renumbered, 10U);
    EXPECT_LE(most, planes + 50);
    scene.move(30, rest);
    (void)scene.commit();
    const Subject made(row_of_holes(60), cache, scene.room());
    EXPECT_EQ(difference(edited.geometry, made.geometry), "");
}

TEST(EditableScenes, MovePartsFromWhereTheTextPutThem) {
    csg::solid::SolidCache cache;
    Subject edited(three_parts(), cache);
    EditableScene scene(edited.scene, edited.geometry);
    const csg::solid::AddedId section = scene.add({0}, ExpressionKind::Intersection, csg::solid::Plane{{0, 0, 1}, 3});
    const glm::dmat4 up = glm::translate(glm::dmat4(1.0), {0, 0, 5});
    for (int i = 0; i < 3; ++i) {
        scene.move_part(0, up);
    }
    (void)scene.commit();
    EXPECT_EQ(edited.geometry.leaves[0].box, (csg::Box{{0, 0, 5}, {4, 4, 9}}));
    EXPECT_EQ(edited.geometry.leaves[scene.leaf(section)].face.offset, 8) << "a section goes with its part";
    scene.move_part(0, glm::dmat4(1.0));
    scene.remove(section);
    (void)scene.commit();
    const Subject made(three_parts(), cache, scene.room());
    EXPECT_EQ(difference(edited.geometry, made.geometry), "");
    // By an occurrence: the first child of the difference, which is that of the union.
    scene.move_occurrence(occurrence_at(edited.scene, {0, 1}), up);
    (void)scene.commit();
    EXPECT_EQ(edited.geometry.leaves[0].box, made.geometry.leaves[0].box);
    EXPECT_EQ(edited.geometry.leaves[1].box.lo.z, 4);
}

TEST(EditableScenes, TellWhatCannotBePlaced) {
    csg::solid::SolidCache cache;
    Subject edited(row_of_holes(3), cache);
    EditableScene scene(edited.scene, edited.geometry);
    scene.move(2, glm::dmat4(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(scene.commit().failures.size(), 1U);
    EXPECT_TRUE(edited.geometry.leaves[2].triangles.empty());
    EXPECT_TRUE(scene.commit().empty()) << "nothing has changed since";
}

std::vector<const goldfeather::EngineInfo*> all_engines() {
    std::vector<const goldfeather::EngineInfo*> all;
    for (const goldfeather::EngineInfo& info : goldfeather::engines()) {
        all.push_back(&info);
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(, EditedScenes, testing::ValuesIn(all_engines()), [](const auto& info) {
    std::string name(info.param->name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace

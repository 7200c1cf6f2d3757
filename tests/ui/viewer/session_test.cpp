// The session follows its file: newer text stops older evaluations, errors keep the model, the camera stays.
#include "ui/viewer/session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stop_token>
#include <thread>

#include "tests/support/temporary_folder.h"
#include "tests/ui/viewer/small_model.h"

namespace ui {
namespace {

using namespace std::chrono_literals;

/// A language of three words: "good", "bad", and "endless", which ends only when it is stopped.
class Language {
  public:
    Revision operator()(const Source& source, const csg::scad::View&, const std::stop_token& stop) {
        ++evaluations_;
        const DiskState stamp = csg::scad::disk_state(source.path);
        const std::string text = test_support::read_file(source.path);
        while (text == "endless" && !stop.stop_requested()) {
            std::this_thread::sleep_for(1ms);
        }
        stopped_ += stop.stop_requested() ? 1 : 0;
        Revision revision = text == "good" ? good_revision() : failed_revision();
        revision.files[source.path] = stamp;
        return revision;
    }
    int evaluations() const { return evaluations_; }
    int stopped() const { return stopped_; }

  private:
    std::atomic<int> evaluations_{0}, stopped_{0};
};

class SessionTest : public testing::Test {
  protected:
    void open(const std::string& text, WindowOptions options = {}) {
        options.source.path = folder_.write("model.scad", text);
        session_ = std::make_unique<Session>(
            options,
            [this](const auto& source, const auto& camera, const auto& stop) {
                return language_(source, camera, stop);
            },
            [] {});
    }

    /// Lets the session work until it is in the state; false where it does not get there.
    bool reach(DocumentState state) {
        return until([&] { return session_->document().state() == state && !session_->evaluating(); });
    }
    template <typename Condition>
    bool until(Condition&& condition) {
        for (int i = 0; i < 2000; ++i) {
            now_ += 0.02;
            (void)session_->update(now_);
            if (condition()) {
                return true;
            }
            std::this_thread::sleep_for(2ms);
        }
        return false;
    }

    test_support::TemporaryFolder folder_;
    Language language_;
    std::unique_ptr<Session> session_;
    double now_ = 0;
};

TEST_F(SessionTest, ShowsTheModelWithEverythingInView) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    ASSERT_NE(session_->document().model(), nullptr);
    EXPECT_EQ(session_->view().picture.camera.target, glm::dvec3(5));
}

TEST_F(SessionTest, FollowsItsFileAndKeepsTheCamera) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    const auto model = session_->document().model();
    session_->camera().rotation = {10, 0, 20};
    const base::Camera camera = session_->view().picture.camera;

    folder_.replace("model.scad", "bad");
    ASSERT_TRUE(reach(DocumentState::Failed));
    EXPECT_EQ(session_->document().model(), model) << "the last good one";
    EXPECT_EQ(session_->view().picture.camera, camera);

    folder_.write("model.scad", "good");
    ASSERT_TRUE(reach(DocumentState::Good));
    EXPECT_NE(session_->document().model(), model);
    EXPECT_EQ(session_->view().picture.camera, camera);
    EXPECT_EQ(language_.evaluations(), 3);
}

TEST_F(SessionTest, NewerTextStopsAnOlderEvaluation) {
    open("endless");
    ASSERT_TRUE(until([&] { return language_.evaluations() == 1; }));
    EXPECT_TRUE(session_->evaluating());
    folder_.replace("model.scad", "good");
    ASSERT_TRUE(reach(DocumentState::Good));
    EXPECT_EQ(language_.stopped(), 1);
}

TEST_F(SessionTest, TheEndStopsAnEvaluation) {
    open("endless");
    ASSERT_TRUE(until([&] { return language_.evaluations() == 1; }));
    session_.reset();
    EXPECT_EQ(language_.stopped(), 1);
}

TEST_F(SessionTest, AFileThatGoesAndComesBack) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    folder_.remove("model.scad");
    ASSERT_TRUE(reach(DocumentState::Gone));
    EXPECT_NE(session_->document().model(), nullptr);
    EXPECT_EQ(language_.evaluations(), 1);
    folder_.write("model.scad", "good");
    ASSERT_TRUE(until([&] { return language_.evaluations() == 2; }));
    EXPECT_TRUE(reach(DocumentState::Good));
}

TEST_F(SessionTest, AnErrorAtFirstThenTheModelIsBroughtIntoView) {
    open("bad");
    ASSERT_TRUE(reach(DocumentState::Failed));
    folder_.replace("model.scad", "good");
    ASSERT_TRUE(reach(DocumentState::Good));
    EXPECT_EQ(session_->view().picture.camera.target, glm::dvec3(5));
}

TEST_F(SessionTest, ACameraThatIsGivenStays) {
    WindowOptions options;
    options.camera.camera = base::Camera{};
    options.camera.camera->target = {1, 2, 3};
    open("good", options);
    ASSERT_TRUE(reach(DocumentState::Good));
    EXPECT_EQ(session_->view().picture.camera.target, glm::dvec3(1, 2, 3));
}

TEST_F(SessionTest, ReloadEvaluatesAnew) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    EXPECT_TRUE(session_->perform(Action::Reload));
    ASSERT_TRUE(until([&] { return language_.evaluations() == 2; }));
}

TEST_F(SessionTest, CommandsChangeTheView) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    session_->perform(Action::Top);
    EXPECT_EQ(session_->view().picture.camera.rotation, glm::dvec3(0));
    session_->perform(Action::Right);
    EXPECT_EQ(session_->view().picture.camera.rotation, glm::dvec3(90, 0, 90));
    session_->perform(Action::ToggleProjection);
    EXPECT_EQ(session_->view().picture.camera.projection, base::Projection::Orthographic);
    const double distance = session_->view().picture.camera.distance;
    session_->perform(Action::ZoomIn);
    EXPECT_LT(session_->view().picture.camera.distance, distance);
    session_->perform(Action::ViewAll);
    EXPECT_NEAR(session_->view().picture.camera.distance, distance, 1e-9);
    session_->perform(Action::TurnLeft);
    EXPECT_NEAR(session_->view().picture.camera.rotation.z, 105, 1e-9) << "as by a drag to the left";
    session_->perform(Action::LookAtOrigin);
    EXPECT_EQ(session_->view().picture.camera.target, glm::dvec3(0));
    session_->perform(SetSamples{8});
    EXPECT_EQ(session_->view().picture.samples, 8);
    session_->perform(SetScheme{2});
    EXPECT_EQ(session_->view().picture.scheme, npr::color_schemes()[2]);
    session_->perform(SetTransparency{npr::Transparency::ViewDependent});
    session_->perform(SetTransparencyParameter{1, 0.25F});
    EXPECT_EQ(session_->view().picture.transparency_parameters.at(1), npr::Value(0.25F));
    session_->perform(SetTransparency{npr::Transparency::Volume});
    EXPECT_EQ(session_->view().picture.transparency, npr::Transparency::Volume);
    EXPECT_FALSE(session_->perform(Action::Quit)) << "is the window's";
    EXPECT_FALSE(session_->perform(WritePicture{}));
}

TEST_F(SessionTest, StylesGoRound) {
    open("good");
    for (std::size_t i = 0; i < npr::styles().size(); ++i) {
        EXPECT_EQ(session_->view().style(), i);
        session_->perform(Action::NextStyle);
    }
    EXPECT_EQ(session_->view().style(), 0U);
    session_->perform(Action::PreviousStyle);
    EXPECT_EQ(session_->view().style(), npr::styles().size() - 1);
}

TEST_F(SessionTest, ParametersAreSetAndReset) {
    open("good");
    session_->perform(SetStyle{npr::styles().size() - 1});
    const npr::Parameters& values = session_->view().picture.parameters;
    ASSERT_FALSE(values.list().empty());
    std::size_t toggle = 0;
    while (values.list()[toggle].kind != npr::ParameterKind::Toggle) {
        ++toggle;
        ASSERT_LT(toggle, values.list().size());
    }
    const bool before = std::get<bool>(values.at(toggle));
    session_->perform(SetParameter{toggle, !before});
    EXPECT_EQ(std::get<bool>(values.at(toggle)), !before);
    session_->perform(ResetParameters{});
    EXPECT_EQ(std::get<bool>(values.at(toggle)), before);
}

TEST_F(SessionTest, LayersGoFromOneToAll) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    const Model& model = *session_->document().model();
    EXPECT_EQ(session_->view().picture.layers, -1);
    session_->see_layers(model, 3);
    session_->see_layers(model, 2);
    EXPECT_EQ(session_->layer_count(), 3) << "the most that were seen";
    for (const int expected : {1, 2, 3, 0, 0}) {  // 0: all.
        session_->perform(Action::MoreLayers);
        EXPECT_EQ(session_->view().picture.layers, expected);
    }
    for (const int expected : {3, 2, 1, 1}) {
        session_->perform(Action::FewerLayers);
        EXPECT_EQ(session_->view().picture.layers, expected);
    }
    session_->see_layers(*cube_model(), 1);
    EXPECT_EQ(session_->layer_count(), 1) << "of another model";
}

TEST_F(SessionTest, LookingAtAPointCentersItAtItsSize) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    const glm::dvec3 point{0, 10, 10};
    const glm::dvec3 back =
        glm::normalize(session_->view().picture.camera.eye() - session_->view().picture.camera.target);
    const double depth = glm::dot(session_->view().picture.camera.eye() - point, back);
    session_->look_at(point);
    EXPECT_EQ(session_->view().picture.camera.target, point);
    EXPECT_NEAR(glm::dot(session_->view().picture.camera.eye() - point, back), depth, 1e-9);
}

TEST_F(SessionTest, SectionsAreResolvedByTheCameraAndDivideTheModelByColor) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    const int evaluations = language_.evaluations();
    const npr::PlaneSection plane{{0, 0, 1}, 0.5};
    session_->camera().rotation = {120, 0, 0};  // From below.
    session_->perform(SetSections{{{{plane, "plane"}}, {}, 1}});
    const auto& cuts = session_->view().picture.sections.cuts;
    ASSERT_EQ(cuts.size(), 1U);
    EXPECT_EQ(std::get<npr::PlaneSection>(cuts[0].cut),
              (npr::PlaneSection{{0, 0, -1}, -0.5, npr::PlaneSection::Away::Beyond}));
    EXPECT_EQ(session_->document().source().parts.kind, csg::PartRule::Kind::Color);
    ASSERT_TRUE(until([&] { return language_.evaluations() == evaluations + 1 && !session_->evaluating(); }));
    session_->perform(SetSections{{{{plane, "plane"}}, {}, 0}});
    session_->perform(SetSections{{}});
    EXPECT_EQ(language_.evaluations(), evaluations + 1) << "once is enough";
    EXPECT_TRUE(session_->view().picture.sections.cuts.empty());
}

TEST_F(SessionTest, ASectionBesideTheModelIsAWarning) {
    open("good");
    ASSERT_TRUE(reach(DocumentState::Good));
    const auto at = [](double offset) { return SetSections{{{{npr::PlaneSection{{0, 0, 1}, offset}, "z"}}, {}, 0}}; };
    session_->perform(at(5));
    ASSERT_TRUE(reach(DocumentState::Good));
    EXPECT_EQ(session_->document().messages().warnings(), 0U);
    session_->perform(at(50));
    ASSERT_TRUE(reach(DocumentState::Good));
    EXPECT_EQ(session_->document().messages().warnings(), 1U) << "it misses, or takes all, by the side of the eye";
}

}  // namespace
}  // namespace ui

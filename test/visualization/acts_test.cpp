#include "layer_actors.h"
#include "layer_keys.h"
#include "layer_stage.h"
#include "shown_picture.h"
#include "temporary_folder.h"
#include "viewed_room.h"
#include "virtual_display.h"

#include <pcl/conversions.h>
#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/layered_scene.h>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

using Layers = std::set<SceneLayer>;
class Acts : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!display_.exists())
      GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
    view_.width = 320;
    view_.height = 240;
  }

  ShownPicture
  shoot()
  {
    saveSnapshot(path_, scene_, view_);
    return ShownPicture(path_);
  }

  void
  expectRefused()
  {
    EXPECT_THROW(saveSnapshot(path_, scene_, view_), BadArgumentException);
    EXPECT_EQ(folder_.count(), 0);
  }

  /** \brief Opens an off-screen window. */
  void
  open()
  {
    connection_.emplace();
    stage_.emplace(scene_, view_);
    window_->SetOffScreenRendering(1);
    window_->SetSize(view_.width, view_.height);
    window_->AddRenderer(stage_->renderer());
    overlay_.emplace(*window_);
    interactor_->SetRenderWindow(window_);
    interactor_->SetInteractorStyle(keys_);
    keys_->attach(
        *stage_, scene_, *overlay_, [&](const std::string& text) { told_ += text; });
    window_->Render();
  }

  std::string
  press(char key)
  {
    told_.clear();
    interactor_->SetEventInformation(0, 0, 0, 0, key);
    interactor_->InvokeEvent(vtkCommand::CharEvent);
    return told_;
  }

  Layers
  shown() const
  {
    Layers layers;
    for (int layer = 1; layer <= 6; ++layer)
      if (stage_->isShown(static_cast<SceneLayer>(layer)))
        layers.insert(static_cast<SceneLayer>(layer));
    return layers;
  }

  Eigen::Vector3d
  eye() const
  {
    return Eigen::Vector3d(stage_->renderer()->GetActiveCamera()->GetPosition());
  }

  const VirtualDisplay& display_ = VirtualDisplay::shared();
  TemporaryFolder folder_;
  std::string path_ = folder_.path("out.png");
  LayeredScene scene_ = makeViewedRoom();
  LayeredView view_;
  std::optional<DisplayConnection> connection_;
  std::optional<LayerStage> stage_;
  vtkNew<vtkRenderWindow> window_;
  std::optional<Overlay> overlay_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<LayerKeys> keys_;
  std::string told_;
};

bool
isPink(const ShownPicture::Pixel& p)
{
  return p[0] > 200 && p[1] < 90 && p[2] > 80 && p[2] < 160;
}

TEST_F(Acts, BeforeLiesWhereThePosesWere)
{
  view_.layers = {SceneLayer::Trajectory};
  const auto after = shoot().middle(isPink);
  view_.before = true;
  const auto before = shoot().middle(isPink);
  EXPECT_LT(before[1], after[1] - 0.05) << "a metre higher";
  EXPECT_NEAR(before[0], after[0], 0.05);
}

TEST_F(Acts, BThrowsBeforeAndAfterWithLayersOfTheirOwn)
{
  open();
  const Layers after = {SceneLayer::Texture, SceneLayer::Trajectory};
  const Layers before = {SceneLayer::Points, SceneLayer::Trajectory};
  EXPECT_EQ(shown(), after);
  EXPECT_NE(press('b').find("before"), std::string::npos);
  EXPECT_EQ(shown(), before);
  EXPECT_NE(press('4').find("planes before"), std::string::npos);
  EXPECT_NE(press('t').find("texture"), std::string::npos);
  EXPECT_EQ(shown(), before);
  press('1');
  EXPECT_NE(press('b').find("after"), std::string::npos);
  EXPECT_EQ(shown(), after);
  press('b');
  EXPECT_EQ(shown(), Layers{SceneLayer::Trajectory}) << "as it was left";
}

TEST_F(Acts, BSlidesFromOneStateToTheOther)
{
  open();
  const auto lowest = [&] { // of what is visible; y is down
    double bounds[6];
    stage_->renderer()->ComputeVisiblePropBounds(bounds);
    return bounds[3];
  };
  press('b');
  std::vector<double> heights;
  for (int i = 0; i < 60; ++i) {
    interactor_->InvokeEvent(vtkCommand::TimerEvent);
    heights.push_back(lowest());
  }
  EXPECT_TRUE(std::is_sorted(heights.rbegin(), heights.rend())) << "upwards";
  EXPECT_NEAR(heights.front() - heights.back(), 1, 0.05);
  EXPECT_GT(std::set<double>(heights.begin(), heights.end()).size(), 20u);
  const Trajectory half = posesBetween(scene_, 0.5);
  EXPECT_NEAR(half.poses[3].translation().y(),
              scene_.map.trajectory.poses[3].translation().y() - 0.5,
              1e-9);
}

TEST_F(Acts, BSaysWhenThereIsNothingBefore)
{
  scene_.trajectory_before.poses.pop_back();
  open();
  const Layers after = shown();
  EXPECT_NE(press('b').find("poses before"), std::string::npos);
  EXPECT_EQ(shown(), after);
  scene_.trajectory_before = {};
  EXPECT_NE(press('b').find("nothing"), std::string::npos);
  view_.before = true;
  expectRefused();
}

TEST_F(Acts, PointsThatAllNameNoPoseLeaveTheMapShown)
{
  auto points = typed(scene_.points);
  for (ViewedPoint& point : points)
    point.view = -1;
  toPCLPointCloud2(points, scene_.points);
  open();
  const Layers after = shown();
  EXPECT_NE(press('b'), "");
  EXPECT_EQ(shown(), after);
}

TEST_F(Acts, TSwapsPlanesWithAndWithoutTexture)
{
  open();
  press('t');
  EXPECT_EQ(shown(), (Layers{SceneLayer::Planes, SceneLayer::Trajectory}));
  press('t');
  EXPECT_EQ(shown(), (Layers{SceneLayer::Texture, SceneLayer::Trajectory}));
  for (TextureChart& chart : scene_.map.charts)
    chart.colors.values.clear();
  stage_.reset();
  stage_.emplace(scene_, view_);
  keys_->attach(
      *stage_, scene_, *overlay_, [&](const std::string& text) { told_ += text; });
  EXPECT_NE(press('t').find("nothing to show as texture"), std::string::npos);
  EXPECT_EQ(shown(), (Layers{SceneLayer::Planes, SceneLayer::Trajectory}));
}

TEST_F(Acts, EachStepShowsMoreOfTheMesh)
{
  std::vector<double> covered;
  for (std::size_t step = 0; step < 3; ++step) {
    view_.wall_step = step;
    covered.push_back(shoot().covered());
  }
  EXPECT_GT(covered[0], 0.01);
  EXPECT_GT(covered[1], 1.5 * covered[0]);
  EXPECT_GT(covered[2], covered[1] + 0.5 * covered[0]);
  const auto is_red = [](const ShownPicture::Pixel& p) {
    return p[0] > 2 * p[1] && p[0] > 2 * p[2];
  };
  view_.wall_step = 0;
  EXPECT_GT(shoot().share(is_red), 0.01) << "the wall of the step";
  view_.wall_step = 1;
  EXPECT_EQ(shoot().share(is_red), 0) << "pale now";
}

TEST_F(Acts, StepsThatAreNotThereAreRefused)
{
  view_.wall_step = 3;
  expectRefused();
  view_.wall_step = 0;
  view_.before = true;
  expectRefused();
  view_.before = false;
  scene_.mesh.wall_depth = {};
  expectRefused();
  scene_.mesh.wall_depth = {0, 1};
  expectRefused();
}

TEST_F(Acts, NStepsOnAndBack)
{
  open();
  const Layers map = shown();
  EXPECT_NE(press('N').find("no step"), std::string::npos);
  EXPECT_NE(press('n').find("step 0 of 0 to 2: 1 triangles"), std::string::npos);
  EXPECT_EQ(shown(), Layers{SceneLayer::Mesh});
  EXPECT_NE(press('n').find("step 1"), std::string::npos);
  EXPECT_NE(press('n').find("step 2 of 0 to 2: 4 triangles"), std::string::npos);
  EXPECT_NE(press('n').find("last"), std::string::npos);
  EXPECT_EQ(stage_->step(), 2u);
  press('N');
  EXPECT_EQ(stage_->step(), 1u);
  press('N');
  press('N');
  EXPECT_EQ(shown(), map);
  scene_.mesh.wall_depth = {};
  EXPECT_NE(press('n').find("wall depths"), std::string::npos);
  EXPECT_EQ(shown(), map);
}

TEST_F(Acts, SpaceFliesAndStops)
{
  open();
  const Eigen::Vector3d outside = eye();
  EXPECT_EQ(press(' '), "");
  const Eigen::Vector3d first = eye();
  EXPECT_GT((first - outside).norm(), 0.5);
  const Trajectory& way = scene_.map.trajectory;
  EXPECT_LT((first - way.poses.front().translation()).norm(), 2);
  interactor_->InvokeEvent(vtkCommand::TimerEvent);
  const Eigen::Vector3d next = eye();
  EXPECT_GT((next - first).norm(), 0);
  EXPECT_LT((next - first).norm(), 0.2) << "smoothly";
  press(' ');
  interactor_->InvokeEvent(vtkCommand::TimerEvent);
  EXPECT_EQ(eye(), next);
  press(' ');
  for (int i = 0; i < 2000 && told_.empty(); ++i)
    interactor_->InvokeEvent(vtkCommand::TimerEvent);
  EXPECT_NE(told_.find("end"), std::string::npos);
  EXPECT_LT((eye() - way.poses.back().translation()).norm(), 2);
  press(' ');
  EXPECT_LT((eye() - first).norm(), 1e-6) << "from the start again";
}

TEST_F(Acts, SpaceSaysWhenThereIsNoTrajectory)
{
  scene_.map.trajectory = {};
  open();
  EXPECT_NE(press(' ').find("no trajectory"), std::string::npos);
  scene_.map.trajectory.poses = {Eigen::Isometry3d(Eigen::Matrix4d::Constant(NAN))};
  EXPECT_NE(press(' ').find("no trajectory"), std::string::npos);
}

TEST_F(Acts, AFlightOfOnePoseEndsAtOnce)
{
  scene_.map.trajectory.poses.resize(1);
  open();
  EXPECT_EQ(press(' '), "");
  EXPECT_LT((eye() - scene_.map.trajectory.poses[0].translation()).norm(), 2);
}

TEST_F(Acts, TheEyeIsThatOfAPose)
{
  view_.at_pose = 1;
  open();
  const Eigen::Isometry3d& pose = scene_.map.trajectory.poses[1];
  EXPECT_LT((eye() - pose.translation()).norm(), 1e-9);
  const Eigen::Vector3d ahead(
      stage_->renderer()->GetActiveCamera()->GetDirectionOfProjection());
  EXPECT_LT((ahead - pose.linear().col(2)).norm(), 1e-9);
  view_.before = true;
  stage_.emplace(scene_, view_);
  EXPECT_LT((eye() - scene_.trajectory_before.poses[1].translation()).norm(), 1e-9);
}

TEST_F(Acts, PosesThatAreNotThereAreNoPlaceOfTheEye)
{
  view_.at_pose = scene_.map.trajectory.poses.size();
  expectRefused();
  view_.at_pose = 0;
  view_.from = Eigen::Vector3f(0, 0, 0);
  expectRefused();
  view_.from.reset();
  scene_.map.trajectory.poses[0].matrix().setConstant(NAN);
  expectRefused();
}

TEST_F(Acts, APlanNeedsNoPlanesButAWay)
{
  scene_.map.planes.clear();
  scene_.map.charts.clear();
  scene_.mesh = {};
  view_.place = MapView::Place::Plan;
  view_.layers = {SceneLayer::Points};
  EXPECT_GT(shoot().covered(), 0.0005);
  auto points = typed(scene_.points);
  for (ViewedPoint& point : points)
    point.y -= 2; // y is down, so that they now look like a ceiling
  points.front().y += 2;
  const auto count_of = [&] {
    toPCLPointCloud2(points, scene_.points);
    return shoot().covered();
  };
  const double one = count_of();
  for (ViewedPoint& point : points)
    point.y += 2;
  EXPECT_GT(count_of(), 1.5 * one) << "beside the bar of the scale";
  scene_.map.trajectory = {};
  std::filesystem::remove(path_);
  expectRefused();
}

} // namespace
} // namespace pcl::acmap::test

#include "clouds.h"
#include "layer_keys.h"
#include "layer_stage.h"
#include "measuring.h"
#include "room_map.h"
#include "shown_picture.h"
#include "temporary_folder.h"
#include "virtual_display.h"

#include <pcl/conversions.h>
#include <pcl/visualization/display_connection.h>
#include <pcl/visualization/layered_scene.h>
#include <pcl/visualization/map_layers.h>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;
using Layers = std::set<SceneLayer>;

/** \brief The room, with a wavy mesh in it and its vertices as a cloud. */
LayeredScene
makeScene()
{
  LayeredScene scene;
  Cloud wavy = makeGrid(20, 20, 0.125, ExactPlane::Level);
  for (PointXYZ& p : wavy)
    p.z = 0.1F * std::sin(5 * p.x);
  toPCLPointCloud2(wavy, scene.vertices);
  scene.points = scene.vertices;
  for (int row = 0; row < 19; ++row)
    for (int column = 0; column < 19; ++column) {
      const int a = row * 20 + column;
      scene.mesh.triangles.push_back({a, a + 20, a + 1});
      scene.mesh.triangles.push_back({a + 1, a + 20, a + 21});
    }
  scene.map = makeRoomMap();
  scene.map.trajectory = makeRoomWay();
  return scene;
}

class LayersOfScene : public testing::Test {
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
  shoot(const Layers& layers)
  {
    view_.layers = layers;
    saveSnapshot(path_, scene_, view_);
    return ShownPicture(path_);
  }

  const VirtualDisplay& display_ = VirtualDisplay::shared();
  TemporaryFolder folder_;
  std::string path_ = folder_.path("out.png");
  LayeredScene scene_ = makeScene();
  LayeredView view_;
};

TEST(Layers, AreThoseThereIsSomethingFor)
{
  LayeredScene scene = makeScene();
  EXPECT_EQ(layersOf(scene).size(), 6u);
  EXPECT_EQ(usualLayers(scene), (Layers{SceneLayer::Texture, SceneLayer::Trajectory}));
  for (TextureChart& chart : scene.map.charts)
    chart.colors.values.clear();
  EXPECT_EQ(usualLayers(scene), (Layers{SceneLayer::Planes, SceneLayer::Trajectory}));
  scene.map = {};
  EXPECT_EQ(usualLayers(scene), Layers{SceneLayer::Mesh});
  scene.mesh = {};
  EXPECT_EQ(layersOf(scene), Layers{SceneLayer::Points});
  EXPECT_EQ(usualLayers(scene), Layers{SceneLayer::Points});
  EXPECT_TRUE(layersOf({}).empty());
}

TEST(Layers, AreCountedInTheTitle)
{
  LayeredScene scene = makeScene();
  EXPECT_EQ(describeScene(scene), "400 points, 722 triangles, 6 planes, 11 poses");
  scene.map.cylinders.resize(1);
  scene.points.width = 1234567;
  scene.points.height = 1;
  EXPECT_EQ(describeScene(scene),
            "1 234 567 points, 722 triangles, 6 planes, 1 cylinder, 11 poses");
  EXPECT_EQ(describeScene({}), "");
}

TEST_F(LayersOfScene, EachDrawsSomethingOfItsOwn)
{
  const auto is_blue = [](const ShownPicture::Pixel& p) { return p[2] > 2 * p[0]; };
  const auto is_grey = [](const ShownPicture::Pixel& p) {
    return p[0] < 190 && std::abs(p[0] - p[1]) < 6 && std::abs(p[1] - p[2]) < 12;
  };
  const auto is_green = [](const ShownPicture::Pixel& p) {
    return p[1] > p[0] + 60 && p[1] > p[2] + 40;
  };
  const auto is_orange = [](const ShownPicture::Pixel& p) { return p[0] > p[2] + 60; };
  const auto is_red = [](const ShownPicture::Pixel& p) {
    return p[0] > 2 * p[1] && p[0] > 2 * p[2];
  };
  const auto is_pink = [](const ShownPicture::Pixel& p) {
    return p[0] > 200 && p[1] < 90 && p[2] > 80 && p[2] < 160;
  };
  EXPECT_GT(shoot({SceneLayer::Points}).share(is_blue), 0.005);
  EXPECT_GT(shoot({SceneLayer::Mesh}).share(is_grey), 0.02);
  EXPECT_GT(shoot({SceneLayer::Normals}).share(is_green), 0.001);
  EXPECT_GT(shoot({SceneLayer::Planes}).share(is_orange), 0.2) << "the floor";
  EXPECT_GT(shoot({SceneLayer::Texture}).share(is_red), 0.03) << "a wall";
  EXPECT_GT(shoot({SceneLayer::Trajectory}).share(is_pink), 0.001);
}

/** They are never shown without being asked for. */
TEST_F(LayersOfScene, ProposedSurfacesAreOne)
{
  const Layers usual = usualLayers(scene_);
  for (PlanePatch& plane : scene_.map.planes)
    plane.proposed = plane.polygons;
  EXPECT_EQ(layersOf(scene_).size(), 7u);
  EXPECT_EQ(usualLayers(scene_), usual);
  // planes are translucent as well where something is beneath them
  const std::vector<ShownPicture::Pixel> planes =
      shoot({SceneLayer::Texture, SceneLayer::Planes}).pixels;
  const auto shoot_proposed = [&] {
    return shoot({SceneLayer::Texture, SceneLayer::Proposed}).pixels;
  };
  EXPECT_EQ(shoot_proposed(), planes);
  for (PlanePatch& plane : scene_.map.planes)
    plane.proposed.clear();
  scene_.map.planes[0].proposed = scene_.map.planes[0].polygons;
  EXPECT_NE(shoot_proposed(), planes);
}

/** A plane that looks away leaves no wires behind. */
TEST_F(LayersOfScene, PlanesAreOpenFromBehind)
{
  scene_.map.planes.resize(1);
  scene_.map.charts.clear();
  scene_.map.trajectory = {};
  view_.from = Eigen::Vector3f(0, 0, 6);
  EXPECT_EQ(shoot({SceneLayer::Planes}).covered(), 0);
  view_.from = Eigen::Vector3f(0, 0, -6);
  EXPECT_GT(shoot({SceneLayer::Planes}).covered(), 0.1);
}

/** Its noise does not bring the mesh before the plane that was found in it. */
TEST_F(LayersOfScene, AMeshDoesNotFlickerInItsPlane)
{
  scene_.map.planes.resize(1);
  scene_.map.charts.clear();
  scene_.map.trajectory = {};
  Cloud rough = makeGrid(20, 20, 0.1, ExactPlane::Level);
  for (std::size_t i = 0; i < rough.size(); ++i) {
    PointXYZ& p = rough[i];
    p.getVector3fMap() = Eigen::Vector3f(
        p.x - 0.95F, 0.1F * static_cast<float>(i / 20) - 1, i % 3 == 0 ? 1.99F : 2.01F);
  }
  toPCLPointCloud2(rough, scene_.vertices);
  view_.from = Eigen::Vector3f(0, 0, -3);
  const auto is_plane = [](const ShownPicture::Pixel& p) {
    const auto [least, most] = std::minmax({p[0], p[1], p[2]});
    return most - least > 20; // neither background nor mesh
  };
  const double plane = shoot({SceneLayer::Mesh, SceneLayer::Planes}).share(is_plane);
  EXPECT_GT(plane, 0.95 * shoot({SceneLayer::Planes}).share(is_plane));
}

TEST_F(LayersOfScene, LieUponEachOther)
{
  Layers layers;
  std::vector<ShownPicture::Pixel> before;
  for (const SceneLayer layer : layersOf(scene_)) {
    layers.insert(layer);
    const ShownPicture next = shoot(layers);
    EXPECT_NE(next.pixels, before) << static_cast<int>(layer);
    before = next.pixels;
  }
}

TEST_F(LayersOfScene, OfAMeshAloneLookAsItsSnapshotDoes)
{
  scene_.map = {};
  view_.layers = {};
  saveSnapshot(path_, scene_, view_);
  const std::string layered = contentOf(path_);
  saveSnapshot(path_, scene_.vertices, scene_.mesh, view_);
  EXPECT_EQ(contentOf(path_), layered);
  scene_.mesh = {};
  saveSnapshot(path_, scene_, view_);
  const std::string points = contentOf(path_);
  saveSnapshot(path_, scene_.points, {}, view_);
  EXPECT_EQ(contentOf(path_), points);
}

TEST_F(LayersOfScene, OfWhichThereIsNothingAreRefused)
{
  scene_.map.trajectory = {};
  view_.layers = {SceneLayer::Trajectory};
  EXPECT_THROW(saveSnapshot(path_, scene_, view_), BadArgumentException);
  scene_.map = {};
  view_.layers = {};
  view_.place = MapView::Place::Plan;
  EXPECT_THROW(saveSnapshot(path_, scene_, view_), BadArgumentException);
  EXPECT_THROW(saveSnapshot(path_, LayeredScene(), view_), InitFailedException);
  scene_.mesh = {};
  scene_.points = scene_.vertices = {};
  scene_.map.trajectory = makeRoomWay();
  EXPECT_THROW(saveSnapshot(path_, scene_, view_), InitFailedException);
  EXPECT_EQ(folder_.count(), 0);
}

/** \brief Layers in an off-screen window. */
class LayersInAWindow : public LayersOfScene {
protected:
  void
  open()
  {
    view_.layers = {SceneLayer::Texture};
    connection_.emplace();
    stage_.emplace(scene_, view_);
    window_->SetOffScreenRendering(1);
    window_->SetSize(view_.width, view_.height);
    window_->AddRenderer(stage_->renderer());
    overlay_.emplace(*window_);
    interactor_->SetRenderWindow(window_);
    interactor_->SetInteractorStyle(keys_);
    keys_->attach(
        *stage_, scene_, *overlay_, [&](const std::string& text) { told_ = text; });
    window_->Render();
  }

  void
  press(char key, int column = 0, int row = 0)
  {
    told_.clear();
    interactor_->SetEventInformation(column, row, 0, 0, key);
    interactor_->InvokeEvent(vtkCommand::CharEvent);
  }

  std::optional<DisplayConnection> connection_;
  std::optional<LayerStage> stage_;
  vtkNew<vtkRenderWindow> window_;
  std::optional<Overlay> overlay_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<LayerKeys> keys_;
  std::string told_;
};

TEST_F(LayersInAWindow, KeysTurnLayersOnAndOff)
{
  open();
  EXPECT_TRUE(stage_->isShown(SceneLayer::Texture));
  for (const SceneLayer layer : layersOf(scene_)) {
    const bool before = stage_->isShown(layer);
    const char key = static_cast<char>('0' + static_cast<int>(layer));
    press(key);
    EXPECT_NE(stage_->isShown(layer), before) << key;
    press(key);
    EXPECT_EQ(stage_->isShown(layer), before) << key;
    EXPECT_EQ(told_, "");
  }
}

TEST_F(LayersInAWindow, AClickOnAnEntryOfThePanelTogglesIt)
{
  open();
  const auto click = [&](int row) {
    interactor_->SetEventInformation(
        60, view_.height - 12 - 6 - 24 * row - 12, 0, 0, 0);
    interactor_->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    interactor_->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  };
  click(0);
  EXPECT_TRUE(stage_->isShown(SceneLayer::Points));
  click(4);
  EXPECT_FALSE(stage_->isShown(SceneLayer::Texture));
  EXPECT_FALSE(overlay_->rowAt(60, 5));
  EXPECT_FALSE(overlay_->rowAt(300, view_.height - 30));
}

TEST_F(LayersInAWindow, TurningKeepsTheHorizonLevel)
{
  for (const auto place : {MapView::Place::Outside, MapView::Place::Plan}) {
    view_.place = place;
    interactor_->SetInteractorStyle(nullptr);
    stage_.reset();
    overlay_.reset();
    open();
    vtkCamera& camera = *stage_->renderer()->GetActiveCamera();
    interactor_->SetEventInformation(150, 50, 0, 0, 0);
    interactor_->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    Eigen::Vector3d ahead(camera.GetDirectionOfProjection());
    for (const auto& [column, row] : {std::pair{190, 80}, {40, 130}, {260, 10}}) {
      interactor_->SetEventInformation(column, row, 0, 0, 0);
      interactor_->InvokeEvent(vtkCommand::MouseMoveEvent);
      const Eigen::Vector3d next(camera.GetDirectionOfProjection());
      const Eigen::Vector3d right = next.cross(Eigen::Vector3d(camera.GetViewUp()));
      EXPECT_GT((next - ahead).norm(), 0.05) << "turned";
      EXPECT_NEAR(right.normalized().dot(stage_->up()), 0, 1e-9);
      ahead = next;
    }
    interactor_->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  }
}

TEST_F(LayersInAWindow, NothingIsClipped)
{
  scene_.map.trajectory.poses.back().translation() = Vector3d(0, -4, -5);
  open();
  double range[2];
  vtkCamera& camera = *stage_->renderer()->GetActiveCamera();
  camera.GetClippingRange(range);
  for (const auto& pose : scene_.map.trajectory.poses) {
    const double depth = (pose.translation() - Vector3d(camera.GetPosition()))
                             .dot(Vector3d(camera.GetDirectionOfProjection()));
    EXPECT_GT(depth, range[0]);
    EXPECT_LT(depth, range[1]);
  }
}

/** \brief Layers seen from the middle of the room towards the front wall. */
class MeasuringInAWindow : public LayersInAWindow {
protected:
  void
  open()
  {
    view_.place = MapView::Place::Inside;
    view_.from = Eigen::Vector3f(0, 0, 0);
    view_.look = Eigen::Vector3f(0, 0, 1);
    scene_.map.trajectory = {};
    LayersInAWindow::open();
  }

  std::string
  measure(Measuring& measuring, std::array<int, 2> first, std::array<int, 2> second)
  {
    measuring.pick(first[0], first[1]);
    measuring.pick(second[0], second[1]);
    return measuring.told();
  }

  std::array<int, 2>
  pixelOf(const Vector3d& place)
  {
    vtkRenderer* const renderer = stage_->renderer();
    renderer->SetWorldPoint(place.x(), place.y(), place.z(), 1);
    renderer->WorldToDisplay();
    const double* const at = renderer->GetDisplayPoint();
    return {static_cast<int>(at[0]), static_cast<int>(at[1])};
  }
};

TEST_F(MeasuringInAWindow, PointsSnapToCorners)
{
  open();
  Measuring measuring(*stage_, scene_.map);
  EXPECT_EQ(measuring.told(), "");
  measuring.measureNext();
  EXPECT_NE(measuring.told().find("click on a point"), std::string::npos);
  auto low = pixelOf({1, 1.2, 2}), high = pixelOf({1, -0.8, 2}); // of the door
  low[0] += 4;
  high[1] -= 3;
  EXPECT_EQ(measure(measuring, low, high), "2.000 m (upright)");
  EXPECT_EQ(measure(measuring, high, pixelOf({2, 1.2, 2})),
            "2.236 m (level 1.000 m, upright 2.000 m)");
}

/** A turn or a click on the panel picks nothing. */
TEST_F(MeasuringInAWindow, ClicksInTheWindowMeasure)
{
  open();
  press('m');
  const auto click = [&](std::array<int, 2> down, std::array<int, 2> up) {
    interactor_->SetEventInformation(down[0], down[1], 0, 0, 0);
    interactor_->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    interactor_->SetEventInformation(up[0], up[1], 0, 0, 0);
    interactor_->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  };
  const int props = stage_->renderer()->GetViewProps()->GetNumberOfItems();
  const auto low = pixelOf({1, 1.2, 2}), high = pixelOf({1, -0.8, 2});
  click({60, view_.height - 30}, {60, view_.height - 30});
  click({250, 60}, {250, 90});
  click(low, low);
  EXPECT_EQ(stage_->renderer()->GetViewProps()->GetNumberOfItems(), props + 1)
      << "of the layer that the panel showed";
  click(high, high);
  EXPECT_EQ(stage_->renderer()->GetViewProps()->GetNumberOfItems(), props + 3)
      << "the line and its length";
}

TEST_F(MeasuringInAWindow, PlanesAreMeasuredIfTheyAreParallel)
{
  open();
  Measuring measuring(*stage_, scene_.map);
  measuring.measureNext();
  measuring.measureNext();
  const std::string height = measure(measuring, {160, 5}, {160, 235});
  EXPECT_EQ(height.substr(0, 8), "2.500 m ") << height;
  EXPECT_NE(height.find("mm"), std::string::npos) << height;
  const std::string angle = measure(measuring, {160, 5}, {100, 130});
  EXPECT_NE(angle.find("90"), std::string::npos) << angle;
  measuring.measureNext();
  EXPECT_EQ(measuring.told(), "");
}

TEST_F(LayersInAWindow, AKeyWithoutALayerSaysSo)
{
  scene_.map.trajectory = {};
  open();
  press('6');
  EXPECT_NE(told_.find("trajectory"), std::string::npos);
  EXPECT_FALSE(stage_->isShown(SceneLayer::Trajectory));
}

TEST_F(LayersInAWindow, HelpNamesAllKeys)
{
  open();
  press('h');
  for (const char* word : {"1 to 7",
                           "m: measure",
                           "b: before",
                           "t: planes",
                           "n, N",
                           "space: fly",
                           "p or shift",
                           "q: end"})
    EXPECT_NE(told_.find(word), std::string::npos) << word;
}

TEST_F(LayersInAWindow, TheCardIsThatOfThePlaneUnderTheMouse)
{
  view_.place = MapView::Place::Inside;
  view_.from = Eigen::Vector3f(0, 0, 0);
  view_.look = Eigen::Vector3f(0, 0, 1);
  open();
  press('p', 160, 120);
  EXPECT_EQ(told_.substr(0, 8), "Plane 0,");
  press('p', 160, 2);
  EXPECT_EQ(told_.substr(0, 8), "Plane 4,") << "the floor is below";
  press('p', 160, 237);
  EXPECT_EQ(told_.substr(0, 8), "Plane 5,");
  press('p', 288, 100);
  EXPECT_EQ(told_, "no plane there\n") << "the door";
}

TEST_F(LayersInAWindow, AClickWithShiftGivesTheCardToo)
{
  open();
  interactor_->SetEventInformation(160, 100, 0, 1, 0);
  interactor_->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  EXPECT_EQ(told_.substr(0, 8), "Plane 4,") << "the ceiling is not there from above";
}

TEST_F(LayersInAWindow, AreAddedToARendererOfOnesOwn)
{
  open();
  const vtkSmartPointer<vtkRenderer> mine = vtkSmartPointer<vtkRenderer>::New();
  EXPECT_TRUE(addPointLayer(*mine, scene_.points));
  EXPECT_TRUE(addMeshLayer(*mine, scene_.vertices, scene_.mesh));
  EXPECT_TRUE(addNormalLayer(*mine, scene_.vertices, scene_.mesh));
  EXPECT_TRUE(addPlaneLayer(*mine, scene_.map));
  EXPECT_TRUE(addTextureLayer(*mine, scene_.map));
  EXPECT_TRUE(addTrajectoryLayer(*mine, scene_.map.trajectory));
  EXPECT_EQ(mine->VisibleActorCount(), 6);
  EXPECT_THROW(addTrajectoryLayer(*mine, scene_.map.trajectory, 0),
               BadArgumentException);
  EXPECT_THROW(addPointLayer(*mine, {}), BadArgumentException);
  scene_.map.charts[0].plane = 99;
  EXPECT_THROW(addTextureLayer(*mine, scene_.map), BadArgumentException);
  EXPECT_EQ(mine->VisibleActorCount(), 6);
}

} // namespace
} // namespace pcl::acmap::test

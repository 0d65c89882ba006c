#include "room_map.h"
#include "shown_picture.h"
#include "temporary_folder.h"
#include "virtual_display.h"

#include <pcl/visualization/map_snapshot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Paint = MapView::Paint;
using Place = MapView::Place;
using Pixel = ShownPicture::Pixel;

bool
isRed(const Pixel& p)
{
  return p[0] > 2 * p[1] && p[0] > 2 * p[2] && p[0] > 90;
}

bool
isGreen(const Pixel& p)
{
  return p[1] > 2 * p[0] && p[1] > 2 * p[2] && p[1] > 90;
}

bool
isBlue(const Pixel& p)
{
  return p[2] > 2 * p[0] && p[2] > 2 * p[1] && p[2] > 90;
}

bool
isYellow(const Pixel& p)
{
  return p[0] > 2 * p[2] && p[1] > 2 * p[2] && p[0] > 90;
}

bool
isCyan(const Pixel& p)
{
  return p[1] > 2 * p[0] && p[2] > 2 * p[0] && p[1] > 90;
}

bool
isWhite(const Pixel& p)
{
  return p == Pixel{255, 255, 255};
}

class MapSnapshot : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!display_.exists())
      GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
    view_.width = 400;
    view_.height = 300;
  }

  ShownPicture
  shoot()
  {
    saveMapSnapshot(path_, map_, view_);
    return ShownPicture(path_);
  }

  const VirtualDisplay& display_ = VirtualDisplay::shared();
  TemporaryFolder folder_;
  std::string path_ = folder_.path("out.png");
  CompactMap map_ = makeRoomMap();
  MapView view_;
};

TEST_F(MapSnapshot, OutsideOneSeesIntoTheRoomThroughItsWallsAndCeiling)
{
  const ShownPicture picture = shoot();
  EXPECT_LT(picture.share(isCyan), 0.001) << "the ceiling looks down";
  const double walls[] = {picture.share(isRed),
                          picture.share(isGreen),
                          picture.share(isBlue),
                          picture.share(isYellow)};
  EXPECT_EQ(std::count_if(walls, walls + 4, [](double s) { return s > 0.01; }), 2)
      << "the two far walls are seen, the two near ones look away";
  EXPECT_GT(picture.covered(), 0.25);
}

/** \brief Checks positions in a picture of the wall at +z, seen from the centre. */
TEST_F(MapSnapshot, TexturesStandUprightAndAreNotMirrored)
{
  view_.place = Place::Inside;
  view_.from = Eigen::Vector3f(0, 0, -1.9F);
  view_.look = Eigen::Vector3f(0, 0, 2);
  const ShownPicture picture = shoot();
  const auto [x, y] = picture.middle(isWhite);
  EXPECT_LT(x, 0.5);
  EXPECT_LT(y, 0.5);
  // the same red as in the chart: no lighting changes colours
  const auto is_exact = [](const Pixel& p) {
    return std::abs(p[0] - 230) < 2 && std::abs(p[1] - 40) < 2 && p[2] == p[1];
  };
  EXPECT_GT(picture.share(is_exact), 0.01);
  EXPECT_GT(picture.middle(isCyan)[1], 0);
  EXPECT_LT(picture.middle(isCyan)[1], 0.3) << "the ceiling is above";
}

TEST_F(MapSnapshot, DoorsAndWindowsAreOpen)
{
  view_.place = Place::Inside;
  view_.from = Eigen::Vector3f(0, 0, -1.9F);
  view_.look = Eigen::Vector3f(0, 0, 2);
  const double with_door = shoot().share(isRed);
  auto& outer = map_.planes[0].polygons[0].outer;
  outer.erase(outer.begin() + 2, outer.begin() + 6);
  EXPECT_GT(shoot().share(isRed), 1.1 * with_door);

  view_.from = Eigen::Vector3f(2, 0, 0);
  view_.look = Eigen::Vector3f(-3, 0, 0);
  const auto is_wall = [](const Pixel& p) { return isYellow(p) || isWhite(p); };
  const double with_window = shoot().share(is_wall);
  map_.planes[3].polygons[0].holes.clear();
  EXPECT_GT(shoot().share(is_wall), 1.1 * with_window);
}

TEST_F(MapSnapshot, UnseenTexelsAndPlanesWithoutAChartAreGrey)
{
  view_.place = Place::Inside;
  view_.from = Eigen::Vector3f(0, 0, -1.9F);
  view_.look = Eigen::Vector3f(0, 0, 2);
  TextureChart& chart = map_.charts[0];
  chart.kinds.assign(chart.colors.values.size() / 3, TexelKind::Seen);
  const auto is_unknown = [](const Pixel& p) { return p == Pixel{128, 128, 128}; };
  const ShownPicture seen = shoot();
  EXPECT_GT(seen.share(isRed), 0.05);
  EXPECT_LT(seen.share(is_unknown), 0.001);
  chart.kinds.assign(chart.kinds.size(), TexelKind::None);
  const ShownPicture unseen = shoot();
  EXPECT_EQ(unseen.share(isRed), 0);
  EXPECT_GT(unseen.share(is_unknown), 0.05) << "the grey of the files of a map";
  chart.kinds.clear();
  chart.colors.values.clear();
  const ShownPicture bare = shoot();
  EXPECT_EQ(bare.share(isRed), 0);
  const Pixel middle = bare.pixels[bare.pixels.size() / 2 + 200];
  EXPECT_EQ(middle[0], middle[1]);
}

TEST_F(MapSnapshot, InsideLooksAlongTheRoom)
{
  view_.place = Place::Inside;
  const ShownPicture middle = shoot();
  EXPECT_GT(middle.share(isCyan), 0.05) << "ceiling";
  EXPECT_GT(middle.share(isGreen) + middle.share(isYellow), 0.02) << "a far wall";
  EXPECT_GT(middle.share(isRed), 0.05);
  EXPECT_GT(middle.share(isBlue), 0.05);
  map_.trajectory = makeRoomWay();
  const ShownPicture from_pose = shoot();
  EXPECT_GT(from_pose.share(isRed) + from_pose.share(isBlue),
            middle.share(isRed) + middle.share(isBlue))
      << "from one end more of the long walls is seen";
}

TEST_F(MapSnapshot, PlanShowsFloorWallsWayAndScale)
{
  view_.place = Place::Plan;
  const ShownPicture picture = shoot();
  EXPECT_EQ(picture.share(isCyan), 0);
  const auto is_light = [](const Pixel& p) { return p[0] == 220 && p[2] == 220; };
  const auto is_dark = [](const Pixel& p) { return p[0] == 110 && p[2] == 110; };
  EXPECT_LT(picture.middle(is_light)[0], picture.middle(is_dark)[0])
      << "x to the right";
  EXPECT_EQ(picture.share(isRed), 0);
  // 6 x 4 m in a picture of 4.6 m height and 300 pixels
  const auto is_floor = [](const Pixel& p) {
    return p[0] == p[1] && p[1] == p[2] && p[0] < 225 && p[0] > 60;
  };
  EXPECT_NEAR(picture.share(is_floor), 6 * 4 / (5.175 * 5.175 * 4 / 3), 0.05);
  map_.trajectory = makeRoomWay();
  const auto is_way = [](const Pixel& p) { return p[0] > 200 && p[1] < 60; };
  EXPECT_EQ(picture.share(is_way), 0);
  EXPECT_GT(shoot().share(is_way), 0.002);
}

TEST_F(MapSnapshot, PaintsDiffer)
{
  const ShownPicture textured = shoot();
  view_.paint = Paint::PlaneColors;
  const ShownPicture colors = shoot();
  view_.paint = Paint::Outlines;
  const ShownPicture outlines = shoot();
  EXPECT_NEAR(colors.covered(), textured.covered(), 0.02);
  EXPECT_GT(outlines.covered(), 0.005);
  EXPECT_LT(outlines.covered(), 0.2 * colors.covered());
  EXPECT_NE(colors.pixels, textured.pixels);
}

TEST_F(MapSnapshot, IsDrawnAlikeWithZUp)
{
  view_.place = Place::Plan;
  const double before = shoot().covered();
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(static_cast<float>(-M_PI / 2), Eigen::Vector3f::UnitX())
          .toRotationMatrix();
  for (PlanePatch& plane : map_.planes) {
    plane.coefficients.head<3>() = turn.cast<double>() * plane.coefficients.head<3>();
    for (PlanePolygon& polygon : plane.polygons) {
      for (Eigen::Vector3f& point : polygon.outer)
        point = turn * point;
      for (auto& hole : polygon.holes)
        for (Eigen::Vector3f& point : hole)
          point = turn * point;
    }
  }
  map_.charts.clear();
  const ShownPicture turned = shoot();
  EXPECT_NEAR(turned.covered(), before, 0.02);
}

TEST_F(MapSnapshot, RefusesMapsThatMakeNoSense)
{
  const auto refuses = [&](auto&& spoil) {
    CompactMap bad = makeRoomMap();
    spoil(bad.charts[0]);
    EXPECT_THROW(saveMapSnapshot(path_, bad, view_), BadArgumentException);
  };
  refuses([](TextureChart& chart) { chart.plane = 6; });
  refuses([](TextureChart& chart) { chart.polygon = 1; });
  refuses([](TextureChart& chart) { chart.colors.values.pop_back(); });
  refuses([](TextureChart& chart) { chart.colors.width = -1; });
  refuses([](TextureChart& chart) { chart.kinds.resize(3); });
  refuses([](TextureChart& chart) { chart.texel_u.setZero(); });
  refuses([](TextureChart& chart) { chart.texel_u[0] = NAN; });
  refuses([](TextureChart& chart) { chart.texel_u *= 1e-7; });
  refuses([](TextureChart& chart) { chart.texel_v = (1 + 1e-5) * chart.texel_u; });
  view_.up = Eigen::Vector3f::Zero();
  EXPECT_THROW(saveMapSnapshot(path_, map_, view_), BadArgumentException);
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(MapSnapshot, SaysWhenThereIsNothingToShow)
{
  EXPECT_THROW(saveMapSnapshot(path_, {}, view_), InitFailedException);
  for (PlanePatch& plane : map_.planes)
    plane.polygons[0].outer.resize(2);
  map_.charts.clear();
  EXPECT_THROW(saveMapSnapshot(path_, map_, view_), InitFailedException);
}

TEST_F(MapSnapshot, SurvivesUglyPlanes)
{
  map_.planes[1].coefficients.setZero();
  map_.planes[2].coefficients.setConstant(NAN);
  map_.planes[3].polygons[0].outer[0].setConstant(INFINITY);
  map_.planes.emplace_back();
  map_.trajectory.poses.resize(3, Eigen::Isometry3d::Identity());
  map_.trajectory.poses[1].matrix().setConstant(NAN);
  for (const Place place : {Place::Outside, Place::Inside, Place::Plan}) {
    view_.place = place;
    EXPECT_GT(shoot().covered(), 0.1);
  }
}

TEST_F(MapSnapshot, TwoPicturesAreEqual)
{
  saveMapSnapshot(path_, map_, view_);
  const std::string first = contentOf(path_);
  saveMapSnapshot(path_, map_, view_);
  EXPECT_EQ(contentOf(path_), first);
}

/** In a plan, walls are lines: even if the first camera of a map was tilted, the plan
 * must not show their faces. */
TEST_F(MapSnapshot, ThePlanOfATiltedMapIsThatOfALevelOne)
{
  view_.place = Place::Plan;
  view_.paint = Paint::PlaneColors;
  const ShownPicture level = shoot();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
  map_.charts.clear();
  for (PlanePatch& plane : map_.planes) {
    plane.coefficients.head<3>() = turn * plane.coefficients.head<3>().eval();
    for (PlanePolygon& polygon : plane.polygons) {
      for (Eigen::Vector3f& point : polygon.outer)
        point = turn.cast<float>() * point;
      for (auto& hole : polygon.holes)
        for (Eigen::Vector3f& point : hole)
          point = turn.cast<float>() * point;
    }
  }
  const ShownPicture tilted = shoot();
  std::size_t different = 0;
  for (std::size_t i = 0; i < level.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      different += std::abs(level.pixels[i][k] - tilted.pixels[i][k]) > 20;
  EXPECT_LT(different, level.pixels.size() / 50);
}

} // namespace
} // namespace pcl::acmap::test

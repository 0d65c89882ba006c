#include "painted_maps.h"

#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

std::string
remarkOf(const TexturingReport& report)
{
  EXPECT_EQ(report.remarks.size(), 1u);
  return report.remarks.empty() ? "" : report.remarks.front();
}

/** Where the floor is grazed, the nearest points are of several squares. */
void
expectSquaresOfPoints(const CompactMap& map)
{
  const ComparedSquares compared = compareSquares(map, 0);
  EXPECT_GT(compared.texels, 1000u);
  EXPECT_LT(compared.wrong, 3 * compared.texels / 10); // of the channels
}

TEST(PlaneTexturingUgly, PointsAloneColourTheTexelsTheyAreIn)
{
  const View cloud = scattered(lookAt(wallAndFloor()));
  Texturing texturing = texturingOf(planesOfWallAndFloor(), {cloud});
  texturing.setFillDistance(0);
  CompactMap map;
  texturing.texture(map);
  EXPECT_EQ(texturing.getReport().splatted, 1u);
  EXPECT_EQ(texturing.getReport().pinholes, 0u);
  expectSquaresOfPoints(map);
}

TEST(PlaneTexturingUgly, FewPointsGiveTheirMeanToTheTexelsAroundThem)
{
  View cloud;
  cloud.cloud.reset(new PointCloud<PointXYZRGB>);
  cloud.cloud->push_back(PointXYZRGB(0.005F, 0.005F, 3, 10, 100, 200));
  cloud.cloud->push_back(PointXYZRGB(0.015F, 0.015F, 3, 21, 103, 0));
  cloud.cloud->push_back(PointXYZRGB(0.005F, 0.005F, 2.6F, 255, 255, 255)); // too far
  Texturing texturing = texturingOf(planesOfWallAndFloor(), {cloud});
  texturing.setFillDistance(0);
  const CompactMap map = painted(texturing);
  ASSERT_EQ(countOf(map, TexelKind::Seen), 25u);
  forTexels(
      map, TexelKind::Seen, [](const auto&, const auto* color, const auto& place) {
        EXPECT_EQ(color[0], 16);
        EXPECT_EQ(color[1], 102);
        EXPECT_EQ(color[2], 100);
        EXPECT_LT((place - Eigen::Vector3d(0.01, 0.01, 3)).norm(), 0.06);
      });
  texturing.setMaximumDistance(0.5);
  forTexels(
      painted(texturing),
      TexelKind::Seen,
      [](const auto&, const auto* color, const auto&) { EXPECT_EQ(color[0], 95); });
}

TEST(PlaneTexturingUgly, CloudsWithoutColourLeaveAllGrey)
{
  const View view = lookAt(wallAndFloor());
  PlaneTexturing<PointXYZ> texturing;
  const PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
  for (const PointXYZRGB& point : *view.cloud)
    cloud->push_back(PointXYZ(point.x, point.y, point.z));
  texturing.setPlanes(planesOfWallAndFloor());
  texturing.addObservation(cloud);
  CompactMap map;
  texturing.texture(map);
  EXPECT_EQ(texturing.getReport().colorless, 1u);
  EXPECT_EQ(texturing.getReport().seen, 0u);
  EXPECT_THAT(remarkOf(texturing.getReport()), HasSubstr("no observation has colour"));
  for (const TextureChart& chart : map.charts)
    for (const std::uint8_t value : chart.colors.values)
      ASSERT_EQ(value, 128);
}

TEST(PlaneTexturingUgly, LoadersMayLeaveObservationsOut)
{
  const View view = lookAt(wallAndFloor());
  const auto cloud = std::make_shared<PCLPointCloud2>();
  toPCLPointCloud2(*view.cloud, *cloud);
  const auto load = [&](bool has_sensor) {
    return [&, has_sensor]() -> std::optional<TexturedObservation> {
      return TexturedObservation{cloud, view.T_map_camera, 7, has_sensor};
    };
  };
  Texturing texturing = texturingOf(planesOfWallAndFloor(), {});
  EXPECT_THROW(texturing.addObservationLoader({}), BadArgumentException);
  texturing.addObservationLoader([] { return std::optional<TexturedObservation>(); });
  texturing.addObservationLoader(load(true));
  const CompactMap loaded = painted(texturing);
  expectSame(loaded, painted(texturingOf(planesOfWallAndFloor(), {view})));
  EXPECT_EQ(loaded.trajectory.stamps, std::vector<double>{7});
  texturing.clearObservations();
  texturing.addObservationLoader(load(false));
  const CompactMap unposed = painted(texturing);
  EXPECT_TRUE(unposed.trajectory.poses.empty());
  EXPECT_GT(countOf(unposed, TexelKind::Seen), 0u);
  cloud->fields.clear();
  EXPECT_THROW(painted(texturing), InitFailedException);
}

TEST(PlaneTexturingUgly, WithoutObservationsOrPlanes)
{
  EXPECT_THAT(remarkOf(reportOf(texturingOf(planesOfWallAndFloor(), {}))),
              HasSubstr("no observation was given"));
  const View view = lookAt(wallAndFloor());
  Texturing none = texturingOf({}, {view});
  EXPECT_THAT(remarkOf(reportOf(none)), HasSubstr("nothing to paint"));
  EXPECT_TRUE(painted(none).charts.empty());
  EXPECT_THAT(remarkOf(reportOf(texturingOf({PlanePatch()}, {view}))),
              HasSubstr("nothing to paint"));
  Texturing unset;
  unset.addObservation(view.cloud);
  CompactMap map;
  map.planes.resize(7);
  EXPECT_THROW(unset.texture(map), InitFailedException);
  EXPECT_EQ(map.planes.size(), 7u);
}

TEST(PlaneTexturingUgly, PolygonsOfNoUseAreLeftOutAndTold)
{
  using Corners = std::vector<Eigen::Vector3f>;
  const View view = lookAt(wallAndFloor());
  const std::vector<Corners> ugly = {
      {},
      {{0, 0, 3}, {1, 0, 3}},
      {{0, 0, 3}, {1, 1, 3}, {2, 2, 3}, {0.5F, 0.5F, 3}},
      {{0, 0, 3}, {0, 0, 3}, {0, 0, 3}},
      {{0, 0, 3}, {1, 0, 3}, {1, nan, 3}, {0, 1, 3}},
      {{nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}},
      {{0, 0, 3}, {1, 0, 3}, {1, infinity, 3}}};
  for (std::size_t i = 0; i < ugly.size(); ++i) {
    auto planes = planesOfWallAndFloor();
    planes.push_back(planes[0]);
    planes[2].polygons[0].outer = ugly[i];
    Texturing texturing = texturingOf(planes, {view});
    CompactMap map;
    texturing.texture(map);
    EXPECT_EQ(map.charts.size(), 2u) << i;
    EXPECT_THAT(remarkOf(texturing.getReport()), HasSubstr("left out: 1")) << i;
    EXPECT_GT(expectSquares(map, 3), 1000u);
  }
}

TEST(PlaneTexturingUgly, PlanesOfNoUseAreLeftOutAndTold)
{
  const View view = lookAt(wallAndFloor());
  for (const auto& [coefficient, value] :
       {std::pair(0, double(nan)), {3, double(infinity)}, {2, 5.0}, {2, 0.0}}) {
    auto planes = planesOfWallAndFloor();
    planes.push_back(planes[0]);
    planes[2].coefficients[coefficient] = value;
    EXPECT_THAT(remarkOf(reportOf(texturingOf(planes, {view}))),
                HasSubstr("left out: 1"));
  }
}

TEST(PlaneTexturingUgly, TheAxesAndTheMiddleOfAPlaneNeedNotBeSet)
{
  auto planes = planesOfWallAndFloor();
  for (PlanePatch& plane : planes) {
    plane.axis_u = plane.coefficients.head<3>(); // not an axis in the plane
    plane.axis_v.setZero();
    plane.center.setZero();
  }
  const CompactMap map = painted(texturingOf(planes, {lookAt(wallAndFloor())}));
  ASSERT_EQ(map.charts.size(), 2u);
  EXPECT_NEAR(map.charts[0].origin.z(), 3, 1e-9);
  EXPECT_GT(expectSquares(map, 3), 1000u);
}

TEST(PlaneTexturingUgly, HugePolygonsAreRefusedAtOnce)
{
  for (const float width : {1e4F, 1e6F, 1e9F, 1e30F})
    for (const float height : {1e3F, width}) { // at least ten square kilometres
      const PlanePatch plane =
          makePlane({0, 0, -1}, {{0, 0, 3}, {0, height, 3}, {width, height, 3}});
      Texturing texturing = texturingOf({plane}, {});
      CompactMap map;
      EXPECT_THROW(texturing.texture(map), BadArgumentException) << width;
      EXPECT_TRUE(map.planes.empty());
    }
}

TEST(PlaneTexturingUgly, PosesThatAreNoMotionAreRefused)
{
  Texturing texturing;
  const View view = lookAt(wallAndFloor());
  EXPECT_THROW(texturing.addObservation(nullptr), BadArgumentException);
  const auto expectRefused = [&](const std::function<void(Eigen::Matrix4d&)>& change) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    change(pose.matrix());
    EXPECT_THROW(texturing.addObservation(view.cloud, pose), BadArgumentException);
  };
  expectRefused([](auto& pose) { pose(0, 3) = nan; });
  expectRefused([](auto& pose) { pose(2, 3) = infinity; });
  expectRefused([](auto& pose) { pose(1, 1) = nan; });
  expectRefused([](auto& pose) { pose(0, 0) = 2; });
  expectRefused([](auto& pose) { pose(0, 0) = -1; });
  EXPECT_EQ(texturing.getNumberOfObservations(), 0u);
}

TEST(PlaneTexturingUgly, PointsThatAreNoneSayNothing)
{
  const auto planes = planesOfWallAndFloor();
  View view = lookAt(wallAndFloor());
  const CompactMap clean = painted(texturingOf(planes, {view}));
  std::size_t invalid = reportOf(texturingOf(planes, {view})).invalid_points;
  for (std::size_t i = 0; i < view.cloud->size(); i += 97) {
    invalid += std::isfinite(view.cloud->at(i).x) ? 1 : 0;
    view.cloud->at(i).x = i % 2 ? nan : infinity;
  }
  Texturing texturing = texturingOf(planes, {view});
  CompactMap map;
  texturing.texture(map);
  EXPECT_EQ(texturing.getReport().invalid_points, invalid);
  EXPECT_EQ(countOf(map, TexelKind::Seen), countOf(clean, TexelKind::Seen));
  expectSquares(map, 3);
}

TEST(PlaneTexturingUgly, CloudsOfNoUseLeaveTheOthersAlone)
{
  const auto planes = planesOfWallAndFloor();
  const View good = lookAt(wallAndFloor());
  const CompactMap wanted = painted(texturingOf(planes, {good}));
  std::vector<View> ugly(5);
  ugly[0].cloud.reset(new PointCloud<PointXYZRGB>);
  ugly[1].cloud.reset(
      new PointCloud<PointXYZRGB>(1, 1, PointXYZRGB(nan, nan, nan, 9, 9, 9)));
  ugly[2].cloud.reset(
      new PointCloud<PointXYZRGB>(240, 180, PointXYZRGB(nan, nan, nan, 9, 9, 9)));
  ugly[3].cloud.reset(
      new PointCloud<PointXYZRGB>(20, 20, PointXYZRGB(1e30F, -1e30F, 1e30F, 9, 9, 9)));
  ugly[4].cloud.reset(
      new PointCloud<PointXYZRGB>(20, 20, PointXYZRGB(0, 0, -4, 9, 9, 9)));
  for (const View& bad : ugly) {
    const CompactMap map = painted(texturingOf(planes, {good, bad}));
    EXPECT_EQ(map.charts[0].colors.values, wanted.charts[0].colors.values);
    EXPECT_EQ(map.observations[0], (std::vector<std::int32_t>{0}));
    EXPECT_THAT(remarkOf(reportOf(texturingOf(planes, {bad}))),
                HasSubstr("no observation saw a plane"));
  }
}

TEST(PlaneTexturingUgly, RowsThatDoNotFitAreRefusedAndALineIsNoImage)
{
  const auto planes = planesOfWallAndFloor();
  View view = lookAt(wallAndFloor());
  for (const auto& [width, height] : {std::pair(241U, 179U), {7U, 2U}}) {
    view.cloud->width = width;
    view.cloud->height = height;
    EXPECT_THROW(texturingOf(planes, {view}), BadArgumentException);
  }
  view.cloud->width = 1;
  view.cloud->height = 43200;
  Texturing texturing = texturingOf(planes, {view});
  CompactMap map;
  texturing.texture(map);
  EXPECT_EQ(texturing.getReport().splatted, 1u);
  expectSquaresOfPoints(map);
}

TEST(PlaneTexturingUgly, OnePixelColoursTheTexelsAroundIt)
{
  View view;
  view.cloud.reset(
      new PointCloud<PointXYZRGB>(1, 1, PointXYZRGB(0.01F, 0.01F, 3, 1, 2, 3)));
  const TexturingReport report = reportOf(texturingOf(planesOfWallAndFloor(), {view}));
  EXPECT_EQ(report.seen, 25u);
}

TEST(PlaneTexturingUgly, TexelsAreEnlargedWhereThereWouldBeTooMany)
{
  Texturing texturing = texturingOf(planesOfWallAndFloor(), {});
  texturing.setTexelSize(0.1);
  EXPECT_EQ(reportOf(texturing).texel_size, 0.1);
  double texels = 0;
  for (const TextureChart& chart : painted(texturing).charts)
    texels += static_cast<double>(chart.colors.width) * chart.colors.height;
  const double bytes = texturing.estimateMemory() / texels;
  constexpr double most = 3 << 24;
  const double smallest = 0.1 * std::sqrt(texels / most);
  texturing.setTexelSize(smallest / 5);
  EXPECT_LT(texturing.estimateMemory(), bytes * most);
  EXPECT_GT(texturing.estimateMemory(), 0.9 * bytes * most);
}

TEST(PlaneTexturingUgly, HugeTexelsAtTheCameraAreNoMatter)
{
  const View view = lookAt(wallAndFloor(), {{0, 0, 2.9}});
  Texturing texturing = texturingOf(planesOfWallAndFloor(), {view});
  for (const double size : {0.5, 10.0}) {
    texturing.setTexelSize(size);
    EXPECT_EQ(reportOf(texturing).charts, 2u);
  }
}

} // namespace
} // namespace pcl::acmap::test

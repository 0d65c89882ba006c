#include "naive_point_texture.h"
#include "painted_maps.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

/** Points at random in the room of wall and floor, some of them without coordinates. */
View
scatter(std::size_t points, std::uint64_t seed)
{
  Random random(seed);
  View view;
  view.T_map_camera.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
  view.cloud.reset(new PointCloud<PointXYZRGB>);
  const auto channel = [&] {
    return static_cast<std::uint8_t>(random.uniform(0, 255.99));
  };
  for (std::size_t i = 0; i < points; ++i) {
    const std::uint8_t red = channel(), green = channel(), blue = channel();
    PointXYZRGB point(0, 0, 0, red, green, blue);
    point.x = static_cast<float>(random.uniform(-2, 2));
    point.y = static_cast<float>(random.uniform(-1.6, 1.4));
    point.z = static_cast<float>(random.uniform(0.3, 3.5));
    if (i % 50 == 0)
      point.z = std::numeric_limits<float>::quiet_NaN();
    view.cloud->push_back(point);
  }
  return view;
}

/** Wall with a window, floor, and a board 25 cm in front of the wall that faces it. */
std::vector<PlanePatch>
makeRoomPlanes()
{
  std::vector<PlanePatch> planes = planesOfWallAndFloor();
  planes[0].polygons[0].holes = {
      {{-0.5F, -0.5F, 3}, {0.5F, -0.5F, 3}, {0.5F, 0.5F, 3}, {-0.5F, 0.5F, 3}}};
  planes.push_back(
      makePlane({0, 0, 1}, {{-1, -1, 2.75F}, {1, -1, 2.75F}, {0, 1, 2.75F}}));
  return planes;
}

void
compareWithNaive(Texturing texturing, const std::vector<View>& views)
{
  texturing.setPaperMode(true);
  CompactMap map;
  texturing.texture(map);
  const NaivePointTexture wanted =
      textureNaively(map, views, texturing.getMaximumDistance());
  std::size_t seen = 0;
  for (std::size_t c = 0; c < map.charts.size(); ++c)
    for (std::size_t t = 0; t < wanted.charts[c].size(); ++t) {
      const NaiveTexel& texel = wanted.charts[c][t];
      const bool is_seen = map.charts[c].kinds[t] == TexelKind::Seen;
      ASSERT_EQ(is_seen, texel.points > 0) << "chart " << c << ", texel " << t;
      seen += is_seen ? 1 : 0;
      for (std::size_t k = 0; k < 3 && is_seen; ++k)
        ASSERT_NEAR(map.charts[c].colors.values[3 * t + k], texel.mean[k], 0.5 + 1e-9);
    }
  const TexturingReport& report = texturing.getReport();
  EXPECT_EQ(report.seen, seen);
  EXPECT_EQ(report.filled, 0U);
  EXPECT_EQ(report.colored_points, wanted.colored_points);
  EXPECT_EQ(report.far_points, wanted.far_points);
  EXPECT_GT(report.colored_points, 0U);
  EXPECT_EQ(report.splatted, views.size());
  EXPECT_EQ(report.pinholes, 0U);
  EXPECT_EQ(report.gains, std::vector<double>(views.size(), 1));
}

TEST(PointTexture, isTheNaiveOne)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<View> views = {scatter(6000, seed), scatter(6000, seed + 9)};
    for (const double distance : {0.05, 0.3}) {
      Texturing texturing = texturingOf(makeRoomPlanes(), views);
      texturing.setTexelSize(0.05);
      texturing.setMaximumDistance(distance);
      compareWithNaive(texturing, views);
    }
  }
}

/** Views that are pictures are their points, too. */
TEST(PointTexture, isTheNaiveOneForPictures)
{
  const auto screens = wallAndFloor();
  const std::vector<View> views = {lookAt(screens, {{0, 0, 0.3}}),
                                   lookAt(screens, {{0.5, 0, 0.6}, -0.15, 0, 0.7}),
                                   lookAt(screens, {{-0.4, -0.5, 0.4}, 0.1, -0.6})};
  compareWithNaive(texturingOf(makeRoomPlanes(), views), views);
}

PointCloud<PointXYZRGB>::Ptr
cloudOf(const std::vector<PointXYZRGB>& points)
{
  PointCloud<PointXYZRGB>::Ptr cloud(new PointCloud<PointXYZRGB>);
  for (const PointXYZRGB& point : points)
    cloud->push_back(point);
  return cloud;
}

/** Five views of a texel, of which only four samples could be kept, and one point that
 * disagrees with all others. */
TEST(PointTexture, isTheMeanOfThePointsOfAllViews)
{
  std::vector<View> views(5);
  for (View& view : views)
    view.cloud = cloudOf({PointXYZRGB(0.01F, 0.01F, 3, 100, 0, 0)});
  views[4].cloud = cloudOf({PointXYZRGB(0.01F, 0.01F, 3, 200, 0, 0),
                            PointXYZRGB(0.01F, 0.01F, 3.2F, 200, 0, 0)}); // behind
  Texturing texturing = texturingOf(planesOfWallAndFloor(), views);
  texturing.setPaperMode(true);
  const CompactMap map = painted(texturing);
  ASSERT_EQ(countOf(map, TexelKind::Seen), 1U);
  forTexels(map, TexelKind::Seen, [](const auto&, const auto* color, const auto&) {
    EXPECT_EQ(color[0], 133);
  });
  EXPECT_EQ(map.observations[0], (std::vector<std::int32_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(map.observations[1].empty());
}

TEST(PointTexture, isOfPointsNearerThanThirtyCentimetres)
{
  View view;
  view.cloud = cloudOf({PointXYZRGB(0.01F, 0.01F, 2.71F, 9, 9, 9),
                        PointXYZRGB(0.51F, 0.01F, 2.69F, 9, 9, 9),
                        PointXYZRGB(9, 0, 3, 9, 9, 9)});
  Texturing texturing = texturingOf(planesOfWallAndFloor(), {view});
  texturing.setPaperMode(true);
  const TexturingReport report = reportOf(texturing);
  EXPECT_EQ(report.colored_points, 1U);
  EXPECT_EQ(report.far_points, 2U);
  EXPECT_EQ(report.seen, 1U);
}

TEST(PointTexture, countsThePointsOfOurModeToo)
{
  const View view = lookAt(wallAndFloor());
  const TexturingReport report = reportOf(texturingOf(planesOfWallAndFloor(), {view}));
  EXPECT_EQ(report.colored_points + report.far_points + report.invalid_points,
            view.cloud->size());
  EXPECT_GT(report.colored_points, view.cloud->size() / 4);
}

TEST(PointTexture, hasSameBytesForAnyThreads)
{
  const std::vector<View> views = {scatter(20000, 1), lookAt(wallAndFloor())};
  Texturing texturing = texturingOf(makeRoomPlanes(), views);
  texturing.setPaperMode(true);
  texturing.setNumberOfThreads(1);
  const CompactMap once = painted(texturing);
  for (const unsigned threads : {2U, 8U}) {
    texturing.setNumberOfThreads(threads);
    expectSame(painted(texturing), once);
  }
}

} // namespace
} // namespace pcl::acmap::test

#include "outlines/crease_nodes.h"
#include "outlines/sightings.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <random>

namespace pcl::acmap::test {
namespace {

using outlines::Crease;
using outlines::CreaseNodes;
using outlines::Creases;
using outlines::PlaneRaster;

constexpr double cell = 0.02; // metres

/** The plane z = 0, seen from z > 0. */
PlaneRaster
makeRaster()
{
  PlaneRaster raster;
  raster.cell = cell;
  raster.seen = raster.free = raster.barrier = outlines::CellSet(200, 100);
  return raster;
}

/** Rays from a sensor to places of a rectangle of a plane, with points off along them. */
struct Rays {
  std::vector<Eigen::Vector3f> points;
  PointLabels labels;
  Eigen::Vector3f sensor{-1, 1, 0.4F}; // it grazes the plane

  /** \param[in] box cells
   * \param[in] height metres, of the surface above the plane
   * \param[in] noise metres, along the rays */
  void
  add(const Eigen::AlignedBox2d& box, double height, double noise)
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share;
    std::normal_distribution<double> normal;
    for (int i = 0; i < 12 * box.volume(); ++i) {
      const Eigen::Vector2d place =
          box.min() +
          Eigen::Vector2d(share(random), share(random)).cwiseProduct(box.sizes());
      const Eigen::Vector3d from = sensor.cast<double>();
      const Eigen::Vector3d at(cell * place.x(), cell * place.y(), height);
      const Eigen::Vector3d way = (at - from).normalized();
      points.push_back((at + noise * normal(random) * way).cast<float>());
      labels.push_back(0);
    }
  }

  LabeledSource
  source() const
  {
    return {PointView(points.data(), sizeof points[0], points.size()),
            SensorView(sensor),
            labels};
  }
};

const Eigen::AlignedBox2d surface(Eigen::Vector2d(20.4, 30.3),
                                  Eigen::Vector2d(150.7, 70.6));

/** Faces of the surface that begin too late, and go on for too long. */
PlaneRaster
makeBlurred()
{
  PlaneRaster raster = makeRaster();
  for (int y = 33; y < 68; ++y)
    raster.seen.addRun(y, 23, 153);
  return raster;
}

Creases
noCreases()
{
  Creases creases;
  creases.of_planes.resize(1);
  return creases;
}

TEST(Sightings, rimsAreWhereTheRaysEnd)
{
  Rays rays;
  rays.add(surface, 0, 0.03); // along the plane: more than a cell
  std::vector<PlaneRaster> rasters{makeBlurred()};
  ASSERT_TRUE(sharpenRims(rays.source(), noCreases(), rasters));
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x) {
      const Eigen::AlignedBox2d box(Eigen::Vector2d(x, y),
                                    Eigen::Vector2d(x + 1, y + 1));
      if (surface.contains(box) || !surface.intersects(box)) {
        EXPECT_EQ(rasters[0].seen.has(x, y), surface.contains(box)) << x << ' ' << y;
      }
    }
  ASSERT_FALSE(rasters[0].rim_points.empty());
  Eigen::AlignedBox2d extent;
  for (const Eigen::Vector2d& place : rasters[0].rim_points)
    extent.extend(place);
  EXPECT_LT((extent.min() - surface.min()).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_LT((extent.max() - surface.max()).cwiseAbs().maxCoeff(), 0.1);
}

/** Points of another surface that is near the plane beside its end. */
TEST(Sightings, pointsOnOneSideOfAPlaneDoNotEnlargeIt)
{
  Rays rays;
  rays.add(surface, 0, 0.03);
  std::vector<PlaneRaster> alone{makeBlurred()};
  ASSERT_TRUE(sharpenRims(rays.source(), noCreases(), alone));
  rays.add({Eigen::Vector2d(60, 71), Eigen::Vector2d(120, 80)}, 0.02, 0.03);
  std::vector<PlaneRaster> both{makeBlurred()};
  ASSERT_TRUE(sharpenRims(rays.source(), noCreases(), both));
  std::size_t more = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x)
      more += both[0].seen.has(x, y) && !alone[0].seen.has(x, y) ? 1 : 0;
  EXPECT_LE(more, 3U);
}

TEST(Sightings, whatSensorsLookedThroughIsNotAdded)
{
  Rays rays;
  rays.add(surface, 0, 0.03);
  std::vector<PlaneRaster> rasters{makeBlurred()};
  for (int y = 0; y < 33; ++y)
    rasters[0].free.addRun(y, 0, 200);
  ASSERT_TRUE(sharpenRims(rays.source(), noCreases(), rasters));
  for (int x = 0; x < 200; ++x)
    EXPECT_FALSE(rasters[0].seen.has(x, 32)) << x;
  EXPECT_TRUE(rasters[0].seen.has(80, 33));
}

TEST(Sightings, unknownSensorsAndFewRaysChangeNothing)
{
  Rays rays;
  rays.add(surface, 0, 0.03);
  LabeledSource source = rays.source();
  source.sensors = SensorView();
  std::vector<PlaneRaster> rasters{makeBlurred()};
  EXPECT_FALSE(sharpenRims(source, noCreases(), rasters));
  const PointLabels none;
  EXPECT_FALSE(
      sharpenRims({PointView(), SensorView(rays.sensor), none}, noCreases(), rasters));
  rays.points.resize(100);
  rays.labels.resize(100);
  sharpenRims(rays.source(), noCreases(), rasters);
  const PlaneRaster before = makeBlurred();
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x)
      EXPECT_EQ(rasters[0].seen.has(x, y), before.seen.has(x, y));
}

TEST(Sightings, areTheSameForEveryNumberOfThreads)
{
  Rays rays;
  rays.add(surface, 0, 0.03);
  std::vector<PlaneRaster> expected;
  for (const std::size_t threads : {1, 2, 8}) {
    const oneapi::tbb::global_control control(
        oneapi::tbb::global_control::max_allowed_parallelism, threads);
    std::vector<PlaneRaster> rasters{makeBlurred()};
    sharpenRims(rays.source(), noCreases(), rasters);
    if (expected.empty())
      expected = rasters;
    EXPECT_EQ(rasters[0].rim_points, expected[0].rim_points);
  }
}

/** One crease along x, with ends of rims. */
class CreaseEnds : public testing::Test {
protected:
  CreaseEnds()
  : rasters(2)
  {
    Crease crease;
    crease.planes = {0, 1};
    crease.point = Eigen::Vector3d::Zero();
    crease.direction = Eigen::Vector3d::UnitX();
    creases.creases.push_back(crease);
    creases.of_planes = {{0}, {0}};
  }

  /** Positions of the nodes of two ends, in spacings. */
  std::array<double, 2>
  settled(const outlines::CreasePoint& a, const outlines::CreasePoint& b) const
  {
    CreaseNodes nodes(creases, rasters, spacing);
    for (const outlines::CreasePoint& point : {a, b})
      nodes.add(point);
    nodes.settle();
    return {nodes.position(nodes.find(a)).x() / spacing,
            nodes.position(nodes.find(b)).x() / spacing};
  }

  static constexpr double spacing = 0.04;
  std::vector<PlaneRaster> rasters;
  Creases creases;
};

TEST_F(CreaseEnds, areTheirWeightedMeanWithinTheNoise)
{
  const std::array<double, 2> near =
      settled({0, 0, -1, 1, 3}, {0, 1.6 * spacing, -1, 1, 1});
  EXPECT_NEAR(near[0], 0.4, 1e-9);
  EXPECT_EQ(near[0], near[1]);
  // two oblique rims, which are uncertain along the crease
  const std::array<double, 2> oblique =
      settled({0, 0, -1, 1, 0.25}, {0, 4 * spacing, -1, 1, 0.25});
  EXPECT_NEAR(oblique[0], 2, 1e-9);
  EXPECT_EQ(oblique[0], oblique[1]);
}

TEST_F(CreaseEnds, stayApartIfTheyAreCertainOrAGapIsBetweenThem)
{
  const std::array<double, 2> certain =
      settled({0, 0, -1, 1, 50}, {0, 4 * spacing, -1, 1, 50});
  EXPECT_EQ(certain[0], 0);
  EXPECT_NEAR(certain[1], 4, 1e-9);
  const std::array<double, 2> gap =
      settled({0, 0, -1, -1, 0.25}, {0, 4 * spacing, -1, 1, 0.25});
  EXPECT_EQ(gap[0], 0);
  EXPECT_NEAR(gap[1], 4, 1e-9);
}

} // namespace
} // namespace pcl::acmap::test

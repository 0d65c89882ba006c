#include "naive_growth.h"

#include <pcl/core/random.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap::test {
namespace {

/** Creates hypotheses on planes, and random ones. */
class HypothesisMaker {
public:
  explicit HypothesisMaker(std::uint64_t seed)
  : random_(seed)
  {}

  /** Adds random points on a parallelogram, with noise of positions in metres and of
   * normals in radians. */
  void
  addBoard(const Eigen::Vector3d& corner,
           const Eigen::Vector3d& u,
           const Eigen::Vector3d& v,
           std::size_t size,
           double noise,
           double tilt)
  {
    const Eigen::Vector3d normal = u.cross(v).normalized();
    for (std::size_t i = 0; i < size; ++i)
      add(corner + random_.uniform() * u + random_.uniform() * v +
              noise * random_.normal() * normal,
          normal + tilt * randomVector());
  }

  void
  addClutter(double extent, std::size_t size)
  {
    for (std::size_t i = 0; i < size; ++i)
      add(Eigen::Vector3d(random_.uniform(0, extent),
                          random_.uniform(0, extent),
                          random_.uniform(0, extent)),
          randomVector());
  }

  NaiveHypotheses all;

private:
  Eigen::Vector3d
  randomVector()
  {
    const double x = random_.normal(), y = random_.normal();
    return {x, y, random_.normal()};
  }

  void
  add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
  {
    all.points.emplace_back(point.cast<float>().cast<double>());
    all.normals.emplace_back(normal.normalized().cast<float>().cast<double>());
  }

  Random random_;
};

/** The planes of the class' kernel: parameters, and members in ascending order. */
struct Grown {
  std::vector<NaivePlane> planes;
  PlaneClusteringReport report;
};

Grown
growByKernel(const NaiveHypotheses& all,
             const NaiveThresholds& limits,
             const std::vector<float>& curvatures = {},
             const TriangleMesh::Triangles& triangles = {},
             const Progress& progress = Progress())
{
  std::vector<Eigen::Vector3f> points;
  PlaneHypotheses hypotheses;
  for (const Eigen::Vector3d& point : all.points)
    points.emplace_back(point.cast<float>());
  for (const Eigen::Vector3d& normal : all.normals)
    hypotheses.normals.emplace_back(normal.cast<float>());
  hypotheses.points = PointView(points.data(), sizeof(Eigen::Vector3f), points.size());
  hypotheses.curvatures.assign(curvatures.begin(), curvatures.end());
  hypotheses.triangles = triangles;
  hypotheses.is_crease.assign(points.size(), 1); // the paper knows of no creases
  PlaneClusteringSettings settings;
  settings.noise_driven = false;
  settings.member_distance = limits.member_distance;
  settings.reach =
      limits.by_members ? SupporterReach::Members : SupporterReach::Hypothesis;
  settings.normal_angle = limits.angle;
  settings.plane_distance = limits.plane_distance;
  settings.min_support = limits.support;
  Grown grown;
  const PlaneClusters found =
      clusterPlanes(hypotheses, {}, settings, progress, grown.report);
  for (const PlanePatch& patch : found.patches)
    grown.planes.push_back({patch.coefficients.head<3>(), patch.coefficients[3], {}});
  for (std::size_t i = 0; i < found.labels.size(); ++i)
    if (found.labels[i] >= 0)
      grown.planes[static_cast<std::size_t>(found.labels[i])].members.push_back(
          static_cast<std::int32_t>(i));
  return grown;
}

void
expectSame(std::vector<NaivePlane> found, std::vector<NaivePlane> wanted)
{
  ASSERT_EQ(found.size(), wanted.size());
  for (auto* planes : {&found, &wanted}) // patches are sorted by their area
    std::sort(planes->begin(), planes->end(), [](const auto& a, const auto& b) {
      return a.members < b.members;
    });
  for (std::size_t p = 0; p < found.size(); ++p) {
    EXPECT_EQ(found[p].members, wanted[p].members) << "plane " << p;
    EXPECT_LT((found[p].normal - wanted[p].normal).norm(), 1e-6) << "plane " << p;
    EXPECT_NEAR(found[p].offset, wanted[p].offset, 1e-6) << "plane " << p;
  }
}

/** Compares a run of the class with the naive one. \return the number of planes */
std::size_t
compareWithNaive(const NaiveHypotheses& all,
                 const NaiveThresholds& limits,
                 const std::vector<float>& curvatures = {},
                 const TriangleMesh::Triangles& triangles = {})
{
  std::vector<std::int32_t> order(all.points.size());
  std::iota(order.begin(), order.end(), 0);
  if (!curvatures.empty())
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return curvatures[static_cast<std::size_t>(a)] <
             curvatures[static_cast<std::size_t>(b)];
    });
  const NaiveGrowth wanted = growNaively(all, limits, order);
  const Grown found = growByKernel(all, limits, curvatures, triangles);
  expectSame(found.planes, wanted.planes);
  EXPECT_EQ(found.report.hypotheses, all.points.size());
  EXPECT_EQ(found.report.tested_hypotheses, wanted.tested);
  EXPECT_EQ(found.report.reestimations, wanted.reestimations);
  EXPECT_EQ(found.report.merged, 0U);
  return wanted.planes.size();
}

/** Three walls of a room, a shelf, and 10 % clutter. */
NaiveHypotheses
makeRoomHypotheses(std::uint64_t seed)
{
  HypothesisMaker maker(seed);
  maker.addBoard({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 400, 0.02, 0.05);
  maker.addBoard({0, 0.2, 0.2}, {0, 4, 0}, {0, 0, 3}, 300, 0.02, 0.05);
  maker.addBoard({0.2, 0, 0.2}, {0, 0, 3}, {4, 0, 0}, 300, 0.02, 0.05);
  maker.addBoard({2, 2, 1.2}, {1, 0, 0}, {0, 1, 0}, 60, 0.01, 0.05);
  maker.addClutter(4, 120);
  return maker.all;
}

/** Clutter and planes that are as noisy as W_t allows, near each other. */
NaiveHypotheses
makeHardHypotheses(std::uint64_t seed)
{
  HypothesisMaker maker(seed);
  maker.addBoard({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 400, 0.1, 0.2);
  maker.addBoard({0, 0, 0.3}, {2, 0, 0.6}, {0, 2, 0}, 400, 0.1, 0.2);
  maker.addClutter(2, 400);
  return maker.all;
}

std::vector<float>
makeCurvatures(std::size_t size, std::uint64_t seed)
{
  Random random(seed);
  std::vector<float> curvatures;
  while (curvatures.size() < size)
    curvatures.push_back(static_cast<float>(random.uniform()));
  return curvatures;
}

/** Two distant boards; all points of a board are within W_d of each other. */
TEST(PaperGrowth, tellsHowFarItIsAndCanBeStopped)
{
  HypothesisMaker maker(5);
  maker.addBoard({0, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}, 2500, 0.001, 0.01);
  maker.addBoard({9, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}, 2500, 0.001, 0.01);
  std::vector<double> told;
  growByKernel(
      maker.all, {}, {}, {}, Progress([&](double fraction, const std::string& step) {
        if (step == "growing")
          told.push_back(fraction);
        return true;
      }));
  ASSERT_GE(told.size(), 4U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LT(told.front(), 0.4);
  EXPECT_GT(told.back(), 0.5);
  EXPECT_LE(told.back(), 0.85);
  EXPECT_THROW(
      growByKernel(
          maker.all, {}, {}, {}, Progress([](double fraction, const std::string&) {
            return fraction < 0.4;
          })),
      CancelledException);
}

/** Walls are whole, or fall into pieces. */
NaiveThresholds
readingOf(bool by_members)
{
  NaiveThresholds limits;
  limits.by_members = by_members;
  return limits;
}

TEST(PaperGrowth, isTheNaiveOne)
{
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    EXPECT_GE(compareWithNaive(makeRoomHypotheses(seed), readingOf(false)), 8U);
    EXPECT_GE(compareWithNaive(makeRoomHypotheses(seed), readingOf(true)), 3U);
  }
}

TEST(PaperGrowth, isTheNaiveOneOnHardClouds)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    EXPECT_GE(compareWithNaive(makeHardHypotheses(seed), readingOf(false)), 2U);
    EXPECT_GE(compareWithNaive(makeHardHypotheses(seed), readingOf(true)), 1U);
  }
}

/** The largest distance between two members of a plane, along x. */
double
lengthOf(const NaiveHypotheses& all, const NaivePlane& plane)
{
  double low = INFINITY, high = -INFINITY;
  for (const std::int32_t member : plane.members) {
    const double x = all.points[static_cast<std::size_t>(member)].x();
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return high - low;
}

/** What can be said without any growth: of a wall 9 m long, with 2 m of it hidden. */
TEST(PaperGrowth, wallsAreWholeUpToGapsOfTheDistance)
{
  HypothesisMaker maker(8);
  maker.addBoard({0, 0, 0}, {4, 0, 0}, {0, 0.5, 0}, 1600, 0.005, 0.01);
  maker.addBoard({6, 0, 0}, {3, 0, 0}, {0, 0.5, 0}, 1200, 0.005, 0.01);
  std::vector<double> lengths;
  for (const NaivePlane& plane : growByKernel(maker.all, readingOf(true)).planes)
    lengths.push_back(lengthOf(maker.all, plane));
  std::sort(lengths.begin(), lengths.end());
  ASSERT_EQ(lengths.size(), 2U) << "nothing is within 0.8 m across the gap";
  EXPECT_NEAR(lengths[0], 3, 0.05);
  EXPECT_NEAR(lengths[1], 4, 0.05);
  NaiveThresholds wide = readingOf(true);
  wide.member_distance = 2.1;
  const Grown one = growByKernel(maker.all, wide);
  ASSERT_EQ(one.planes.size(), 1U);
  EXPECT_NEAR(lengthOf(maker.all, one.planes[0]), 9, 0.05);
}

TEST(PaperGrowth, piecesAreAsLargeAsTheDistanceAllows)
{
  HypothesisMaker maker(9);
  maker.addBoard({0, 0, 0}, {9, 0, 0}, {0, 0.5, 0}, 3600, 0.005, 0.01);
  const Grown found = growByKernel(maker.all, readingOf(false));
  EXPECT_GE(found.planes.size(), 6U);
  for (const NaivePlane& plane : found.planes)
    EXPECT_LT(lengthOf(maker.all, plane), 1.6);
}

TEST(PaperGrowth, isTheNaiveOneInTheOrderOfCurvature)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const NaiveHypotheses all = makeRoomHypotheses(seed);
    compareWithNaive(all, {}, makeCurvatures(all.points.size(), seed));
  }
}

/** With a mesh there are neighbours to merge with, rims and stragglers; the paper has
 * none of this. */
TEST(PaperGrowth, isTheNaiveOneWithAMesh)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const NaiveHypotheses all = makeRoomHypotheses(seed);
    TriangleMesh::Triangles triangles;
    const auto size = static_cast<std::int32_t>(all.points.size());
    for (std::int32_t i = 0; i + 2 < size; ++i)
      triangles.push_back({i, i + 1, i + 2});
    compareWithNaive(all, {}, {}, triangles);
  }
}

TEST(PaperGrowth, thresholdsAreUsed)
{
  for (const NaiveThresholds& limits : {NaiveThresholds{0.4, 0.38, 0.1, 20},
                                        NaiveThresholds{0.8, 0.11, 0.25, 10},
                                        NaiveThresholds{1.5, 1.05, 0.05, 100}})
    for (const bool by_members : {false, true}) {
      NaiveThresholds used = limits;
      used.by_members = by_members;
      SCOPED_TRACE(std::to_string(limits.member_distance) +
                   (by_members ? " m, of members" : " m, of the hypothesis"));
      EXPECT_GE(compareWithNaive(makeRoomHypotheses(7), used), 2U);
      compareWithNaive(makeHardHypotheses(7), used);
    }
}

/** Squared errors of slopes and offset in units of the covariance, over many boards. */
TEST(PaperGrowth, covarianceIsThatOfIndependentNoise)
{
  constexpr int runs = 300;
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    HypothesisMaker maker(seed);
    maker.addBoard({0, 0, 0}, {0.6, 0, 0}, {0, 0.3, 0}, 100, 0.01, 0.01);
    std::vector<Eigen::Vector3f> points;
    PlaneHypotheses hypotheses;
    for (const Eigen::Vector3d& point : maker.all.points)
      points.emplace_back(point.cast<float>());
    hypotheses.normals.assign(points.size(), Eigen::Vector3f::UnitZ());
    hypotheses.points =
        PointView(points.data(), sizeof(Eigen::Vector3f), points.size());
    PlaneClusteringSettings settings;
    settings.noise_driven = false;
    PlaneClusteringReport report;
    const PlaneClusters found =
        clusterPlanes(hypotheses, {}, settings, Progress(), report);
    ASSERT_EQ(found.patches.size(), 1U);
    const PlanePatch& patch = found.patches[0];
    ASSERT_EQ(patch.support, 100U);
    EXPECT_GT(std::abs(patch.axis_u.x()), 0.9) << "along the board";
    const Eigen::Vector3d error(patch.axis_u.z(), patch.axis_v.z(), patch.center.z());
    sum += error.dot(patch.covariance.inverse() * error) / 3;
  }
  EXPECT_NEAR(sum / runs, 1, 0.15);
}

} // namespace
} // namespace pcl::acmap::test

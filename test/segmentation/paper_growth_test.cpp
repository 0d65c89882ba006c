#include "naive_growth.h"

#include "planes/plane_growth.h"

#include <pcl/core/random.h>

#include <Eigen/Geometry>
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

/** Result of the kernel: the members of each plane in ascending order. */
std::vector<NaivePlane>
growByKernel(const NaiveHypotheses& all,
             const NaiveThresholds& limits,
             const Progress& progress = Progress())
{
  std::vector<Eigen::Vector3f> points;
  PlaneHypotheses hypotheses;
  for (const Eigen::Vector3d& point : all.points)
    points.emplace_back(point.cast<float>());
  for (const Eigen::Vector3d& normal : all.normals)
    hypotheses.normals.emplace_back(normal.cast<float>());
  hypotheses.points = PointView(points.data(), sizeof(Eigen::Vector3f), points.size());
  const planes::CellGraph graph(hypotheses, 1);
  std::vector<std::int32_t> seeds(points.size());
  std::iota(seeds.begin(), seeds.end(), 0);
  planes::PlaneLimits kernel_limits;
  kernel_limits.distance = limits.plane_distance;
  kernel_limits.cosine = limits.cosine;
  kernel_limits.refit_always = true;
  PlaneClusteringReport report;
  std::vector<NaivePlane> planes;
  for (const planes::GrownPlane& grown : planes::growAsPaper(graph,
                                                             seeds,
                                                             kernel_limits,
                                                             limits.member_distance,
                                                             limits.support,
                                                             progress,
                                                             report)) {
    planes.push_back({grown.plane.normal,
                      grown.plane.offset - grown.plane.normal.dot(graph.origin),
                      grown.members});
    std::sort(planes.back().members.begin(), planes.back().members.end());
  }
  return planes;
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

/** Two distant boards; all points of a board are within W_d of each other. */
TEST(PaperGrowth, tellsHowFarItIsAndCanBeStopped)
{
  HypothesisMaker maker(5);
  maker.addBoard({0, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}, 2500, 0.001, 0.01);
  maker.addBoard({9, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}, 2500, 0.001, 0.01);
  std::vector<double> told;
  growByKernel(maker.all, {}, Progress([&](double fraction, const std::string&) {
                 told.push_back(fraction);
                 return true;
               }));
  ASSERT_GE(told.size(), 4U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LT(told.front(), 0.4);
  EXPECT_GT(told.back(), 0.5);
  EXPECT_LE(told.back(), 0.85);
  EXPECT_THROW(
      growByKernel(maker.all, {}, Progress([](double fraction, const std::string&) {
                     return fraction < 0.4;
                   })),
      CancelledException);
}

TEST(PaperGrowth, isTheNaiveOneWherePlanesAreClear)
{
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const NaiveHypotheses all = makeRoomHypotheses(seed);
    const std::vector<NaivePlane> wanted = growNaively(all, {});
    const std::vector<NaivePlane> found = growByKernel(all, {});
    ASSERT_EQ(wanted.size(), 4U);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t p = 0; p < found.size(); ++p) {
      EXPECT_EQ(found[p].members, wanted[p].members) << "plane " << p;
      EXPECT_LT((found[p].normal - wanted[p].normal).norm(), 1e-6);
      EXPECT_NEAR(found[p].offset, wanted[p].offset, 1e-6);
    }
  }
}

/** Checks properties of all planes, independent of the order of growing; a few
 * supporters may violate them, because the iterations are limited. */
void
expectSettled(const NaiveHypotheses& all,
              const NaiveThresholds& limits,
              const std::vector<NaivePlane>& planes)
{
  std::vector<bool> is_free(all.points.size(), true);
  std::size_t wrong = 0;
  for (const NaivePlane& plane : planes) {
    EXPECT_GT(plane.members.size(), limits.support);
    const NaivePlane refit = planeThrough(all, plane.members, plane.normal);
    EXPECT_LT((refit.normal - plane.normal).norm(), 1e-6) << "of all supporters";
    for (const std::int32_t member : plane.members) {
      const auto m = static_cast<std::size_t>(member);
      wrong += !supports(all, m, plane, limits) || !isNearSome(all, m, plane, limits);
      EXPECT_TRUE(is_free[m]) << "one plane a point";
      is_free[m] = false;
    }
  }
  EXPECT_LE(wrong, all.points.size() / 100) << "supporters that do not support";
  std::size_t left_out = 0;
  for (const NaivePlane& plane : planes)
    for (std::size_t i = 0; i < all.points.size(); ++i)
      left_out += is_free[i] && supports(all, i, plane, limits) &&
                  isNearSome(all, i, plane, limits);
  EXPECT_LE(left_out, all.points.size() / 100);
}

TEST(PaperGrowth, settlesOnHardClouds)
{
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    HypothesisMaker maker(seed);
    maker.addBoard({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, 500, 0.1, 0.2);
    maker.addBoard({0, 0, 0.3}, {3, 0, 0.6}, {0, 3, 0}, 500, 0.1, 0.2);
    maker.addBoard({3, 0, 0}, {2, 0, 1}, {0, 3, 0}, 300, 0.1, 0.2);
    maker.addClutter(3, 600);
    const std::vector<NaivePlane> found = growByKernel(maker.all, {});
    EXPECT_GE(found.size(), 2U);
    expectSettled(maker.all, {}, found);
  }
}

TEST(PaperGrowth, thresholdsAreUsed)
{
  const NaiveHypotheses all = makeRoomHypotheses(7);
  for (const NaiveThresholds& limits : {NaiveThresholds{0.4, 0.93, 0.1, 50},
                                        NaiveThresholds{0.8, std::cos(0.1), 0.25, 30},
                                        NaiveThresholds{1.5, 0.5, 0.05, 100}}) {
    const std::vector<NaivePlane> wanted = growNaively(all, limits);
    const std::vector<NaivePlane> found = growByKernel(all, limits);
    EXPECT_EQ(found.size(), wanted.size());
    expectSettled(all, limits, found);
  }
}

} // namespace
} // namespace pcl::acmap::test

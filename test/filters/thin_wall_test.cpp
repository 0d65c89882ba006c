#include "consolidation_runs.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

constexpr double pi = 3.14159265358979323846;

/** Both faces of a wall of 2 m by 2 m, 12 cm thick, with 1 cm noise; each is observed
 * from its own side. */
struct Wall {
  std::array<Patch, 2> faces;
  NoisyCloud cloud;
};

/** \param[in] inclination angle between its normal and the z axis, radians
 * \param[in] stations sensor positions of the front in its own frame: along u, along
 * v, in front; the back has the mirrored ones */
Wall
makeWall(double inclination, const std::vector<Eigen::Vector3d>& stations)
{
  constexpr double half_thickness = 0.06;
  Wall wall;
  Random random(17);
  const Patch middle = squarePatch(2, inclination);
  const Eigen::Vector3d center = middle.corner + (middle.u + middle.v) / 2;
  for (const int side : {0, 1}) {
    Patch& face = wall.faces[side];
    face = side == 0 ? middle : Patch{middle.corner, middle.v, middle.u};
    face.corner += half_thickness * face.normal();
    for (const Eigen::Vector3d& station : stations) {
      const auto view = static_cast<std::int32_t>(wall.cloud.viewpoints.size());
      wall.cloud.viewpoints.emplace_back((center + station.x() * middle.u.normalized() +
                                          station.y() * middle.v.normalized() +
                                          station.z() * face.normal())
                                             .cast<float>());
      wall.cloud.addPatch(
          face, 10000.0 / static_cast<double>(stations.size()), 0.01, random, view);
    }
  }
  return wall;
}

void
expectTwoSheets(const Wall& wall, double voxel, const std::string& what)
{
  const Consolidated found = consolidate(wall.cloud, voxel);
  const double inset = 2.5 * voxel;
  for (const Patch& face : wall.faces) {
    const SheetFit fit = fitOf(found.cloud, face, voxel, 0.5, inset);
    EXPECT_NEAR(fit.mean, 0, 0.005) << what;
    EXPECT_LT(fit.rms, 0.01) << what;
    EXPECT_GT(fit.coverage, 0.6) << what;
    EXPECT_LT(fit.coverage, 2) << what;
    EXPECT_LT(fit.median_angle, 3.0 / 180 * pi) << what;
  }
  std::size_t between = 0;
  for (const MapPoint& point : found.cloud)
    between += insetIn(wall.faces[0], placeOf(point)) > inset &&
               wall.faces[0].depthOf(placeOf(point)) < -0.03 &&
               wall.faces[1].depthOf(placeOf(point)) < -0.03;
  EXPECT_LT(static_cast<double>(between),
            0.01 * static_cast<double>(found.cloud.size()))
      << what;
}

class ThinWall : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(ThinWall, keepsBothSheets)
{
  const auto [degrees, voxel] = GetParam();
  const std::string what =
      "at " + std::to_string(degrees) + " degrees, voxels " + std::to_string(voxel);
  expectTwoSheets(
      makeWall(degrees / 180 * pi, {{0, 0, 2.5}, {0.6, 0.2, 2}, {-0.7, -0.1, 3}}),
      voxel,
      what);
}

INSTANTIATE_TEST_SUITE_P(
    Consolidation,
    ThinWall,
    testing::Combine(testing::Values(0, 30, 45, 90),
                     testing::Values(0.04, 0.05, 0.07, 0.1, 0.15)));

} // namespace
} // namespace pcl::acmap::test

#include "axes.h"
#include "known_boards.h"

#include "labeling/junctions.h"
#include "labeling/label_points.h"
#include "labeling/ray_fit.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Thousands of convex and concave edges: a table of all pairs would not fit into
 * memory. */
TEST(Junctions, knowTheirSidesOfManyPlanes)
{
  constexpr double spacing = 0.1;
  constexpr int edges = 30000;
  KnownBoards boards(spacing);
  for (int edge = 0; edge < edges; ++edge) {
    const Eigen::Vector3d corner((edge % 200) * 2.0, edge / 200 * 2.0, 0);
    const double first = edge % 2 == 0 ? spacing : -3 * spacing; // in front or behind
    boards.add(corner + first * x, spacing * x, 3, spacing * y, 3);
    boards.add(corner + first * z, spacing * y, 3, spacing * z, 3);
  }
  KnownPlanes known = boards.known();
  const labeling::CandidateGrid grid(known, 2 * spacing, 1);
  const labeling::Junctions junctions(known, grid);
  for (std::size_t edge = 0; edge < edges; ++edge) {
    const std::size_t floor = 2 * edge, wall = floor + 1;
    EXPECT_EQ(junctions.side(floor, wall), edge % 2 == 0 ? 1 : -1) << edge;
    EXPECT_EQ(junctions.side(wall, floor), edge % 2 == 0 ? 1 : -1) << edge;
    EXPECT_EQ(junctions.side(floor, floor), 0);
    EXPECT_EQ(junctions.side(floor, (wall + 1) % (2 * edges)), 0);
  }
}

/** The voxel's own plane is the last of nine; the other eight have smaller keys. */
TEST(CandidateGrid, holdsTheVoxelsOwnPlaneWhereManyAreNear)
{
  KnownBoards boards(1);
  for (int plane = 0; plane < 8; ++plane)
    boards.add({0.5, plane % 3 + 0.5, plane / 3 + 0.5}, x / 8, 1, y / 8, 1);
  const Eigen::Vector3d own(1.5, 1.5, 1.5);
  boards.add(own, x / 8, 1, y / 8, 1);
  KnownPlanes known = boards.known();
  const labeling::CandidateGrid grid(known, 1, 1);
  VoxelHit hit;
  ASSERT_TRUE(grid.lattice().locate(own.cast<float>(), hit));
  const labeling::Candidates& there = grid[grid.find(voxelKey(hit.place))];
  EXPECT_EQ(there.size, labeling::Candidates::maximum);
  EXPECT_EQ(there.home, 8);
  EXPECT_TRUE(there.holds(8));
  EXPECT_EQ(there.planes[0], 8) << "before its neighbours'";
}

LabelingLimits
makeLimits()
{
  LabelingLimits limits;
  limits.distance = 0.02;
  limits.cosine = std::cos(0.2);
  return limits;
}

void
expectCentered(const PlanePatch& patch, const Eigen::Vector3d& middle)
{
  EXPECT_LT((patch.center - middle).norm(), 0.01) << patch.center.transpose();
  EXPECT_NEAR(std::abs(patch.axis_u.x()), 1, 1e-3) << "the longer one";
  EXPECT_NEAR(
      patch.coefficients.head<3>().dot(patch.center) + patch.coefficients[3], 0, 1e-9);
  EXPECT_NEAR(
      patch.axis_u.cross(patch.axis_v).dot(patch.coefficients.head<3>()), 1, 1e-9);
}

TEST(LabelPoints, joinedPartsHaveOneMiddle)
{
  KnownBoards boards(0.05);
  for (const double left : {-3.0, 1.0}) // 2 m by 1 m each, 2 m apart
    boards.add({left, 0, 2}, 0.05 * x, 41, 0.05 * y, 21);
  KnownPlanes known = boards.known();
  PlaneClusteringReport report;
  const PointLabels labels = labelPoints(
      boards.points(), SensorView(), makeLimits(), Progress(), known, report);
  ASSERT_EQ(known.planes.size(), 1U);
  EXPECT_EQ(report.merged, 1U);
  EXPECT_EQ(labels, PointLabels(2 * 41 * 21, 0));
  EXPECT_EQ(known.planes[0].patch.support, labels.size());
  expectCentered(known.planes[0].patch, {0, 0.5, 2});
}

TEST(LabelPoints, frameIsThatOfTheSupportWithoutASourceToo)
{
  KnownBoards boards(0.05);
  boards.add({0, 0, 2}, 0.05 * x, 41, 0.05 * y, 21);
  KnownPlanes known = boards.known();
  known.planes[0].patch.center += 0.7 * x;
  fitLabeled(boards.points(), SensorView(), makeLimits(), known);
  ASSERT_EQ(known.planes.size(), 1U);
  expectCentered(known.planes[0].patch, {1, 0.5, 2});
}

/** Sums in one frame that are transformed to another frame equal those computed
 * there. */
TEST(FitSums, followTheirFrame)
{
  KnownBoards boards(0.1);
  boards.add({1, 2, 3}, 0.1 * (x + z), 12, 0.1 * y, 7);
  const PlanePatch patch = boards.known().planes[0].patch;
  PlanePatch other = patch;
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  other.center += 0.3 * patch.axis_u - 1.1 * patch.axis_v;
  other.axis_u = Eigen::AngleAxisd(0.6, normal) * patch.axis_u;
  other.axis_v = normal.cross(other.axis_u);
  labeling::FitSums sums, expected;
  for (std::size_t i = 0; i < boards.points().size(); ++i) {
    const Eigen::Vector3f off =
        boards.points()[i] + (0.01F * static_cast<float>(i % 5)) * normal.cast<float>();
    const labeling::Crossing crossing(labeling::Sight(off, nullptr), patch);
    sums.add(crossing, patch, 2.5);
    expected.add(crossing, other, 2.5);
  }
  const labeling::FitSums moved = labeling::movedSums(sums, patch, other);
  EXPECT_TRUE(moved.matrix.isApprox(expected.matrix, 1e-9));
  EXPECT_TRUE(moved.right.isApprox(expected.right, 1e-9));
}

TEST(FitSums, knowNoTiltOfALine)
{
  labeling::FitSums sums;
  EXPECT_FALSE(labeling::knowsTilt(sums, 0.1)) << "of nothing";
  KnownBoards board(0.1);
  board.add({0, 0, 0}, 0.1 * x, 30, 0.1 * y, 1);
  const PlanePatch patch = board.known().planes[0].patch;
  const auto add = [&](const Eigen::Vector3f& point) {
    sums.add(labeling::Crossing(labeling::Sight(point, nullptr), patch), patch, 1e4);
  };
  for (std::size_t i = 0; i < board.points().size(); ++i)
    add(board.points()[i]);
  EXPECT_FALSE(labeling::knowsTilt(sums, 0.1));
  add({0, 1, 0});
  EXPECT_TRUE(labeling::knowsTilt(sums, 0.1));
}

TEST(FitSums, turnAPlaneHoweverFar)
{
  KnownBoards board(0.1);
  board.add({1, 2, 3}, x, 10, y, 10);
  const PlanePatch before = board.known().planes[0].patch;
  for (const double slope : {0.0, 0.1, 1.0, 1e9, 1e38, 1e200}) {
    labeling::FitSums sums;
    sums.matrix.setIdentity();
    sums.right = Eigen::Vector3d(slope, -slope / 3, 0.5);
    PlanePatch patch = before;
    labeling::moveToFit(sums, patch);
    const Eigen::Vector3d normal = patch.coefficients.head<3>();
    Eigen::Matrix3d axes;
    axes << patch.axis_u, patch.axis_v, normal;
    EXPECT_TRUE((axes.transpose() * axes).isIdentity(1e-9)) << slope;
    EXPECT_NEAR(axes.determinant(), 1, 1e-9) << slope;
    const double tilt = std::atan(slope * std::sqrt(10.0) / 3);
    EXPECT_NEAR(normal.dot(before.coefficients.head<3>()), std::cos(tilt), 1e-9)
        << slope;
  }
}

/** Points on a line, some of them far away: rounding must not give negative
 * variances. */
TEST(FitSums, haveACovarianceWithoutNegativeVariances)
{
  KnownBoards board(0.1);
  board.add({0, 0, 0}, x, 10, y, 10);
  const PlanePatch patch = board.known().planes[0].patch;
  for (const float far : {1e3F, 1e5F, 1e7F}) {
    LargeVector<labeling::FitSums> clusters(8);
    labeling::FitSums sums;
    for (int i = 0; i < 80; ++i) {
      const float along = i % 7 == 0 ? far : static_cast<float>(i);
      const Eigen::Vector3f point(
          along, 0.3F * along + 1e-3F * static_cast<float>(i % 3), 0.01F * (i % 5));
      const labeling::Crossing crossing(labeling::Sight(point, nullptr), patch);
      for (labeling::FitSums* to : {&sums, &clusters[static_cast<std::size_t>(i % 8)]})
        to->add(crossing, patch, 1e4);
    }
    PlanePatch moved = patch;
    const Eigen::Vector3d solution = labeling::moveToFit(sums, moved);
    const Eigen::Matrix3d covariance =
        labeling::clusteredCovariance(sums, 0, solution, clusters);
    const Eigen::Vector3d deviations = covariance.diagonal().cwiseSqrt();
    ASSERT_GT(deviations.minCoeff(), 0) << far;
    const Eigen::Matrix3d scaled = deviations.cwiseInverse().asDiagonal() * covariance *
                                   deviations.cwiseInverse().asDiagonal();
    EXPECT_EQ(covariance, covariance.transpose()) << far;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled);
    EXPECT_GT(solver.eigenvalues()[0], -1e-12) << far;
  }
}

} // namespace
} // namespace pcl::acmap::test

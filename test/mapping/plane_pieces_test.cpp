#include "plane_adjustment/joined_landmarks.h"
#include "plane_adjustment/view_pieces.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

/** A depth image of a wall at 3 m that ends at a column; behind it is a second one. */
class SteppedWall {
public:
  static constexpr std::size_t width = 320, height = 160;
  static constexpr double distance = 3, sigma = 0.03; // metres

  SteppedWall(std::size_t edge, double recess)
  {
    Random random(5);
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x) {
        const Eigen::Vector3d direction((static_cast<double>(x) - 159.5) / 300,
                                        (static_cast<double>(y) - 79.5) / 300,
                                        1);
        const double depth = x < edge ? distance : distance + recess;
        const double length = depth * direction.norm() + sigma * random.normal();
        points_.push_back((length * direction.normalized()).cast<float>());
        sigmas_.push_back(static_cast<float>(sigma));
      }
  }

  std::vector<PlanePiece>
  pieces() const
  {
    AdjustedView view{
        PointView(points_.front().data(), sizeof(points_.front()), points_.size())};
    view.sigmas = sigmas_.data();
    view.sigma_stride = sizeof(float);
    view.width = width;
    PieceCounts counts;
    return piecesOf(view, RangeNoise(), counts);
  }

private:
  std::vector<Eigen::Vector3f> points_;
  std::vector<float> sigmas_;
};

/** The recess is as deep as the noise, so that no tile of 8 pixels shows it: what pulls
 * all pieces of the edge the same way must be left out nevertheless. */
TEST(PlanePieces, doNotReachOverAnEdge)
{
  for (const std::size_t edge : {std::size_t{98}, std::size_t{101}, std::size_t{127}}) {
    const double recess = 0.1;
    const double place = SteppedWall::distance * (static_cast<double>(edge) - 160) /
                         300; // metres, x of it
    double sum = 0, weights = 0;
    for (const PlanePiece& piece : SteppedWall(edge, recess).pieces()) {
      const double x = piece.center.x();
      if (x > place || x < place - 0.25)
        continue;
      sum += piece.weight() * (piece.center.z() - SteppedWall::distance);
      weights += piece.weight();
    }
    ASSERT_GT(weights, 0);
    EXPECT_LT(std::abs(sum / weights), 4 / std::sqrt(weights)) << edge;
  }
}

/** What a view at the origin has measured of a square of 1 m at z = height. */
Landmark
squareAt(std::size_t view, double x, double height, double slope, std::uint64_t seed)
{
  constexpr double sigma = 0.001; // metres
  Random random(seed);
  Landmark square;
  square.center = {x, 0, height};
  square.normal = Eigen::Vector3d(-slope, 0, 1).normalized();
  square.pieces = 2;
  for (const std::size_t by : {view, view + 1}) {
    LandmarkView seen{by, Eigen::Matrix4d::Zero(), 0, height};
    const double off = 0.1 * sigma * random.normal();
    for (int u = -2; u <= 2; ++u)
      for (int v = -2; v <= 2; ++v) {
        Eigen::Vector4d point(x + 0.2 * u, 0.2 * v, height + 0.2 * u * slope + off, 1);
        seen.cluster += point * point.transpose() / (sigma * sigma);
      }
    seen.variance = 1 / seen.cluster(3, 3);
    square.views.push_back(seen);
  }
  return square;
}

TEST(JoinedLandmarks, whatContinuesOneAnotherIsOnePlane)
{
  const Poses poses(6, Eigen::Isometry3d::Identity());
  std::vector<Landmark> squares;
  for (std::size_t i = 0; i < 5; ++i)
    squares.push_back(squareAt(i, static_cast<double>(i), 2, 0, i + 1));
  const std::vector<Landmark> joined = joinLandmarks(squares, poses);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0].pieces, 10U);
  ASSERT_EQ(joined[0].views.size(), 6U);
  Eigen::Matrix4d before = Eigen::Matrix4d::Zero(), after = before;
  for (const Landmark& square : squares)
    for (const LandmarkView& view : square.views)
      before += view.cluster;
  for (const LandmarkView& view : joined[0].views)
    after += view.cluster;
  EXPECT_LT((after - before).norm(), 1e-9 * before.norm());
}

TEST(JoinedLandmarks, stepsSlopesAndGapsStayApart)
{
  const Poses poses(4, Eigen::Isometry3d::Identity());
  const Landmark first = squareAt(0, 0, 2, 0, 1);
  EXPECT_EQ(joinLandmarks({first, squareAt(1, 1, 2.005, 0, 2)}, poses).size(), 2U);
  EXPECT_EQ(joinLandmarks({first, squareAt(1, 1, 2, 0.02, 2)}, poses).size(), 2U);
  EXPECT_EQ(joinLandmarks({first, squareAt(1, 3, 2, 0, 2)}, poses).size(), 2U);
  EXPECT_EQ(joinLandmarks({}, poses).size(), 0U);
}

TEST(JoinedLandmarks, endAtTheirReach)
{
  constexpr std::size_t count = 60; // metres
  const Poses poses(count + 1, Eigen::Isometry3d::Identity());
  std::vector<Landmark> squares;
  for (std::size_t i = 0; i < count; ++i)
    squares.push_back(squareAt(i, static_cast<double>(i), 2, 0, i + 1));
  const std::vector<Landmark> joined = joinLandmarks(squares, poses);
  EXPECT_GT(joined.size(), 1U);
  EXPECT_LE(joined.size(), 4U);
  for (const Landmark& landmark : joined)
    EXPECT_LE(landmark.views.size(), 42U);
}

} // namespace
} // namespace pcl::acmap::test

#include "outline_scores.h"

#include <pcl/simulation/standard_scenes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl::acmap::bench {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/** A closed room of 2 x 1 x 1.5 m, looked at from its middle in all directions. */
SimulatedScene
makeRoom()
{
  SimulatedScene scene;
  scene.rig = standardScene("office").rig;
  const auto add = [&](const char* name,
                       const Vector3d& corner,
                       const Vector3d& edge_u,
                       const Vector3d& edge_v) {
    scene.geometry.addRectangle(name, name, {corner, edge_u, edge_v}, {});
  };
  add("floor", {-1, 0.5, -0.75}, {2, 0, 0}, {0, 0, 1.5});
  add("ceiling", {-1, -0.5, -0.75}, {0, 0, 1.5}, {2, 0, 0});
  add("left wall", {-1, 0.5, -0.75}, {0, 0, 1.5}, {0, -1, 0});
  add("right wall", {1, 0.5, 0.75}, {0, 0, -1.5}, {0, -1, 0});
  add("far wall", {-1, 0.5, 0.75}, {2, 0, 0}, {0, -1, 0});
  add("near wall", {1, 0.5, -0.75}, {-2, 0, 0}, {0, -1, 0});
  for (const double pitch : {0.0, -0.7, 0.7, -M_PI / 2, M_PI / 2})
    for (int turn = 0; turn < 10; ++turn) {
      Eigen::Isometry3d view = Eigen::Isometry3d::Identity();
      view.rotate(Eigen::AngleAxisd(turn * M_PI / 5, Vector3d::UnitY()));
      view.rotate(Eigen::AngleAxisd(pitch, Vector3d::UnitX()));
      scene.views.push_back(view);
    }
  return scene;
}

/** The outlines of the room as they are, which share all their edges. */
std::vector<PlanePatch>
makeMap(const SimulatedScene& scene)
{
  std::vector<PlanePatch> map;
  for (const TruthPlane& plane : scene.geometry.planes()) {
    const SimulatedRectangle& shape = plane.rectangles.front();
    PlanePatch& patch = map.emplace_back();
    patch.coefficients = plane.coefficients;
    PlanePolygon& polygon = patch.polygons.emplace_back();
    for (const Vector3d& corner : {shape.corner,
                                   Vector3d(shape.corner + shape.edge_u),
                                   Vector3d(shape.corner + shape.edge_u + shape.edge_v),
                                   Vector3d(shape.corner + shape.edge_v)})
      polygon.outer.emplace_back(corner.cast<float>());
  }
  return map;
}

constexpr std::size_t floor_plane = 0, ceiling = 1, far_wall = 4;
constexpr double creases = 4 * (2 + 1 + 1.5), area = 2 * (3 + 2 + 1.5);

class OutlineScoresTest : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    room_ = std::make_unique<SimulatedScene>(makeRoom());
    truth_ = std::make_unique<VisibleTruth>(findVisibleTruth(*room_));
  }

  static void
  TearDownTestSuite()
  {
    room_.reset();
    truth_.reset();
  }

  OutlineScores
  score() const
  {
    return scoreOutlines(makeOutlines(map_), *truth_);
  }

  OutlineCounts
  count() const
  {
    return countOutlines(makeOutlines(map_));
  }

  std::vector<Vector3f>&
  outer(std::size_t plane)
  {
    return map_[plane].polygons.front().outer;
  }

  static std::unique_ptr<SimulatedScene> room_;
  static std::unique_ptr<VisibleTruth> truth_;
  std::vector<PlanePatch> map_ = makeMap(*room_);
};

std::unique_ptr<SimulatedScene> OutlineScoresTest::room_;
std::unique_ptr<VisibleTruth> OutlineScoresTest::truth_;

TEST_F(OutlineScoresTest, TheRoomIsSeen)
{
  EXPECT_NEAR(truth_->seenArea(), area, 1e-9);
  EXPECT_NEAR(raster_cell * static_cast<double>(truth_->creases.size()), creases, 1e-9);
  EXPECT_EQ(truth_->corners.size(), 8U);
}

TEST_F(OutlineScoresTest, TheTruthIsPerfect)
{
  const OutlineScores scores = score();
  EXPECT_NEAR(scores.found, creases, 1e-9);
  EXPECT_NEAR(scores.shared, creases, 1e-9);
  EXPECT_EQ(scores.gaps, 0);
  EXPECT_NEAR(scores.common, area, 1e-9);
  EXPECT_NEAR(scores.joined, area, 1e-9);
  EXPECT_LT(*std::max_element(scores.corners.begin(), scores.corners.end()), 1e-6);
  const OutlineCounts counts = count();
  EXPECT_NEAR(counts.area, area, 1e-5);
  EXPECT_NEAR(counts.vertices_mean, 4, 1e-9);
  EXPECT_EQ(counts.crossed, 0U);
  EXPECT_EQ(counts.holes, 0U);
}

/** One of the floor's four edges lies beyond the wall, the opposite one leaves a gap. */
TEST_F(OutlineScoresTest, AMovedPlaneSharesNothing)
{
  for (Vector3f& corner : outer(floor_plane))
    corner.x() += 0.02F;
  const OutlineScores scores = score();
  EXPECT_NEAR(scores.shared, creases - 7, 1e-9);
  EXPECT_NEAR(scores.gaps, 1.5 + 0.02, 0.021); // and a centimetre at both ends of two
  EXPECT_NEAR(scores.missing, 0.03, 1e-9);
  EXPECT_NEAR(scores.nothing, 0.03, 1e-9);
  EXPECT_EQ(scores.missing_inside, 0);
  EXPECT_EQ(scores.nothing_inside, 0);
}

TEST_F(OutlineScoresTest, TheSmallestDifferenceIsNotShared)
{
  for (Vector3f& corner : outer(floor_plane))
    corner.x() = std::nextafter(corner.x(), 10.0F);
  const OutlineScores scores = score();
  EXPECT_NEAR(scores.shared, creases - 7, 1e-9);
  EXPECT_EQ(scores.gaps, 0);
}

TEST_F(OutlineScoresTest, SurplusOverNothingIsDeepBeyondFiveCentimetres)
{
  for (Vector3f& corner : outer(far_wall))
    if (corner.y() < 0)
      corner.y() -= 0.3F;
  const OutlineScores scores = score();
  EXPECT_NEAR(scores.nothing, 2 * 0.3, 1e-9);
  EXPECT_NEAR(scores.nothing_inside, 2 * 0.25, 1e-9);
  EXPECT_EQ(scores.missing, 0);
  EXPECT_EQ(scores.gaps, 0);
}

TEST_F(OutlineScoresTest, AHoleIsMissingAndASliver)
{
  map_[far_wall].polygons.front().holes = {
      {{0, 0, 0.75F}, {0, 0.05F, 0.75F}, {0.05F, 0.05F, 0.75F}, {0.05F, 0, 0.75F}}};
  EXPECT_NEAR(score().missing_inside, 0.0025, 1e-9);
  EXPECT_EQ(count().holes, 1U);
  EXPECT_EQ(count().slivers, 1U);
}

TEST_F(OutlineScoresTest, WithoutAPlaneItsCreasesAreNotFound)
{
  map_.erase(map_.begin() + ceiling);
  const OutlineScores scores = score();
  EXPECT_NEAR(scores.creases, creases, 1e-9);
  EXPECT_NEAR(scores.found, creases - 7, 1e-9);
  EXPECT_NEAR(scores.shared, creases - 7, 1e-9);
  EXPECT_NEAR(scores.seen, area - 3, 1e-9);
}

TEST_F(OutlineScoresTest, APlaneInTheAirHasNoFace)
{
  PlanePatch& plane = map_.emplace_back(map_[far_wall]);
  plane.coefficients[3] -= 0.2;
  for (Vector3f& corner : plane.polygons.front().outer)
    corner.z() -= 0.2F;
  const OutlineScores scores = score();
  EXPECT_EQ(scores.face_of_plane.back(), -1);
  EXPECT_NEAR(scores.unmatched_area, 2, 1e-6);
  EXPECT_NEAR(scores.joined, area, 1e-9);
}

TEST_F(OutlineScoresTest, CrossingsAreCounted)
{
  std::swap(outer(floor_plane)[0], outer(floor_plane)[1]);
  EXPECT_EQ(count().crossed, 1U);
}

} // namespace
} // namespace pcl::acmap::bench

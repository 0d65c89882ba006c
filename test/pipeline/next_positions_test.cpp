#include "house_map.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/next_positions.h>

#include <gmock/gmock.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

/** A room of 8 x 4 m, 2.5 m high, with a partition in the middle and a gap of a metre beside it; behind it
 * neither the ceiling nor the far wall was seen. */
CompactMap
makeHalfSeenRoom()
{
  CompactMap map;
  map.up = Vector3d::UnitZ();
  addPlane(map, level({0, 0}, {8, 4}, 0, true));
  addPlane(map, level({0, 0}, {4, 4}, 2.5, false));
  addPlane(map, upright({0, 4}, {0, 0}, 0, 2.5));
  addPlane(map, upright({0, 0}, {8, 0}, 0, 2.5));
  addPlane(map, upright({8, 4}, {0, 4}, 0, 2.5));
  addPlane(map, upright({4, 1}, {4, 4}, 0, 2.5));
  return named(map);
}

NextPositionsReport
proposalsFor(const CompactMap& map, unsigned threads = 1, int number = 3)
{
  const FloorPlan plan = makeFloorPlan(map);
  NextPositions next;
  next.setNumberOfThreads(threads);
  next.setNumberOfPositions(number);
  next.compute(map, plan, findUnseenSurfaces(map, plan));
  return next.getReport();
}

TEST(NextPositions, StandOnTheFloorAndLookAtWhatIsUnseen)
{
  const NextPositionsReport report = proposalsFor(makeHalfSeenRoom());
  ASSERT_EQ(report.positions.size(), 3U);
  double before = std::numeric_limits<double>::infinity();
  for (const NextPosition& position : report.positions) {
    EXPECT_NEAR(position.eye.z(), 1.5, 1e-6);
    EXPECT_GT(position.eye.x(), 0.3);
    EXPECT_LT(position.eye.x(), 7.9);
    EXPECT_GT(position.eye.y(), 0.3);
    EXPECT_LT(position.eye.y(), 3.7);
    EXPECT_NEAR(position.direction.norm(), 1, 1e-9);
    EXPECT_LE(position.uncovered, before);
    before = position.uncovered;
    EXPECT_FALSE(position.words.empty());
  }
  // the unseen ceiling is behind the partition, and cannot be seen from before it
  EXPECT_GT(report.positions[0].eye.x(), 4);
  EXPECT_GT(report.positions[0].uncovered, 5);
}

TEST(NextPositions, AreTheSameForAnyNumberOfThreads)
{
  const CompactMap map = makeHalfSeenRoom();
  const NextPositionsReport one = proposalsFor(map, 1), two = proposalsFor(map, 2);
  ASSERT_EQ(one.positions.size(), two.positions.size());
  for (std::size_t k = 0; k < one.positions.size(); ++k) {
    EXPECT_EQ(one.positions[k].eye, two.positions[k].eye);
    EXPECT_EQ(one.positions[k].direction, two.positions[k].direction);
    EXPECT_EQ(one.positions[k].uncovered, two.positions[k].uncovered);
    EXPECT_EQ(one.positions[k].words, two.positions[k].words);
  }
}

TEST(NextPositions, UncoverLessEachTime)
{
  const NextPositionsReport all = proposalsFor(makeHalfSeenRoom(), 1, 20);
  double sum = 0;
  for (const NextPosition& position : all.positions)
    sum += position.uncovered;
  // nothing is counted twice; beyond the open far end, something is presumed
  EXPECT_LT(sum, all.unseen_area + 8 * (2 * 4 + 2 * 2.5));
  EXPECT_LT(all.positions.size(), 20U) << "then nothing is left";
}

/** Floor and ceiling in turn; more patches than are looked at. */
TEST(NextPositions, LookAtFloorAndCeilingAlike)
{
  constexpr std::size_t patches = 2000; // of each: every second one is looked at
  const CompactMap map = makeHalfSeenRoom();
  const FloorPlan plan = makeFloorPlan(map);
  UnseenSurfaces unseen;
  for (std::size_t k = 0; k < patches; ++k)
    for (const bool is_ceiling : {false, true}) {
      UnseenPatch patch;
      patch.center = {2 + 0.05 * static_cast<double>(k % 40),
                      1 + 0.04 * static_cast<double>(k / 40),
                      is_ceiling ? 2.5 : 0};
      patch.normal.z() = is_ceiling ? -1 : 1;
      patch.area = 0.002;
      patch.role = is_ceiling ? SurfaceRole::Ceiling : SurfaceRole::Floor;
      patch.room = 0;
      unseen.patches.push_back(patch);
    }
  NextPositions next;
  next.setNumberOfPositions(2);
  next.compute(map, plan, unseen);
  const std::vector<NextPosition> positions = next.getReport().positions;
  ASSERT_EQ(positions.size(), 2U);
  EXPECT_LT(positions[0].direction.z() * positions[1].direction.z(), 0)
      << "one looks down, one up";
  EXPECT_NEAR(positions[0].uncovered, 4, 1);
  EXPECT_NEAR(positions[1].uncovered, 4, 1);
}

TEST(NextPositions, AreNoneWithoutARoom)
{
  EXPECT_TRUE(proposalsFor(CompactMap()).positions.empty());
  CompactMap broken = makeHalfSeenRoom();
  for (PlanePatch& plane : broken.planes)
    plane.coefficients.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(proposalsFor(broken).positions.empty());
}

TEST(NextPositions, RefuseWhatMakesNoSense)
{
  NextPositions next;
  for (const double wrong : {-1.0, 0.0, 1e9, std::nan("")}) {
    EXPECT_THROW(next.setEyeHeight(wrong), BadArgumentException);
    EXPECT_THROW(next.setReach(wrong), BadArgumentException);
    EXPECT_THROW(next.setFieldOfView(wrong, 1), BadArgumentException);
    EXPECT_THROW(next.setFieldOfView(1, wrong), BadArgumentException);
  }
  EXPECT_THROW(next.setNumberOfPositions(0), BadArgumentException);
  EXPECT_EQ(next.getEyeHeight(), 1.5);
}

} // namespace
} // namespace pcl::acmap::test

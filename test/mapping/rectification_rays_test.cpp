#include "rectification/ray_evidence.h"
#include "rectification_kernels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

MapEvidence
evidenceOf(const std::vector<LevelledPoints>& observations,
           const std::vector<PlanarPose>& poses)
{
  MapEvidence evidence;
  RayEvidence(observations, 0.1).judge(poses, evidence);
  return evidence;
}

/** A frontal wall from x = -1 to 1, with points of one height. */
LevelledPoints
wallAhead(double z, double y = 0, bool normals = true)
{
  LevelledPoints seen;
  for (double x = -1; x < 1.001; x += 0.05) {
    seen.points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
    if (normals)
      seen.normals.emplace_back(0, 0, -1);
  }
  return seen;
}

TEST(RayEvidence, aRightMapIsNotContradicted)
{
  for (const World& world : {makeRoomWorld(61), makeCornerWorld(61)}) {
    const MapEvidence evidence =
        evidenceOf(levelledClouds(world.truth), world.truth.poses);
    EXPECT_GT(evidence.rays, 5000U);
    EXPECT_LT(evidence.near_contradictions, 0.03) << world.name;
    EXPECT_LT(evidence.far_contradictions, 0.03) << world.name;
    EXPECT_GT(evidence.near_rays, 0.9) << world.name;
    EXPECT_GT(evidence.far_rays, 0.1) << world.name;
  }
}

TEST(RayEvidence, driftIsContradicted)
{
  const World world = makeLoopWorld(62);
  const auto observations = levelledClouds(world.truth);
  const auto odometry = drifted(world.truth.poses, {0.06, 0.012, 0.004}, 62);
  const MapEvidence right = evidenceOf(observations, world.truth.poses);
  const MapEvidence wrong = evidenceOf(observations, odometry);
  EXPECT_GT(wrong.near_contradictions + wrong.far_contradictions,
            right.near_contradictions + right.far_contradictions + 0.1);
}

/** A wrong revisit: the last observations of a loop are laid onto another of its walls.
 * Of all rays only a few know about it. */
TEST(RayEvidence, aWrongRevisitIsContradictedByAPairOfGroups)
{
  const World world = makeLoopWorld(66);
  const auto observations = levelledClouds(world.truth);
  auto poses = world.truth.poses;
  const MapEvidence right = evidenceOf(observations, poses);
  EXPECT_LT(right.pair_contradictions, 0.3);
  EXPECT_EQ(right.contradicted_pairs, 0);
  for (std::size_t i = poses.size() - 6; i < poses.size(); ++i)
    poses[i].x += 1.5;
  const MapEvidence wrong = evidenceOf(observations, poses);
  EXPECT_LT(wrong.near_contradictions, 0.25) << "in the whole map it looks harmless";
  EXPECT_GT(wrong.pair_contradictions, 0.5);
  EXPECT_GT(wrong.contradicted_pairs, 0.03);
}

/** A single ray is no evidence of a pair, however many of its rays are contradicted. */
TEST(RayEvidence, fewRaysOfAPairDoNotCount)
{
  LevelledPoints few = wallAhead(5);
  few.points.resize(2);
  few.normals.resize(2);
  LevelledPoints many = wallAhead(5);
  EXPECT_LT(evidenceOf({wallAhead(2), few}, {{}, {}}).pair_contradictions, 0.3);
  EXPECT_GT(evidenceOf({wallAhead(2), many}, {{}, {}}).pair_contradictions, 0.5);
}

TEST(RayEvidence, aCollapseIsContradicted)
{
  const World world = makeCornerWorld(63);
  auto shrunk = world.truth.poses;
  for (PlanarPose& pose : shrunk) {
    pose.x *= 0.3;
    pose.z *= 0.3;
  }
  const MapEvidence evidence = evidenceOf(levelledClouds(world.truth), shrunk);
  EXPECT_GT(evidence.near_contradictions + evidence.far_contradictions, 0.2);
}

TEST(RayEvidence, aWallBehindAWallIsContradicted)
{
  for (const bool normals : {true, false}) {
    const std::vector<PlanarPose> poses(2);
    const MapEvidence evidence =
        evidenceOf({wallAhead(2, 0, normals), wallAhead(5, 0, normals)}, poses);
    EXPECT_EQ(evidence.rays, 82U);
    EXPECT_EQ(evidence.near_contradictions, 1);
    EXPECT_GT(evidence.near_rays, 0.3) << "of the far wall; nothing tells of the near";
    EXPECT_LE(evidence.near_rays, 0.5);
    EXPECT_EQ(evidence.far_rays, 0);
  }
}

TEST(RayEvidence, theSameWallIsConfirmed)
{
  const MapEvidence evidence =
      evidenceOf({wallAhead(4), wallAhead(2)}, {{0, 0, 0}, {0, 2, 0}});
  EXPECT_EQ(evidence.near_contradictions, 0);
  EXPECT_EQ(evidence.near_rays, 1);
}

TEST(RayEvidence, observationsMoreThanSixteenApartAreFar)
{
  for (const std::size_t apart : {16U, 17U}) {
    std::vector<LevelledPoints> observations(apart + 1);
    observations.front() = wallAhead(2);
    observations.back() = wallAhead(5);
    const MapEvidence evidence =
        evidenceOf(observations, std::vector<PlanarPose>(apart + 1));
    EXPECT_EQ(evidence.near_contradictions, apart == 16 ? 1 : 0);
    EXPECT_EQ(evidence.far_contradictions, apart == 16 ? 0 : 1);
  }
}

TEST(RayEvidence, raysPassUnderAndOverWhatIsInAnotherHeight)
{
  LevelledPoints low = wallAhead(5, 0.5);
  low.sensor_height = 0.5;
  const MapEvidence evidence = evidenceOf({wallAhead(2, -0.5), low}, {{}, {}});
  EXPECT_EQ(evidence.near_rays, 0);
  low.sensor_height = -1.5; // looks down, through the other wall at its height
  EXPECT_GT(evidenceOf({wallAhead(2, -0.7), low}, {{}, {}}).near_contradictions, 0.9);
}

TEST(RayEvidence, wallsAlongARayAreNoEvidence)
{
  LevelledPoints beside; // seen edge-on by rays along it
  for (double z = 1; z < 4; z += 0.05) {
    beside.points.push_back(Eigen::Vector3d(0.05, 0, z).cast<float>());
    beside.normals.emplace_back(-1, 0, 0);
  }
  LevelledPoints end;
  end.points.emplace_back(0.05F, 0, 5);
  end.normals.emplace_back(0, 0, -1);
  EXPECT_EQ(evidenceOf({end, beside}, {{0, 0, 0}, {0, 0, 0}}).near_rays, 0);
}

TEST(RayEvidence, theOtherSideOfAWallDoesNotConfirm)
{
  // Two rooms back to back: the walls are in the same cells, with opposite normals.
  const MapEvidence evidence =
      evidenceOf({wallAhead(2.05), wallAhead(2.05)}, {{0, 0, 0}, {0, 4.1, M_PI}});
  EXPECT_EQ(evidence.near_contradictions, 0);
  EXPECT_EQ(evidence.near_rays, 0);
}

TEST(RayEvidence, ofNothingIsNothing)
{
  const LevelledPoints nothing;
  LevelledPoints invalid = wallAhead(2);
  for (Eigen::Vector3f& point : invalid.points)
    point[1] = std::nanf("");
  for (const auto& observations :
       {std::vector<LevelledPoints>{nothing, nothing}, {invalid, invalid}}) {
    const MapEvidence evidence = evidenceOf(observations, {{}, {}});
    EXPECT_EQ(evidence.rays, 0U);
    EXPECT_EQ(evidence.near_rays, 0);
    EXPECT_EQ(evidence.near_contradictions, 0);
  }
}

TEST(RayEvidence, hugeCoordinatesDoNotHoldItUp)
{
  LevelledPoints far = wallAhead(2);
  for (const float z : {1e5F, 1e9F, 1e20F, 3e38F}) {
    far.points[0][2] = z;
    const MapEvidence evidence = evidenceOf({far, wallAhead(2)}, {{}, {}});
    EXPECT_LT(evidence.near_contradictions, 0.1);
  }
}

} // namespace
} // namespace pcl::acmap::test

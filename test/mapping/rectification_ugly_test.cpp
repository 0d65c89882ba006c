#include "rectification_kernels.h"
#include "rectification_runs.h"

#include <pcl/core/exceptions.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr RectificationMode modes[] = {RectificationMode::Guarded,
                                       RectificationMode::Paper};

PointCloud<PointNormal>::Ptr
emptyCloud()
{
  return PointCloud<PointNormal>::Ptr(new PointCloud<PointNormal>);
}

PosedClouds
driftedRoom(std::uint64_t seed)
{
  PosedClouds map = makeRoomWorld(seed).truth;
  map.poses = drifted(map.poses, drift, seed);
  return map;
}

/** Undetermined: no pose changes, and the report names the reason. */
void
expectUndetermined(const PosedClouds& map, const std::string& reason)
{
  for (const RectificationMode mode : modes) {
    Rectification rectification = rectificationOf(map, map.poses);
    rectification.setMode(mode);
    rectification.compute();
    EXPECT_EQ(rectification.getReport().outcome, RectificationOutcome::Undetermined)
        << "mode " << static_cast<int>(mode) << ": "
        << rectification.getReport().reason;
    EXPECT_NE(rectification.getReport().reason.find(reason), std::string::npos)
        << rectification.getReport().reason;
    expectWholeReport(rectification);
    ASSERT_EQ(rectification.getReport().remarks.size(), 1U);
    EXPECT_EQ(rectification.getReport().remarks[0],
              "the poses are as they came: " + rectification.getReport().reason);
    EXPECT_TRUE(isUntouched(rectification, map.poses));
  }
}

TEST(RectificationUgly, nothingWasAdded)
{
  Rectification rectification;
  EXPECT_THROW(rectification.compute(), InitFailedException);
  EXPECT_TRUE(rectification.getConcatenatedCloud()->empty());
  EXPECT_THROW(rectification.getPose(0), BadArgumentException);
  EXPECT_THROW(rectification.getTransformation(0), BadArgumentException);
  EXPECT_THROW(rectification.getTransformedCloud(0), BadArgumentException);
  EXPECT_THROW(rectification.setPose(0, Eigen::Isometry3d::Identity()),
               BadArgumentException);
}

TEST(RectificationUgly, oneObservationFitsAnyhow)
{
  PosedClouds map = driftedRoom(31);
  map.clouds.resize(1);
  map.poses.resize(1);
  expectUndetermined(map, "one observation");
}

TEST(RectificationUgly, emptyCloudsTellNothing)
{
  PosedClouds map;
  for (int i = 0; i < 3; ++i) {
    map.clouds.push_back(emptyCloud());
    map.poses.push_back({0.1 * i, 0, 0});
  }
  expectUndetermined(map, "no finite point");
}

TEST(RectificationUgly, pointsThatAreNotFiniteTellNothing)
{
  PosedClouds map = driftedRoom(32);
  std::size_t points = 0;
  for (const auto& cloud : map.clouds) {
    for (PointNormal& point : *cloud)
      point.y = std::nanf("");
    points += cloud->size();
  }
  expectUndetermined(map, "no finite point");
  Rectification rectification = rectificationOf(map, map.poses);
  rectification.compute();
  EXPECT_EQ(rectification.getReport().points, points);
  EXPECT_EQ(rectification.getReport().invalid_points, points);
}

TEST(RectificationUgly, observationsThatShareNothingTellNothing)
{
  PosedClouds map = driftedRoom(33);
  map.clouds.resize(12);
  map.poses.resize(12);
  for (std::size_t i = 0; i < map.poses.size(); ++i)
    map.poses[i].x += 40 * static_cast<double>(i);
  for (const RectificationMode mode : modes) {
    Rectification rectification = rectificationOf(map, map.poses);
    rectification.setMode(mode);
    rectification.compute();
    if (mode == RectificationMode::Guarded) {
      EXPECT_EQ(rectification.getReport().outcome, RectificationOutcome::Undetermined);
      EXPECT_NE(rectification.getReport().reason.find("no wall in common"),
                std::string::npos);
      EXPECT_TRUE(isUntouched(rectification, map.poses));
    }
    expectWholeReport(rectification);
  }
}

TEST(RectificationUgly, pointsThatAreNotFiniteAreSkipped)
{
  const PosedClouds map = driftedRoom(34);
  Rectification wanted = rectificationOf(map, map.poses);
  wanted.compute();
  PosedClouds laced = map;
  for (auto& cloud : laced.clouds) {
    cloud.reset(new PointCloud<PointNormal>(*cloud));
    PointNormal bad = cloud->front();
    bad.x = std::nanf("");
    cloud->push_back(bad);
    bad = cloud->front();
    bad.z = -std::numeric_limits<float>::infinity();
    cloud->push_back(bad);
  }
  Rectification rectification = rectificationOf(laced, laced.poses);
  rectification.compute();
  EXPECT_EQ(rectification.getReport().invalid_points, 2 * map.clouds.size());
  EXPECT_TRUE(haveSamePoses(rectification, wanted));
}

TEST(RectificationUgly, someEmptyCloudsDoNotMatter)
{
  const World world = makeRoomWorld(35);
  PosedClouds map{world.truth.clouds, drifted(world.truth.poses, drift, 35)};
  for (const std::size_t i : {4, 5, 6, 20})
    map.clouds[i] = emptyCloud();
  Rectification rectification = rectificationOf(map, map.poses);
  rectification.compute();
  expectWholeReport(rectification);
  EXPECT_LT(rmsError(planarPosesOf(rectification), world.truth.poses),
            0.6 * rmsError(map.poses, world.truth.poses));
}

TEST(RectificationUgly, halfOfTheNormalsMayBeMissing)
{
  const World world = makeRoomWorld(36);
  const auto odometry = drifted(world.truth.poses, drift, 36);
  for (const auto& cloud : world.truth.clouds)
    for (std::size_t p = 0; p < cloud->size(); p += 2)
      (*cloud)[p].getNormalVector3fMap().setConstant(std::nanf(""));
  Rectification rectification = rectificationOf(world.truth, odometry);
  rectification.compute();
  expectWholeReport(rectification);
  EXPECT_LT(rmsError(planarPosesOf(rectification), world.truth.poses),
            0.6 * rmsError(odometry, world.truth.poses));
}

TEST(RectificationUgly, pointTypesWithoutNormalsAreRectified)
{
  const World world = makeRoomWorld(37);
  const auto odometry = drifted(world.truth.poses, drift, 37);
  EntropyRectification<PointXYZ> rectification;
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
    for (const PointNormal& point : *world.truth.clouds[i])
      cloud->push_back({point.x, point.y, point.z});
    rectification.addPointCloud(cloud, isometryOf(odometry[i]));
  }
  rectification.compute();
  std::vector<PlanarPose> poses;
  for (std::size_t i = 0; i < odometry.size(); ++i)
    poses.push_back(planarPartOf(rectification.getPose(i)));
  EXPECT_LT(rmsError(poses, world.truth.poses),
            0.6 * rmsError(odometry, world.truth.poses))
      << rectification.getReport().reason;
}

TEST(RectificationUgly, farFromTheOriginWorksAsNearIt)
{
  const World world = makeRoomWorld(38);
  auto truth = world.truth.poses;
  auto odometry = drifted(truth, drift, 38);
  for (auto* poses : {&truth, &odometry})
    for (PlanarPose& pose : *poses)
      pose = {pose.x + 1e7, pose.z - 1e7, pose.theta};
  Rectification rectification = rectificationOf(world.truth, odometry);
  rectification.compute();
  EXPECT_EQ(rectification.getReport().outcome, RectificationOutcome::Rectified);
  EXPECT_LT(rmsError(planarPosesOf(rectification), truth),
            0.5 * rmsError(odometry, truth));
}

TEST(RectificationUgly, posesAtTheEndOfTheWorldAreTaken)
{
  PosedClouds map = driftedRoom(39);
  double maximum = 0;
  for (const PlanarPose& pose : map.poses)
    maximum = std::max(maximum, pose.x);
  for (PlanarPose& pose : map.poses)
    pose.x += 1e9 - maximum;
  for (const RectificationMode mode : modes) {
    Rectification rectification = rectificationOf(map, map.poses);
    rectification.setMode(mode);
    EXPECT_NO_THROW(rectification.compute());
    for (const double moved : rectification.getReport().moved)
      EXPECT_LT(moved, 5);
  }
}

TEST(RectificationUgly, pointsFarOutOfTheBuildingAreNoReasonToHang)
{
  for (const float far : {1e5F, 1e7F, 1e9F, 3e38F})
    for (const RectificationMode mode : modes) {
      SCOPED_TRACE(far);
      const PosedClouds map = driftedRoom(40);
      (*map.clouds[3])[0].x = far;
      (*map.clouds[4])[7].z = -far;
      Rectification rectification = rectificationOf(map, map.poses);
      rectification.setMode(mode);
      rectification.compute();
      expectWholeReport(rectification);
      if (far >= 1e7F) { // too large for a grid: there is no entropy
        EXPECT_EQ(rectification.getReport().outcome, RectificationOutcome::Undetermined)
            << rectification.getReport().reason;
        EXPECT_TRUE(isUntouched(rectification, map.poses));
      }
    }
}

TEST(RectificationUgly, mapsTooWideForTheFinestBinsAreTold)
{
  PosedClouds map = makeRoomWorld(43).truth;
  map.clouds.resize(3);
  map.poses.resize(3);
  Rectification rectification = rectificationOf(map, map.poses);
  rectification.setBinSize(0.003);
  rectification.compute();
  expectWholeReport(rectification);
  const std::vector<std::string>& remarks = rectification.getReport().remarks;
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks.front(),
            "the map is too wide for bins of 0.003 m: only parts of it were searched "
            "with them");
}

TEST(RectificationUgly, theSameCloudOverAndOverStays)
{
  const PosedClouds room = makeRoomWorld(41).truth;
  PosedClouds map;
  for (int i = 0; i < 20; ++i) {
    map.clouds.push_back(room.clouds[0]);
    map.poses.push_back({2, 3, 0.4});
  }
  Rectification rectification = rectificationOf(map, map.poses);
  rectification.compute();
  expectWholeReport(rectification);
  EXPECT_LT(largestOf(rectification.getReport().moved), 0.05);
}

TEST(RectificationUgly, aRobotMayTurnTwoHundredTimes)
{
  PosedClouds map;
  std::vector<PlanarPose> path;
  for (int i = 0; i < 700; ++i)
    path.push_back({4 + 0.3 * std::sin(0.1 * i), 2.2, 1.8 * i});
  LaserSettings laser;
  laser.beams = 24;
  map = scanAlong(makeRoomPlan(), path, laser, 42);
  Rectification rectification = rectificationOf(map, path);
  EXPECT_NO_THROW(rectification.compute());
  EXPECT_LT(largestOf(rectification.getReport().moved), 0.5);
}

TEST(RectificationUgly, anyOdometryNoiseThatIsLegalIsTaken)
{
  for (const OdometryNoise& noise : {OdometryNoise{1e-6, 0, 1e-6, 0},
                                     OdometryNoise{1e3, 10, 10, 10},
                                     OdometryNoise{1e3, 0, 1e-6, 0}}) {
    PosedClouds map = driftedRoom(43);
    map.clouds.resize(10);
    map.poses.resize(10);
    Rectification rectification = rectificationOf(map, map.poses);
    rectification.setOdometryNoise(noise);
    EXPECT_NO_THROW(rectification.compute());
    for (std::size_t i = 0; i < map.poses.size(); ++i)
      EXPECT_TRUE(rectification.getPose(i).matrix().allFinite());
  }
}

TEST(RectificationUgly, badObservationsAreRefusedAndChangeNothing)
{
  const PosedClouds map = driftedRoom(44);
  Rectification rectification = rectificationOf(map, map.poses);
  const Eigen::Isometry3d identity = Eigen::Isometry3d::Identity();
  EXPECT_THROW(rectification.addPointCloud(nullptr, identity), BadArgumentException);
  const std::size_t points = map.clouds[0]->size();
  for (const float bad :
       {-1.0F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    std::vector<float> weights(points, 1.0F);
    weights[points / 2] = bad;
    EXPECT_THROW(rectification.addPointCloud(map.clouds[0], identity, weights),
                 BadArgumentException);
  }
  for (const std::size_t size : {points - 1, points + 1})
    EXPECT_THROW(rectification.addPointCloud(
                     map.clouds[0], identity, std::vector<float>(size, 1.0F)),
                 BadArgumentException);
  std::vector<Eigen::Isometry3d> bad_poses;
  for (const double bad : {std::nan(""), infinity, 1.1e9, -1.1e9}) {
    bad_poses.push_back(identity);
    bad_poses.back().translation().y() = bad;
  }
  for (const double bad : {-1.0, 0.0, 1.01, std::nan("")}) {
    bad_poses.push_back(identity);
    bad_poses.back().matrix()(1, 1) = bad;
  }
  for (const Eigen::Isometry3d& bad : bad_poses) {
    EXPECT_THROW(rectification.addPointCloud(map.clouds[0], bad), BadArgumentException);
    EXPECT_THROW(rectification.setPose(0, bad), BadArgumentException);
  }
  EXPECT_THROW(rectification.setPose(map.poses.size(), identity), BadArgumentException);
  EXPECT_EQ(rectification.getNumberOfPointClouds(), map.poses.size());
  EXPECT_TRUE(isUntouched(rectification, map.poses));
}

TEST(RectificationUgly, theKernelRefusesPosesThatAreNotThoseOfTheObservations)
{
  const PosedClouds map = driftedRoom(46);
  const auto observations = levelledClouds(map);
  EntropyRectificationReport report;
  auto poses = map.poses;
  poses.pop_back();
  EXPECT_THROW(rectify(observations, poses, {}, Progress(), report),
               BadArgumentException);
  poses.push_back({std::nan(""), 0, 0});
  EXPECT_THROW(rectify(observations, poses, {}, Progress(), report),
               BadArgumentException);
  EXPECT_EQ(rectify({}, {}, {}, Progress(), report).size(), 0U);
}

TEST(RectificationUgly, pointsWithoutWeightAreNotThere)
{
  const PosedClouds map = driftedRoom(45);
  Rectification rectification;
  for (std::size_t i = 0; i < map.clouds.size(); ++i)
    rectification.addPointCloud(map.clouds[i],
                                isometryOf(map.poses[i]),
                                std::vector<float>(map.clouds[i]->size(), 0));
  rectification.compute();
  EXPECT_EQ(rectification.getReport().outcome, RectificationOutcome::Undetermined)
      << rectification.getReport().reason;
  EXPECT_TRUE(isUntouched(rectification, map.poses));
}

} // namespace
} // namespace pcl::acmap::test

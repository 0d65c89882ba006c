#include "rectification_runs.h"

#include <pcl/common/transforms.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/core/trajectory.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** A room with drifting poses that is rectified in a fraction of a second. */
struct RoomWithDrift {
  explicit RoomWithDrift(std::uint64_t seed)
  : world(makeRoomWorld(seed))
  , odometry(drifted(world.truth.poses, drift, seed))
  {}

  Rectification
  rectification() const
  {
    return rectificationOf(world.truth, odometry);
  }

  World world;
  std::vector<PlanarPose> odometry;
};

/** Height, tilt and roll of a hand-held camera, different for each observation. */
Eigen::Isometry3d
heldAt(std::size_t i)
{
  const double t = static_cast<double>(i);
  Eigen::Isometry3d held(
      Eigen::AngleAxisd(0.2 * std::sin(t), Eigen::Vector3d::UnitX()) *
      Eigen::AngleAxisd(0.1 * std::cos(2 * t), Eigen::Vector3d::UnitZ()));
  held.translation() << 0, -0.8 + 0.1 * std::sin(3 * t), 0;
  return held;
}

/** The room seen by a hand-held camera, with arbitrary 3D poses. */
Rectification
heldInSpace(const RoomWithDrift& room)
{
  Rectification rectification;
  for (std::size_t i = 0; i < room.odometry.size(); ++i) {
    const Eigen::Isometry3d held = heldAt(i);
    PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
    transformPointCloudWithNormals(
        *room.world.truth.clouds[i],
        *cloud,
        Eigen::Affine3f(held.inverse().cast<float>().matrix()));
    rectification.addPointCloud(cloud, isometryOf(room.odometry[i]) * held);
  }
  return rectification;
}

TEST(EntropyRectification, heightsAndTiltsStay)
{
  const RoomWithDrift room(21);
  Rectification rectification = heldInSpace(room);
  std::vector<Eigen::Isometry3d> given;
  for (std::size_t i = 0; i < room.odometry.size(); ++i)
    given.push_back(rectification.getPose(i));
  rectification.compute();
  ASSERT_EQ(rectification.getReport().outcome, RectificationOutcome::Rectified);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Eigen::Isometry3d& pose = rectification.getPose(i);
    EXPECT_TRUE(isRigid(pose));
    EXPECT_NEAR(pose.translation().y(), given[i].translation().y(), 1e-12);
    // A rotation about y does not change the vertical direction in the camera frame.
    EXPECT_LT((pose.linear().row(1) - given[i].linear().row(1)).norm(), 1e-12);
  }
  EXPECT_LT(rmsError(planarPosesOf(rectification), room.world.truth.poses),
            0.5 * rmsError(room.odometry, room.world.truth.poses));
}

/** The same map in another frame has the same result: the vertical may be any axis. */
TEST(EntropyRectification, theVerticalMayBeAnyDirection)
{
  const RoomWithDrift room(21);
  Rectification level = heldInSpace(room);
  level.compute();
  for (const Eigen::Vector3d& up :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 2, 3)}) {
    const Eigen::Quaterniond turn = smallestRotation(-Eigen::Vector3d::UnitY(), up);
    Rectification turned = heldInSpace(room);
    for (std::size_t i = 0; i < room.odometry.size(); ++i)
      turned.setPose(i, turn * turned.getPose(i));
    turned.setUpDirection(up);
    ASSERT_TRUE(turned.getUpDirection());
    EXPECT_TRUE(turned.getUpDirection()->isApprox(up.normalized()));
    turned.compute();
    ASSERT_EQ(turned.getReport().outcome, RectificationOutcome::Rectified);
    double largest = 0; // the turn about the vertical is arbitrary: compare distances
    for (std::size_t i = 1; i < room.odometry.size(); ++i)
      largest = std::max(
          largest,
          std::abs((turned.getPose(i).translation() - turned.getPose(0).translation())
                       .norm() -
                   (level.getPose(i).translation() - level.getPose(0).translation())
                       .norm()));
    EXPECT_LT(largest, 0.02) << up.transpose();
  }
}

/** Nobody says which axis is up: ROS has z, cameras -y, others y. */
TEST(EntropyRectification, theVerticalIsFound)
{
  const RoomWithDrift room(21);
  Rectification level = heldInSpace(room);
  level.setUpDirection(-Eigen::Vector3d::UnitY());
  level.compute();
  for (const Eigen::Vector3d& up :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, -1, 0)}) {
    const Eigen::Quaterniond turn = smallestRotation(-Eigen::Vector3d::UnitY(), up);
    Rectification turned = heldInSpace(room);
    for (std::size_t i = 0; i < room.odometry.size(); ++i)
      turned.setPose(i, turn * turned.getPose(i));
    turned.compute();
    const EntropyRectificationReport& report = turned.getReport();
    EXPECT_TRUE(report.is_up_found) << up.transpose();
    EXPECT_GT(report.up.dot(up), std::cos(0.5 * M_PI / 180)) << report.up.transpose();
    ASSERT_EQ(report.outcome, RectificationOutcome::Rectified);
    std::vector<Eigen::Isometry3d> found;
    for (std::size_t i = 0; i < room.odometry.size(); ++i)
      found.push_back(turn.inverse() * turned.getPose(i));
    for (std::size_t i = 1; i < found.size(); ++i)
      EXPECT_LT((found[i].translation() - level.getPose(i).translation()).norm(), 0.02);
  }
}

TEST(EntropyRectification, movesAndTurnsAreThoseOfThePoses)
{
  const RoomWithDrift room(22);
  Rectification rectification = room.rectification();
  rectification.compute();
  const auto poses = planarPosesOf(rectification);
  const EntropyRectificationReport& report = rectification.getReport();
  ASSERT_EQ(report.moved.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PlanarPose& was = room.odometry[i];
    EXPECT_NEAR(
        report.moved[i], std::hypot(poses[i].x - was.x, poses[i].z - was.z), 1e-9);
    EXPECT_NEAR(report.turned[i],
                std::abs(std::remainder(poses[i].theta - was.theta, 2 * M_PI)),
                1e-9);
  }
}

TEST(EntropyRectification, cloudsAreWhereThePosesSay)
{
  const RoomWithDrift room(23);
  Rectification rectification = room.rectification();
  rectification.compute();
  std::size_t next = 0;
  const auto all = rectification.getConcatenatedCloud();
  for (std::size_t i = 0; i < room.odometry.size(); ++i) {
    const Eigen::Isometry3d& pose = rectification.getPose(i);
    EXPECT_TRUE(rectification.getTransformation(i).matrix().isApprox(
        pose.cast<float>().matrix(), 1e-6F));
    const PointCloud<PointNormal>& source = *room.world.truth.clouds[i];
    const auto cloud = rectification.getTransformedCloud(i);
    ASSERT_EQ(cloud->size(), source.size());
    ASSERT_LE(next + source.size(), all->size());
    for (std::size_t p = 0; p < source.size(); ++p, ++next) {
      const Eigen::Vector3d place = pose * source[p].getVector3fMap().cast<double>();
      const Eigen::Vector3d normal =
          pose.linear() * source[p].getNormalVector3fMap().cast<double>();
      EXPECT_LT(((*cloud)[p].getVector3fMap().cast<double>() - place).norm(), 1e-5);
      EXPECT_LT(((*cloud)[p].getNormalVector3fMap().cast<double>() - normal).norm(),
                1e-5);
      EXPECT_EQ((*all)[next].getVector3fMap(), (*cloud)[p].getVector3fMap());
    }
  }
  EXPECT_EQ(next, all->size());
}

TEST(EntropyRectification, setPoseStartsAgain)
{
  const RoomWithDrift room(24);
  Rectification fresh = room.rectification();
  fresh.compute();
  Rectification rectification =
      rectificationOf(room.world.truth, room.world.truth.poses);
  rectification.compute();
  for (std::size_t i = 0; i < room.odometry.size(); ++i)
    rectification.setPose(i, isometryOf(room.odometry[i]));
  EXPECT_TRUE(isUntouched(rectification, room.odometry));
  rectification.compute();
  EXPECT_TRUE(haveSamePoses(rectification, fresh));
}

TEST(EntropyRectification, neitherRunsNorObjectsDifferInAByte)
{
  const RoomWithDrift room(25);
  for (const RectificationMode mode :
       {RectificationMode::Guarded, RectificationMode::Paper}) {
    Rectification wanted = room.rectification();
    wanted.setMode(mode);
    wanted.setNumberOfThreads(1);
    wanted.compute();
    for (const unsigned threads : {1U, 2U, 8U}) {
      Rectification other = room.rectification();
      other.setMode(mode);
      other.setNumberOfThreads(threads);
      other.compute();
      EXPECT_TRUE(haveSamePoses(other, wanted)) << threads << " threads";
      EXPECT_EQ(other.getReport().reason, wanted.getReport().reason);
      EXPECT_EQ(other.getReport().moved, wanted.getReport().moved);
    }
    const Rectification before = wanted;
    wanted.compute();
    EXPECT_TRUE(haveSamePoses(wanted, before)) << "second run";
  }
}

/** Bins and the cells of the rays start at multiples of 0.1 to 0.4 m, of which 16 m are
 * a multiple. */
TEST(EntropyRectification, whereTheMapLiesDoesNotMatter)
{
  constexpr double rounding = 1e-5; // metres, radians: bins are floats
  const RoomWithDrift room(26);
  Rectification here = room.rectification();
  here.compute();
  ASSERT_EQ(here.getReport().outcome, RectificationOutcome::Rectified);
  auto away = room.odometry;
  for (PlanarPose& pose : away)
    pose = {pose.x + 16, pose.z - 48, pose.theta};
  Rectification there = rectificationOf(room.world.truth, away);
  there.compute();
  EXPECT_EQ(there.getReport().outcome, RectificationOutcome::Rectified);
  for (std::size_t i = 0; i < away.size(); ++i) {
    EXPECT_NEAR(there.getReport().moved[i], here.getReport().moved[i], rounding);
    EXPECT_NEAR(there.getReport().turned[i], here.getReport().turned[i], rounding);
  }
}

TEST(EntropyRectification, weightsOfOneAreNone)
{
  const RoomWithDrift room(27);
  Rectification plain = room.rectification(), weighted, other;
  for (std::size_t i = 0; i < room.odometry.size(); ++i) {
    const auto& cloud = room.world.truth.clouds[i];
    std::vector<float> weights(cloud->size(), 1.0F);
    weighted.addPointCloud(cloud, isometryOf(room.odometry[i]), weights);
    weights.assign(cloud->size() / 2, 0.1F);
    weights.resize(cloud->size(), 1.0F);
    other.addPointCloud(cloud, isometryOf(room.odometry[i]), weights);
  }
  for (Rectification* one : {&plain, &weighted, &other})
    one->compute();
  EXPECT_TRUE(haveSamePoses(plain, weighted));
  EXPECT_FALSE(haveSamePoses(plain, other));
}

TEST(EntropyRectification, cancelledHalfWayChangesNothing)
{
  const RoomWithDrift room(28);
  for (const RectificationMode mode :
       {RectificationMode::Guarded, RectificationMode::Paper}) {
    Rectification fresh = room.rectification();
    fresh.setMode(mode);
    int calls = 0;
    double last = 0;
    fresh.setProgressCallback([&](double fraction, const std::string& step) {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1);
      EXPECT_FALSE(step.empty());
      last = fraction;
      return ++calls > 0;
    });
    fresh.compute();
    ASSERT_GT(calls, 4);

    Rectification rectification = room.rectification();
    rectification.setMode(mode);
    rectification.setProgressCallback(
        [half = calls / 2](double, const std::string&) mutable { return half-- > 0; });
    EXPECT_THROW(rectification.compute(), CancelledException);
    EXPECT_TRUE(isUntouched(rectification, room.odometry));
    EXPECT_TRUE(rectification.getReport().reason.empty()) << "there was no earlier run";
    rectification.setProgressCallback({});
    rectification.compute();
    EXPECT_TRUE(haveSamePoses(rectification, fresh));
  }
}

TEST(EntropyRectification, smoothingIsThatOfPaperMode)
{
  const RoomWithDrift room(30);
  Rectification plain = room.rectification();
  EXPECT_FALSE(plain.getSmoothing()) << "one bin";
  for (const double bad : {-0.1, 1001.0, std::nan("")})
    EXPECT_THROW(plain.setSmoothing(bad), BadArgumentException);
  for (const RectificationMode mode :
       {RectificationMode::Guarded, RectificationMode::Paper}) {
    Rectification usual = room.rectification(), same = usual, wide = usual;
    same.setSmoothing(same.getBinSize());
    wide.setSmoothing(0.3);
    EXPECT_EQ(wide.getSmoothing(), 0.3);
    for (Rectification* one : {&usual, &same, &wide}) {
      one->setMode(mode);
      one->compute();
    }
    EXPECT_TRUE(haveSamePoses(usual, same));
    EXPECT_EQ(haveSamePoses(usual, wide), mode == RectificationMode::Guarded);
    wide.setSmoothing(100.1 * wide.getBinSize());
    if (mode == RectificationMode::Paper) {
      EXPECT_THROW(wide.compute(), BadArgumentException);
    }
  }
}

TEST(EntropyRectification, clearBeginsAnew)
{
  const RoomWithDrift room(29);
  Rectification fresh = room.rectification();
  fresh.compute();
  Rectification rectification =
      rectificationOf(room.world.truth, room.world.truth.poses);
  rectification.compute();
  rectification.clear();
  EXPECT_EQ(rectification.getNumberOfPointClouds(), 0U);
  EXPECT_TRUE(rectification.getConcatenatedCloud()->empty());
  for (std::size_t i = 0; i < room.odometry.size(); ++i)
    EXPECT_EQ(rectification.addPointCloud(room.world.truth.clouds[i],
                                          isometryOf(room.odometry[i])),
              i);
  rectification.compute();
  EXPECT_TRUE(haveSamePoses(rectification, fresh));
}

} // namespace
} // namespace pcl::acmap::test

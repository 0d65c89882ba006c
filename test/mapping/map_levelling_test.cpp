#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/mapping/map_levelling.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

namespace pcl::acmap::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Levelling = MapLevelling<PointNormal>;

constexpr double degree = M_PI / 180;

/** Points with noisy normals on floor, ceiling and walls of a corridor, 12 m long and
 * 2.6 m high;
 * z points up, the sensor is 1.2 m above the floor. */
struct Corridor {
  std::vector<Vector3d> points, normals;

  explicit Corridor(std::uint64_t seed, bool has_floor = true, double width = 2)
  {
    Random random(seed);
    const Vector3d half(6, width / 2, 1.3);
    const Vector3d areas(half.y() * half.z(), half.z() * half.x(), half.x() * half.y());
    for (int i = 0; i < 30000; ++i) {
      const double place = random.uniform() * areas.sum();
      const int axis = place < areas.x() ? 0 : place < areas.x() + areas.y() ? 1 : 2;
      if (axis == 2 && !has_floor)
        continue;
      const double sign = random.uniform() < 0.5 ? -1 : 1;
      Vector3d point, normal = -sign * Vector3d::Unit(axis);
      for (int k = 0; k < 3; ++k) {
        point[k] = half[k] * (k == axis ? sign : 2 * random.uniform() - 1);
        normal[k] += 0.08 * random.normal();
      }
      points.push_back(point + Vector3d(0, 0, 0.1));
      normals.push_back(normal.normalized());
    }
  }

  /** Seen from a pose in the corridor's frame; a camera sees only what is in front. */
  PointCloud<PointNormal>::Ptr
  seenFrom(const Isometry3d& T_corridor_sensor, bool is_camera) const
  {
    PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
    const Isometry3d T_sensor_corridor = T_corridor_sensor.inverse();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3d place = T_sensor_corridor * points[i];
      if (is_camera && place.z() < 0.5 * place.norm())
        continue;
      PointNormal point;
      point.getVector3fMap() = place.cast<float>();
      point.getNormalVector3fMap() =
          (T_sensor_corridor.linear() * normals[i]).cast<float>();
      cloud->push_back(point);
    }
    return cloud;
  }
};

/** The frame of a camera that looks along x: x right, y down, z forward. */
Eigen::Matrix3d
cameraAxes()
{
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return axes;
}

/** Poses along the corridor, with turns about the vertical. */
std::vector<Isometry3d>
path(const Eigen::Matrix3d& mount)
{
  std::vector<Isometry3d> poses;
  for (int i = 0; i < 6; ++i) {
    Isometry3d pose(AngleAxisd(0.3 * i, Vector3d::UnitZ()));
    pose.translation() << i - 3.0, 0.1 * i, 0;
    poses.push_back(pose * Isometry3d(Quaterniond(mount)));
  }
  return poses;
}

/** A corridor in the frame T_map_corridor. */
Levelling
levellingOf(const Corridor& corridor,
            const std::vector<Isometry3d>& poses,
            const Isometry3d& T_map_corridor,
            bool is_camera)
{
  Levelling levelling;
  for (const Isometry3d& pose : poses)
    levelling.addPointCloud(corridor.seenFrom(pose, is_camera), T_map_corridor * pose);
  return levelling;
}

TEST(MapLevelling, TheFrameOfATiltedCameraBecomesLevel)
{
  const Corridor corridor(1);
  const Vector3d down = -Vector3d::UnitZ();
  for (const double pitch : {-30.0, -12.0, 4.0, 25.0})
    for (const double roll : {-8.0, 0.0, 5.0}) {
      const Eigen::Matrix3d mount =
          cameraAxes() * (AngleAxisd(pitch * degree, Vector3d::UnitX()) *
                          AngleAxisd(roll * degree, Vector3d::UnitZ()))
                             .toRotationMatrix();
      const std::vector<Isometry3d> poses = path(mount);
      const Isometry3d T_map_corridor = poses[0].inverse();
      Levelling levelling = levellingOf(corridor, poses, T_map_corridor, true);
      levelling.compute();
      const MapLevellingReport& report = levelling.getReport();
      EXPECT_TRUE(report.found);
      EXPECT_EQ(report.axis, -Vector3d::UnitY());
      const Vector3d floor = levelling.getRotation() * (T_map_corridor.linear() * down);
      EXPECT_LT(std::acos(floor.y()) / degree, 0.3) << pitch << " " << roll;
      const double tilt = std::acos(-(T_map_corridor.linear() * -down).y());
      EXPECT_NEAR(report.tilt / degree, tilt / degree, 0.3);
      for (std::size_t i = 0; i < poses.size(); ++i)
        EXPECT_TRUE(levelling.getPose(i).isApprox(
            levelling.getRotation() * T_map_corridor * poses[i], 1e-12));
    }
}

TEST(MapLevelling, TheVerticalOfAScannerIsFound)
{
  const Corridor corridor(2);
  const std::vector<Isometry3d> poses = path(Eigen::Matrix3d::Identity());
  const Quaterniond tilt(AngleAxisd(6 * degree, Vector3d(1, 2, 0).normalized()));
  Levelling levelling = levellingOf(corridor, poses, Isometry3d(tilt), false);
  levelling.compute();
  EXPECT_EQ(levelling.getReport().axis, Vector3d::UnitZ());
  EXPECT_NEAR(levelling.getReport().tilt / degree, 6, 0.3);
  EXPECT_NE(levelling.getReport().reason.find("turned about its z axis"),
            std::string::npos);

  // the same with y down, as in the frame of a camera that looks all around
  levelling = levellingOf(corridor,
                          path(cameraAxes()),
                          Isometry3d(Quaterniond(cameraAxes())).inverse(),
                          false);
  levelling.compute();
  EXPECT_EQ(levelling.getReport().axis, -Vector3d::UnitY());
  EXPECT_EQ(levelling.getReport().tilt, 0);
}

TEST(MapLevelling, OneScanIsThinAlongItsVertical)
{
  const Corridor corridor(3, true, 6);
  Levelling levelling =
      levellingOf(corridor, {Isometry3d::Identity()}, Isometry3d::Identity(), false);
  levelling.compute();
  EXPECT_EQ(levelling.getReport().axis, Vector3d::UnitZ());
  EXPECT_TRUE(levelling.getReport().found);
}

TEST(MapLevelling, WallsAloneShowTheVertical)
{
  const Corridor corridor(4, false);
  const Quaterniond tilt(AngleAxisd(9 * degree, Vector3d::UnitX()));
  Levelling levelling = levellingOf(
      corridor, path(cameraAxes()), Isometry3d(tilt * cameraAxes().transpose()), true);
  levelling.compute();
  EXPECT_NEAR(levelling.getReport().tilt / degree, 9, 0.4);
}

TEST(MapLevelling, ALevelMapKeepsItsPosesBitwise)
{
  const Corridor corridor(5);
  const std::vector<Isometry3d> poses = path(cameraAxes());
  const Isometry3d T_map_corridor(
      Quaterniond(AngleAxisd(0.3 * degree, Vector3d::UnitX())) *
      Quaterniond(cameraAxes()).inverse());
  Levelling levelling = levellingOf(corridor, poses, T_map_corridor, true);
  levelling.compute();
  EXPECT_TRUE(levelling.getReport().found);
  EXPECT_EQ(levelling.getReport().tilt, 0);
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_EQ(levelling.getPose(i).matrix(), (T_map_corridor * poses[i]).matrix());
}

TEST(MapLevelling, NothingIsTurnedWhereSurfacesShowNoVertical)
{
  Random random(6);
  PointCloud<PointNormal>::Ptr ball(new PointCloud<PointNormal>);
  for (int i = 0; i < 4000; ++i) {
    PointNormal point;
    const Vector3d normal(random.normal(), random.normal(), random.normal());
    point.getNormalVector3fMap() = normal.normalized().cast<float>();
    point.getVector3fMap() = Eigen::Vector3f(0, 0, 5) - point.getNormalVector3fMap();
    ball->push_back(point);
  }
  Levelling levelling;
  const Isometry3d pose(AngleAxisd(0.4, Vector3d::UnitX()));
  levelling.addPointCloud(ball, pose);
  levelling.compute();
  EXPECT_FALSE(levelling.getReport().found);
  EXPECT_EQ(levelling.getPose(0).matrix(), pose.matrix());
  ASSERT_EQ(levelling.getReport().remarks.size(), 1U);
  EXPECT_NE(levelling.getReport().remarks[0].find("not levelled"), std::string::npos);
}

TEST(MapLevelling, FewNoisyNormalsDoNotTiltALevelMap)
{
  int turned = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
    for (int i = 0; i < 300; ++i) {
      PointNormal point;
      point.getVector3fMap() =
          Eigen::Vector3f(0.1F * static_cast<float>(random.normal()), 0, 4);
      for (int k = 0; k < 3; ++k)
        point.getNormalVector3fMap()[k] = 0.15F * static_cast<float>(random.normal());
      point.getNormalVector3fMap()[i % 3] += 1;
      cloud->push_back(point);
    }
    Levelling levelling;
    levelling.addPointCloud(cloud, Isometry3d::Identity());
    levelling.compute();
    EXPECT_TRUE(levelling.getReport().found);
    turned += levelling.getReport().tilt > 0 ? 1 : 0;
  }
  EXPECT_EQ(turned, 0);
}

TEST(MapLevelling, AGivenDirectionIsTakenExactly)
{
  const Corridor corridor(7);
  Levelling levelling = levellingOf(corridor,
                                    path(cameraAxes()),
                                    Isometry3d(Quaterniond(cameraAxes())).inverse(),
                                    true);
  levelling.setUpDirection(Vector3d(0, 0.2, 2));
  levelling.compute();
  EXPECT_EQ(levelling.getReport().axis, Vector3d::UnitZ());
  EXPECT_NEAR(levelling.getReport().tilt, std::atan(0.1), 1e-12);
  EXPECT_LT(
      (levelling.getRotation() * Vector3d(0, 0.2, 2).normalized() - Vector3d::UnitZ())
          .norm(),
      1e-12);
  levelling.resetUpDirection();
  levelling.compute();
  EXPECT_EQ(levelling.getReport().axis, -Vector3d::UnitY());
}

TEST(MapLevelling, NonsenseIsRefusedAndNaNCounted)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Levelling levelling;
  EXPECT_THROW(levelling.compute(), InitFailedException);
  EXPECT_THROW(levelling.setUpDirection(Vector3d::Zero()), BadArgumentException);
  EXPECT_THROW(levelling.setUpDirection(Vector3d(0, std::nan(""), 1)),
               BadArgumentException);
  EXPECT_THROW(levelling.setUpDirection(Vector3d(0, infinity, 1)),
               BadArgumentException);
  EXPECT_THROW(levelling.addPointCloud(nullptr, Isometry3d::Identity()),
               BadArgumentException);
  PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
  EXPECT_THROW(levelling.addPointCloud(cloud, Isometry3d::Identity(), {1}),
               BadArgumentException);
  levelling.addPointCloud(cloud, Isometry3d::Identity());
  cloud->resize(3);
  cloud->points[1].y = std::numeric_limits<float>::quiet_NaN();
  levelling.compute();
  EXPECT_EQ(levelling.getReport().points, 3U);
  EXPECT_EQ(levelling.getReport().invalid_points, 1U);
  EXPECT_FALSE(levelling.getReport().found);
}

TEST(MapLevelling, ThreadsDoNotMatterAndACallbackStops)
{
  const Corridor corridor(8);
  const Quaterniond tilt(AngleAxisd(14 * degree, Vector3d(1, 0, 1).normalized()));
  Levelling levelling = levellingOf(
      corridor, path(cameraAxes()), Isometry3d(tilt * cameraAxes().transpose()), true);
  levelling.setNumberOfThreads(1);
  levelling.compute();
  const Eigen::Matrix4d pose = levelling.getPose(2).matrix();
  levelling.setNumberOfThreads(8);
  levelling.compute();
  EXPECT_EQ(levelling.getPose(2).matrix(), pose);
  levelling.setProgressCallback([](double, const std::string&) { return false; });
  levelling.setUpDirection(Vector3d::UnitZ());
  EXPECT_THROW(levelling.compute(), CancelledException);
  EXPECT_EQ(levelling.getPose(2).matrix(), pose);
}

} // namespace
} // namespace pcl::acmap::test

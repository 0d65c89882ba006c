#include "test_data.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/random.h>
#include <pcl/core/sensor_evidence.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::acmap::test {
namespace {

using Points = std::vector<Eigen::Vector3f>;

SensorEvidence
evidenceOf(const Points& points)
{
  return assessSensor(PointView(points.data(), sizeof points.front(), points.size()),
                      0,
                      Eigen::Vector3d::Zero());
}

/** Range of a ray from the origin to the walls of a room, or to a box that stands in it. */
double
rangeInRoom(const Eigen::Vector3d& ray)
{
  const Eigen::AlignedBox3d room(Eigen::Vector3d(-3, -2, -1.5),
                                 Eigen::Vector3d(4, 5, 1.3)),
      cupboard(Eigen::Vector3d(1.5, 1, -1.5), Eigen::Vector3d(2.2, 2, 0.4));
  double range = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    range = std::min(range,
                     (ray[axis] > 0 ? room.max()[axis] : room.min()[axis]) / ray[axis]);
  const Eigen::Array3d a = cupboard.min().array() / ray.array(),
                       b = cupboard.max().array() / ray.array();
  const double from = a.min(b).maxCoeff(), to = a.max(b).minCoeff();
  return from > 0 && from < to ? std::min(range, from) : range;
}

/** A scan with several beams, column by column. */
Points
makeScan(int beams, double low, double high, double noise)
{
  constexpr int columns = 720;
  constexpr double degree = M_PI / 180;
  Random random(5);
  Points points;
  for (int column = 0; column < columns; ++column)
    for (int beam = 0; beam < beams; ++beam) {
      const double turn = 2 * M_PI * (column + 0.37) / columns,
                   rise = (low + (high - low) * (beam + 0.13) / beams) * degree;
      const Eigen::Vector3d ray(std::cos(rise) * std::cos(turn),
                                std::cos(rise) * std::sin(turn),
                                std::sin(rise));
      points.push_back(
          ((rangeInRoom(ray) + noise * random.normal()) * ray).cast<float>());
    }
  return points;
}

/** Even samples of the walls of the room and of the cupboard, moved so that the floor passes
 * through the origin. */
Points
makeModel(bool is_regular)
{
  Random random(6);
  Points points;
  for (const Eigen::AlignedBox3d& box :
       {Eigen::AlignedBox3d(Eigen::Vector3d(-3, -2, 0), Eigen::Vector3d(4, 5, 2.8)),
        Eigen::AlignedBox3d(Eigen::Vector3d(1.5, 1, 0), Eigen::Vector3d(2.2, 2, 1.9))})
    for (int axis = 0; axis < 3; ++axis)
      for (const bool is_upper : {false, true}) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const Eigen::Vector3d size = box.sizes();
        const int columns = static_cast<int>(size[u] / 0.06),
                  rows = static_cast<int>(size[v] / 0.06);
        for (int i = 0; i < columns * rows; ++i) {
          Eigen::Vector3d point = is_upper ? box.max() : box.min();
          point[u] = box.min()[u] +
                     (is_regular ? 0.06 * (i % columns) : size[u] * random.uniform());
          point[v] = box.min()[v] +
                     (is_regular ? 0.06 * (i / columns) : size[v] * random.uniform());
          points.push_back(point.cast<float>());
        }
      }
  return points;
}

TEST(SensorEvidence, isProvedByRowsOfEqualElevation)
{
  for (const int beams : {16, 32, 64, 128}) {
    const SensorEvidence found = evidenceOf(makeScan(beams, -25, 15, 0.01));
    EXPECT_EQ(found.outcome, SensorOutcome::Proved) << beams << found.evidence;
    EXPECT_GT(found.confidence, 0.9);
    EXPECT_LT(found.hidden, 0.05);
  }
}

TEST(SensorEvidence, needsNoOrderOfRowsAndNoParticularAxis)
{
  Points points = makeScan(32, -25, 15, 0.005);
  Random random(8);
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(
        points[i - 1],
        points[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  for (Eigen::Vector3f& point : points)
    point = Eigen::Vector3f(point.x(), point.z(), -point.y());
  EXPECT_EQ(evidenceOf(points).outcome, SensorOutcome::Proved);
}

TEST(SensorEvidence, ignoresPointsThatAreNoMeasurements)
{
  Points points = makeScan(32, -25, 15, 0.005);
  for (std::size_t i = 0; i < points.size(); i += 3)
    points[i].setZero();
  for (std::size_t i = 1; i < points.size(); i += 30)
    points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(evidenceOf(points).outcome, SensorOutcome::Proved);
}

TEST(SensorEvidence, isProvedByTheOrderOfRaysOfATiltedScanner)
{
  Points points;
  const Points columns = makeScan(24, -30, 30, 0.02);
  for (std::size_t beam = 0; beam < 24; ++beam) // ring by ring
    for (std::size_t i = beam; i < columns.size(); i += 24)
      points.push_back(
          Eigen::AngleAxisf(0.3F, Eigen::Vector3f(1, 0.2F, 0).normalized()) *
          columns[i]);
  EXPECT_EQ(evidenceOf(points).outcome, SensorOutcome::Proved)
      << evidenceOf(points).evidence;
}

TEST(SensorEvidence, isNotProvedWhereTheFloorPassesThroughTheOrigin)
{
  for (const bool is_regular : {false, true}) {
    const SensorEvidence found = evidenceOf(makeModel(is_regular));
    EXPECT_FALSE(found.isKnown()) << found.evidence;
  }
}

TEST(SensorEvidence, isNotProvedByABodyOfRevolutionAroundTheOrigin)
{
  Points sphere;
  for (int row = 1; row < 90; ++row)
    for (int column = 0; column < 180; ++column) {
      const double rise = M_PI * row / 90, turn = 2 * M_PI * column / 180;
      sphere.push_back(Eigen::Vector3d(std::sin(rise) * std::cos(turn),
                                       std::sin(rise) * std::sin(turn),
                                       std::cos(rise))
                           .cast<float>());
    }
  EXPECT_FALSE(evidenceOf(sphere).isKnown()) << evidenceOf(sphere).evidence;
}

TEST(SensorEvidence, isRefutedWhereMuchIsHidden)
{
  Points points = makeScan(32, -25, 15, 0.01);
  const std::size_t scanned = points.size();
  for (std::size_t i = 0; i < scanned; ++i) // the next rooms
    points.push_back(2 * points[i]);
  const SensorEvidence found = evidenceOf(points);
  EXPECT_EQ(found.outcome, SensorOutcome::Refuted) << found.evidence;
  EXPECT_GT(found.hidden, 0.25);
}

TEST(SensorEvidence, isUndeterminedForAFewPoints)
{
  EXPECT_EQ(evidenceOf(Points(1)).outcome, SensorOutcome::Undetermined);
  Points points = makeScan(16, -15, 15, 0);
  points.resize(150);
  EXPECT_EQ(evidenceOf(points).outcome, SensorOutcome::Undetermined);
}

TEST(SensorEvidence, takesWhatIsStated)
{
  PointCloudFile file;
  const CloudRows none;
  file.sensor_origin = {1, 2, 3};
  EXPECT_EQ(sensorEvidence(none, file).outcome, SensorOutcome::Stated);
  file.sensor_statement = SensorStatement::NoSensor;
  EXPECT_FALSE(sensorEvidence(none, file).isKnown());
  file.sensor_origin.setZero();
  file.sensor_statement = SensorStatement::Stated;
  EXPECT_EQ(sensorEvidence(none, file).outcome, SensorOutcome::Stated);
}

TEST(SensorEvidence, isProvedInRealScans)
{
  for (const char* name : {"rings_near_horizon.ply", "multibeam_room.ply"}) {
    const std::string path = "H_field/clouds/" + std::string(name);
    if (!hasTestData(path))
      GTEST_SKIP() << path << " is not in the folder that ACMAP_TEST_DATA names";
    const PointCloudFile file = loadPointCloud(testDataPath(path).string());
    EXPECT_EQ(assessSensor(file.points(), 0, Eigen::Vector3d::Zero()).outcome,
              SensorOutcome::Proved)
        << name;
  }
}

} // namespace
} // namespace pcl::acmap::test

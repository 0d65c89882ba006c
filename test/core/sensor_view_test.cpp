#include <pcl/core/impl/point_fields.h>
#include <pcl/core/point_types.h>
#include <pcl/core/sensor_view.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

struct SeenSensors {
  float place[3];
  std::int32_t view;
};

const std::vector<Eigen::Vector3f> stations = {{1, 2, 3}, {4, 5, 6}};

TEST(SensorView, knowsNothingByItself)
{
  const SensorView sensors;
  EXPECT_FALSE(sensors.isKnown());
  EXPECT_EQ(sensors[0], nullptr);
  EXPECT_EQ(sensors[12345], nullptr);
}

TEST(SensorView, oneSensorSawAllPoints)
{
  const SensorView sensors(stations[1]);
  EXPECT_TRUE(sensors.isKnown());
  EXPECT_EQ(*sensors[0], stations[1]);
  EXPECT_EQ(*sensors[12345], stations[1]);
}

TEST(SensorView, pointsNameTheirObservation)
{
  const std::vector<SeenSensors> points = {
      {{}, 1}, {{}, 0}, {{}, -1}, {{}, 2}, {{}, 1}, {{}, -2147483647 - 1}};
  const SensorView sensors(&points[0].view, sizeof(SeenSensors), stations);
  EXPECT_TRUE(sensors.isKnown());
  EXPECT_EQ(*sensors[0], stations[1]);
  EXPECT_EQ(*sensors[1], stations[0]);
  EXPECT_EQ(sensors[2], nullptr) << "-1 is unknown";
  EXPECT_EQ(sensors[3], nullptr) << "there are two observations";
  EXPECT_EQ(*sensors[4], stations[1]);
  EXPECT_EQ(sensors[5], nullptr);
}

TEST(SensorView, indicesChooseThePoints)
{
  const std::vector<SeenSensors> points = {{{}, 1}, {{}, 0}, {{}, -1}};
  const std::vector<std::int32_t> indices = {2, 1, 1, 0};
  const SensorView sensors(
      &points[0].view, sizeof(SeenSensors), stations, indices.data());
  EXPECT_EQ(sensors[0], nullptr);
  EXPECT_EQ(*sensors[1], stations[0]);
  EXPECT_EQ(*sensors[2], stations[0]);
  EXPECT_EQ(*sensors[3], stations[1]);
}

TEST(SensorView, copiesKeepTheirOwnPlaces)
{
  const std::vector<SeenSensors> points = {{{}, 1}};
  SensorView copy;
  {
    const SensorView sensors(&points[0].view, sizeof(SeenSensors), stations);
    copy = sensors;
  }
  EXPECT_EQ(*copy[0], stations[1]);
}

TEST(SensorView, viewsWithoutViewpointsAreUnknown)
{
  const std::vector<SeenSensors> points = {{{}, 0}};
  const SensorView sensors(&points[0].view, sizeof(SeenSensors), {});
  EXPECT_FALSE(sensors.isKnown());
  EXPECT_EQ(sensors[0], nullptr);
}

TEST(NamedSensors, areThoseThatSomebodyNamed)
{
  PointCloud<PointXYZRGBNormalView> map;
  EXPECT_FALSE(namedSensorsOf(map, stations).isKnown()) << "no points";
  map.resize(3);
  map[0].view = 1;
  map[1].view = 0;
  EXPECT_FALSE(namedSensorsOf(map, {}).isKnown()) << "no viewpoints";
  const SensorView sensors = namedSensorsOf(map, stations);
  EXPECT_EQ(*sensors[0], stations[1]);
  EXPECT_EQ(*sensors[1], stations[0]);
  EXPECT_EQ(sensors[2], nullptr) << "-1 is unknown";
  PointCloud<PointXYZ> plain;
  plain.resize(3);
  EXPECT_FALSE(namedSensorsOf(plain, stations).isKnown()) << "no field view";
}

} // namespace
} // namespace pcl::acmap::test

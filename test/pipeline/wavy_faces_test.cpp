#include "test_data.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/random.h>
#include <pcl/pipeline/plane_mapping.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace pcl::acmap::test {
namespace {

std::vector<PlanePatch>
planesOf(PlaneMapping& mapping)
{
  MappedPlanes found;
  mapping.compute(found);
  return found.planes;
}

/** Errors that neighbouring points share, of unit variance. */
class Waves {
public:
  Waves(double wavelength, Random& random)
  {
    for (Wave& wave : waves_) {
      const double turn = random.uniform(0, 2 * M_PI);
      const double frequency = 2 * M_PI / wavelength * random.uniform(0.6, 1.4);
      wave = {frequency * std::cos(turn),
              frequency * std::sin(turn),
              random.uniform(0, 2 * M_PI)};
    }
  }

  double
  at(double x, double y) const
  {
    double sum = 0;
    for (const Wave& wave : waves_)
      sum += std::sin(wave.x * x + wave.y * y + wave.phase);
    return sum * std::sqrt(2.0 / waves_.size());
  }

private:
  struct Wave {
    double x, y, phase;
  };
  std::array<Wave, 24> waves_;
};

/** Three faces of a box before a stereo camera at the origin, which looks along z. */
PointCloud<PointXYZ>::Ptr
makeWavyBox(double wavelength, double height, std::uint64_t seed)
{
  constexpr double fine = 0.0015, density = 40000, distance = 2;
  const Eigen::Vector3d sides(0.45, 0.35, 0.4);
  Random random(seed);
  const Waves waves(wavelength, random);
  Eigen::Matrix3d turn;
  turn.row(2) = -Eigen::Vector3d(1, 1, 1).normalized();
  turn.row(0) = Eigen::Vector3d(1, -1, 0).normalized();
  turn.row(1) = turn.row(2).cross(turn.row(0));
  PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
  for (int face = 0; face < 3; ++face) {
    const int a = (face + 1) % 3, b = (face + 2) % 3;
    for (int i = 0; i < static_cast<int>(density * sides[a] * sides[b]); ++i) {
      Eigen::Vector3d corner = Eigen::Vector3d::Zero();
      corner[a] = random.uniform(0, sides[a]);
      corner[b] = random.uniform(0, sides[b]);
      const Eigen::Vector3d place = turn * corner + distance * Eigen::Vector3d::UnitZ();
      const double error =
          height * waves.at(place.x(), place.y()) + fine * random.normal();
      const Eigen::Vector3f point = (place + error * place.normalized()).cast<float>();
      cloud->emplace_back(point.x(), point.y(), point.z());
    }
  }
  return cloud;
}

/** Noise that neighbouring points share looks like waves of a face. */
TEST(WavyFaces, areOnePlaneEach)
{
  for (const double wavelength : {0.06, 0.1})
    for (const std::uint64_t seed : {1, 2}) {
      PlaneMapping mapping;
      mapping.setInputCloud(makeWavyBox(wavelength, 0.004, seed));
      const std::vector<PlanePatch> planes = planesOf(mapping);
      EXPECT_GE(planes.size(), 3U) << wavelength << ' ' << seed;
      EXPECT_LE(planes.size(), 6U) << wavelength << ' ' << seed;
    }
}

TEST(WavyFaces, ofABoxSeenByARealSenseAreFewPlanes)
{
  const std::string path = "H_field/clouds/box_realsense.ply";
  if (!hasTestData(path))
    GTEST_SKIP() << "the test data is missing";
  PlaneMapping mapping;
  mapping.setInputCloud(std::make_shared<const PointCloudFile>(
      loadPointCloud(testDataPath(path).string())));
  const std::vector<PlanePatch> planes = planesOf(mapping);
  EXPECT_GE(planes.size(), 3U);
  EXPECT_LE(planes.size(), 8U);
}

} // namespace
} // namespace pcl::acmap::test

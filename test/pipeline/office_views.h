#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl::acmap::test {

inline constexpr std::size_t views = 3;

/** \brief Gives the cameras fewer pixels. */
inline void
makeSmall(SimulatedScene& scene, int factor)
{
  scene.rig.width /= factor;
  scene.rig.height /= factor;
  scene.rig.focal_length /= factor;
  scene.rig.center_x = (scene.rig.width - 1) / 2.0;
  scene.rig.center_y = (scene.rig.height - 1) / 2.0;
  scene.sensor.points /= static_cast<std::size_t>(factor) * factor;
}

/** \brief A few views of an office, each with its pose. */
class OfficeViews : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    SimulatedScene office = standardScene("office");
    makeSmall(office, 2);
    trajectory_ = trajectoryOf(office, views);
    for (std::size_t i = 0; i < views; ++i) {
      const auto file = std::make_shared<PointCloudFile>();
      file->cloud = cloudOf(observe(office, i, 1));
      clouds_.push_back(file);
    }
  }

  static void
  TearDownTestSuite()
  {
    clouds_.clear();
  }

  static void
  expectSame(const CompactMap& a, const CompactMap& b)
  {
    ASSERT_EQ(a.planes.size(), b.planes.size());
    ASSERT_EQ(a.charts.size(), b.charts.size());
    for (std::size_t i = 0; i < a.planes.size(); ++i)
      EXPECT_EQ(a.planes[i].coefficients, b.planes[i].coefficients);
    for (std::size_t i = 0; i < a.charts.size(); ++i)
      EXPECT_EQ(a.charts[i].colors.values, b.charts[i].colors.values);
    EXPECT_EQ(a.observations, b.observations);
  }

  static inline Trajectory trajectory_;
  static inline std::vector<std::shared_ptr<const PointCloudFile>> clouds_;
};

} // namespace pcl::acmap::test

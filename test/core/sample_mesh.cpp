#include "sample_mesh.h"

#include <pcl/conversions.h>
#include <pcl/core/random.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl::acmap::test {

SampleMesh::SampleMesh(int points)
{
  Random random(3);
  PointCloud<PointXYZRGBNormal> typed(static_cast<std::uint32_t>(points), 1);
  for (auto& point : typed) {
    point.x = static_cast<float>(random.normal());
    point.y = static_cast<float>(random.normal());
    point.z = static_cast<float>(random.normal());
    point.normal_z = 1.0F;
    point.curvature = static_cast<float>(random.uniform());
    point.rgba = static_cast<std::uint32_t>(random.bits()) & 0xffffffU;
  }
  toPCLPointCloud2(typed, cloud);
  for (int i = 0; i < 2 * points; ++i) {
    auto& triangle = mesh.triangles.emplace_back();
    for (std::int32_t& corner : triangle)
      corner = static_cast<std::int32_t>(random.uniform(0, points));
  }
}

} // namespace pcl::acmap::test

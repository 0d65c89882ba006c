#include "consolidated_mesh.h"

#include <pcl/surface/impl/dewall_kernel.h>

namespace pcl::acmap::bench {

TriangleMesh
meshOf(const Consolidation& consolidation, double voxel)
{
  const LargeVector<Representative>& all = consolidation.representatives;
  if (all.empty())
    return {};
  DeWallSettings settings;
  settings.rule = DeWallRule::Paper;
  settings.maximum_edge_length = 2.5 * voxel;
  settings.threads = 1;
  settings.normals =
      PointView(all.front().normal.data(), sizeof(Representative), all.size());
  DeWallReport report;
  return triangulateDeWall(
      PointView(all.front().point.data(), sizeof(Representative), all.size()),
      settings,
      Progress(),
      report);
}

test::Points
placesInScene(const SimulatedCloud& cloud, const Consolidation& consolidation)
{
  test::Points places;
  for (const Representative& representative : consolidation.representatives)
    places.push_back(cloud.T_scene_cloud * representative.point.cast<double>());
  return places;
}

test::Points
normalsInScene(const SimulatedCloud& cloud, const Consolidation& consolidation)
{
  test::Points normals;
  for (const Representative& representative : consolidation.representatives)
    normals.push_back(cloud.T_scene_cloud.linear() *
                      representative.normal.cast<double>());
  return normals;
}

} // namespace pcl::acmap::bench

#include "greedy_projection.h"
#include "one_view_finders.h"
#include "raw_mesh.h"
#include "timing.h"

#include <pcl/surface/organized_fast_mesh.h>

namespace pcl::acmap::bench {

OneViewMesh
ourMesh(const OneView& view)
{
  const PointCloud<PointXYZ>& points = *view.finite.points;
  OneViewMesh result{test::toPoints(points), {}};
  result.seconds = measureThread([&] {
    result.triangles =
        meshRaw({&points.front().x, sizeof(PointXYZ), points.size()}, DeWallRule::Paper)
            .mesh.triangles;
  });
  return result;
}

OneViewMesh
organizedMesh(const OneView& view)
{
  OneViewMesh result{test::toPoints(*view.organized), {}};
  std::vector<Vertices> polygons;
  result.seconds = measureThread([&] {
    OrganizedFastMesh<PointXYZ> mesher;
    mesher.setTriangulationType(OrganizedFastMesh<PointXYZ>::TRIANGLE_ADAPTIVE_CUT);
    mesher.setTrianglePixelSize(1);
    mesher.setInputCloud(view.organized);
    mesher.reconstruct(polygons);
  });
  result.triangles = test::toTriangles(polygons);
  return result;
}

OneViewMesh
greedyMesh(const OneView& view)
{
  OneViewMesh result{test::toPoints(*view.finite.points), {}};
  const double spacing = test::medianSpacing(result.points);
  result.seconds = measureThread(
      [&] { result.triangles = greedyProjection(*view.finite.points, spacing); });
  return result;
}

} // namespace pcl::acmap::bench

#include "greedy_projection.h"
#include "one_view_finders.h"
#include "timing.h"

#include <pcl/filters/depth_refinement.h>
#include <pcl/surface/dewall_triangulation.h>
#include <pcl/surface/organized_fast_mesh.h>

namespace pcl::acmap::bench {

OneViewMesh
ourMesh(const OneView& view)
{
  OneViewMesh result;
  PointCloud<PointXYZ>::Ptr refined(new PointCloud<PointXYZ>);
  result.seconds = measureThread([&] {
    DepthRefinement<PointXYZ> refinement;
    refinement.setNumberOfThreads(1);
    refinement.setInputCloud(view.organized);
    refinement.filter(*refined);
    DeWallTriangulation<PointXYZ> dewall;
    dewall.setNumberOfThreads(1);
    dewall.setInputCloud(refined);
    TriangleMesh mesh;
    dewall.reconstruct(mesh);
    result.triangles = mesh.triangles;
  });
  result.points = test::toPoints(*refined);
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

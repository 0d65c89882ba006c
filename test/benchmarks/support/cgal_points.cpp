#include "cgal_points.h"

#include <CGAL/pca_estimate_normals.h>

namespace pcl::acmap::bench {

CgalPoints
cgalPointsOf(const PlaneInput& input)
{
  CgalPoints points;
  points.reserve(input.points->size());
  for (const PointXYZ& p : *input.points)
    points.emplace_back(CgalKernel::Point_3(p.x, p.y, p.z),
                        CgalKernel::Vector_3(0, 0, 1),
                        static_cast<std::int32_t>(points.size()));
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      points,
      cgal_neighbours,
      CGAL::parameters::point_map(CgalPointMap()).normal_map(CgalNormalMap()));
  return points;
}

} // namespace pcl::acmap::bench

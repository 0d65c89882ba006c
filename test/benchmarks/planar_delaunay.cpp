#include "planar_delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace pcl::acmap::bench {

std::size_t
planarDelaunay(const PointView& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> flat;
  flat.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    flat.emplace_back(point.x(), point.y());
  }
  const CGAL::Delaunay_triangulation_2<Kernel> mesh(flat.begin(), flat.end());
  return mesh.number_of_faces();
}

} // namespace pcl::acmap::bench

#include "polygonal_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Polygonal_surface_reconstruction.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <iostream>
#include <tuple>

namespace pcl::acmap::bench {

std::vector<std::vector<Eigen::Vector3d>>
polygonalSurface(const LabelledPoints& input)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = std::tuple<Kernel::Point_3, Kernel::Vector_3, int>;
  std::vector<Point> points;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const Eigen::Vector3d place = input.points[i].cast<double>();
    const std::int32_t label = input.labels[i];
    const Eigen::Vector3d normal = label < 0
                                       ? Eigen::Vector3d::UnitX()
                                       : input.normals[static_cast<std::size_t>(label)];
    points.emplace_back(Kernel::Point_3(place.x(), place.y(), place.z()),
                        Kernel::Vector_3(normal.x(), normal.y(), normal.z()),
                        label);
  }
  CGAL::Polygonal_surface_reconstruction<Kernel> reconstruction(
      points,
      CGAL::Nth_of_tuple_property_map<0, Point>(),
      CGAL::Nth_of_tuple_property_map<1, Point>(),
      CGAL::Nth_of_tuple_property_map<2, Point>());
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  std::vector<std::vector<Eigen::Vector3d>> faces;
  if (!reconstruction.reconstruct<CGAL::GLPK_mixed_integer_program_traits<double>>(
          mesh)) {
    std::cerr << "PolyFit: " << reconstruction.error_message() << "\n";
    return faces;
  }
  for (const auto face : mesh.faces()) {
    std::vector<Eigen::Vector3d>& corners = faces.emplace_back();
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      const Kernel::Point_3& point = mesh.point(vertex);
      corners.emplace_back(point.x(), point.y(), point.z());
    }
  }
  return faces;
}

} // namespace pcl::acmap::bench

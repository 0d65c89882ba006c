#include "cgal_planes.h"

#include "cgal_points.h"
#include "region_planes.h"

#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>

#include <cmath>

namespace pcl::acmap::bench {
namespace {

namespace Detection = CGAL::Shape_detection;
using Traits = Detection::
    Efficient_RANSAC_traits<CgalKernel, CgalPoints, CgalPointMap, CgalNormalMap>;
using Ransac = Detection::Efficient_RANSAC<Traits>;

Ransac::Parameters
parametersFor(const PlaneInput& input)
{
  constexpr double spacings_to_neighbour = 5;
  Ransac::Parameters parameters;
  parameters.min_points = input.leastSupport();
  parameters.epsilon = input.tolerance;
  parameters.normal_threshold = std::cos(cgal_maximum_angle * M_PI / 180);
  parameters.cluster_epsilon = spacings_to_neighbour * input.spacing;
  return parameters;
}

std::vector<Indices>
detectRegions(const PlaneInput& input)
{
  CGAL::get_default_random() = CGAL::Random(0);
  CgalPoints points = cgalPointsOf(input);
  Ransac ransac;
  ransac.set_input(points);
  ransac.add_shape_factory<Detection::Plane<Traits>>();
  ransac.detect(parametersFor(input));
  std::vector<Indices> regions;
  for (const auto& shape : ransac.shapes()) {
    Indices region;
    for (const std::size_t i : shape->indices_of_assigned_points())
      region.push_back(std::get<2>(points[i]));
    regions.push_back(std::move(region));
  }
  return regions;
}

} // namespace

FoundPlanes
cgalRansacPlanes(const PlaneInput& input)
{
  return timedPlanes([&] { return planesOfRegions(input, detectRegions(input)); });
}

} // namespace pcl::acmap::bench

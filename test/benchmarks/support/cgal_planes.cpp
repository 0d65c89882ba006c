#include "bench.h"
#include "plane_finders.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <iterator>
#include <tuple>

#ifdef ACMAP_HAVE_CGAL_REGIONS
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#endif

namespace pcl::acmap::bench {
namespace {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/** A point, its normal and its index in the input, as CGAL changes the order. */
using CgalPoint = std::tuple<CgalKernel::Point_3, CgalKernel::Vector_3, std::int32_t>;
using CgalPoints = std::vector<CgalPoint>;
using CgalPointMap = CGAL::Nth_of_tuple_property_map<0, CgalPoint>;
using CgalNormalMap = CGAL::Nth_of_tuple_property_map<1, CgalPoint>;

constexpr unsigned cgal_neighbours = 48;

/** Maximum angle between the normals of a point and of its plane, degrees. With
 * CGAL's default of 25, noise of a depth camera removes 5 % of the points from their
 * planes. */
constexpr double cgal_maximum_angle = 45;

/** Computes the normals with pca_estimate_normals on one thread. */
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

namespace Detection = CGAL::Shape_detection;
using Traits = Detection::
    Efficient_RANSAC_traits<CgalKernel, CgalPoints, CgalPointMap, CgalNormalMap>;
using Ransac = Detection::Efficient_RANSAC<Traits>;

} // namespace

std::vector<Indices>
ransacRegions(const PlaneInput& input)
{
  CGAL::get_default_random() = CGAL::Random(0);
  CgalPoints points = cgalPointsOf(input);
  Ransac::Parameters parameters;
  parameters.min_points = input.leastSupport();
  parameters.epsilon = input.tolerance;
  parameters.normal_threshold = std::cos(cgal_maximum_angle * degree);
  parameters.cluster_epsilon = 5 * input.spacing; // from a point to its neighbour
  Ransac ransac;
  ransac.set_input(points);
  ransac.add_shape_factory<Detection::Plane<Traits>>();
  ransac.detect(parameters);
  std::vector<Indices> regions;
  for (const auto& shape : ransac.shapes()) {
    Indices region;
    for (const std::size_t i : shape->indices_of_assigned_points())
      region.push_back(std::get<2>(points[i]));
    regions.push_back(std::move(region));
  }
  return regions;
}

#ifdef ACMAP_HAVE_CGAL_REGIONS
std::vector<Indices>
cgalRegions(const PlaneInput& input)
{
  namespace PointSet = Detection::Point_set;
  using Query = PointSet::K_neighbor_query<CgalKernel, CgalPoints, CgalPointMap>;
  using Fit = PointSet::Least_squares_plane_fit_region<CgalKernel,
                                                       CgalPoints,
                                                       CgalPointMap,
                                                       CgalNormalMap>;
  using Sorting = PointSet::
      Least_squares_plane_fit_sorting<CgalKernel, CgalPoints, Query, CgalPointMap>;
  const CgalPoints points = cgalPointsOf(input);
  Query query(points, cgal_neighbours);
  Fit fit(points, input.tolerance, cgal_maximum_angle, input.leastSupport());
  Sorting sorting(points, query);
  sorting.sort();
  Detection::Region_growing<CgalPoints, Query, Fit, Sorting::Seed_map> growing(
      points, query, fit, sorting.seed_map());
  std::vector<std::vector<std::size_t>> found;
  growing.detect(std::back_inserter(found));
  std::vector<Indices> regions;
  for (const std::vector<std::size_t>& region : found)
    regions.emplace_back(region.begin(), region.end());
  return regions;
}
#endif

} // namespace pcl::acmap::bench

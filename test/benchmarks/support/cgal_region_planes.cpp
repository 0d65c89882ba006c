#include "cgal_planes.h"

#include "cgal_points.h"
#include "region_planes.h"

#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>

#include <iterator>

namespace pcl::acmap::bench {
namespace {

namespace PointSet = CGAL::Shape_detection::Point_set;
using Query = PointSet::K_neighbor_query<CgalKernel, CgalPoints, CgalPointMap>;
using Fit = PointSet::
    Least_squares_plane_fit_region<CgalKernel, CgalPoints, CgalPointMap, CgalNormalMap>;
using Sorting = PointSet::
    Least_squares_plane_fit_sorting<CgalKernel, CgalPoints, Query, CgalPointMap>;
using Growing =
    CGAL::Shape_detection::Region_growing<CgalPoints, Query, Fit, Sorting::Seed_map>;

std::vector<Indices>
regionsByCgal(const PlaneInput& input)
{
  const CgalPoints points = cgalPointsOf(input);
  Query query(points, cgal_neighbours);
  Fit fit(points, input.tolerance, cgal_maximum_angle, input.leastSupport());
  Sorting sorting(points, query);
  sorting.sort();
  Growing growing(points, query, fit, sorting.seed_map());
  std::vector<std::vector<std::size_t>> found;
  growing.detect(std::back_inserter(found));
  std::vector<Indices> regions;
  for (const std::vector<std::size_t>& region : found)
    regions.emplace_back(region.begin(), region.end());
  return regions;
}

} // namespace

FoundPlanes
cgalRegionPlanes(const PlaneInput& input)
{
  return timedPlanes([&] { return planesOfRegions(input, regionsByCgal(input)); });
}

} // namespace pcl::acmap::bench

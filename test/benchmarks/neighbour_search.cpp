#include "bench.h"
#include "bench_data.h"
#include "planes/radius_grid.h"

#include <pcl/core/impl/nearest_points.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

namespace pcl::acmap::bench {
namespace {

using Points = LargeVector<Eigen::Vector3d>;

Points
inDoubles(const test::Cloud& cloud)
{
  Points points;
  for (const PointXYZ& point : cloud)
    points.push_back(point.getVector3fMap().cast<double>());
  return points;
}

/** The median distance to the ninth point, of some. */
double
ninthDistance(const Points& points)
{
  const NearestPoints tree(points);
  std::vector<double> distances;
  Indices found;
  for (std::size_t i = 0; i < points.size(); i += 97) {
    tree.find(points[i].cast<float>(), 9, found);
    distances.push_back(
        (points[static_cast<std::size_t>(found.back())] - points[i]).norm());
  }
  return median(distances);
}

/** Pairs of points nearer than the radius, as doubles tell. */
std::size_t
pairsByCubes(const Points& points, double radius)
{
  const planes::RadiusGrid grid(points, radius);
  std::size_t pairs = 0;
  for (const Eigen::Vector3d& place : points)
    grid.visitNear(place, [&](std::int32_t) { ++pairs; });
  return pairs;
}

/** The same by FLANN, whose floats propose a little more. */
std::size_t
pairsByFlann(const test::Cloud& cloud, const Points& points, double radius)
{
  KdTreeFLANN<PointXYZ> tree(false);
  tree.setInputCloud(cloud.makeShared());
  Indices found;
  std::vector<float> distances;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double margin = 5e-7 * (points[i].cwiseAbs().maxCoeff() + radius);
    tree.radiusSearch(cloud[i], radius + margin, found, distances);
    std::sort(found.begin(), found.end()); // for an order that no tree decides
    for (const index_t j : found)
      if ((points[static_cast<std::size_t>(j)] - points[i]).squaredNorm() <
          radius * radius)
        ++pairs;
  }
  return pairs;
}

void
printRadius(const std::string& name, const test::Cloud& cloud)
{
  constexpr std::size_t rounds = 3;
  const Points points = inDoubles(cloud);
  const double ninth = ninthDistance(points);
  for (const double factor : {1.4, 3.5}) {
    const double radius = factor * ninth;
    std::size_t pairs = 0, others = 0;
    const double cubes =
        medianThread(rounds, [&] { pairs = pairsByCubes(points, radius); });
    const double flann =
        medianThread(rounds, [&] { others = pairsByFlann(cloud, points, radius); });
    Row() << name << cloud.size()
          << figure(static_cast<double>(pairs) / static_cast<double>(points.size()), 0)
          << figure(cubes, 2) << figure(flann, 2) << timesOf(flann, cubes)
          << (pairs == others ? "yes" : "no");
  }
}

/** RadiusGrid against FLANN, with the time to build. */
const Section radius_section("radius", [] {
  printHead("cloud | points | nearer than the radius | cubes, s | FLANN, s | ratio | "
            "same points");
  printRadius("simulated room", test::makeRoom(0.02, 0.005, 3));
  if (const auto path = pathOfData("E_meshing/capture0002.pcd"))
    printRadius("organized view", loadFigureCloud("view", *path).cloud);
});

} // namespace
} // namespace pcl::acmap::bench

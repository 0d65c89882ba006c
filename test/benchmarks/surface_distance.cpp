#include "surface_distance.h"

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

using test::Points;
using test::ReferenceTree;
using test::Triangle;
using test::Triangles;

double
distanceToSegment(const Eigen::Vector3d& p,
                  const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b)
{
  const Eigen::Vector3d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double t = length2 > 0 ? std::clamp(edge.dot(p - a) / length2, 0.0, 1.0) : 0;
  return (a + t * edge - p).norm();
}

/** Finds the nearest triangle with a tree of the triangles' centres. */
class Surface {
public:
  Surface(const Points& points, const Triangles& triangles)
  : points_(points)
  , triangles_(triangles)
  , tree_(centers(points, triangles))
  {
    const Points middles = centers(points, triangles);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (const std::int32_t corner : triangles[i])
        reach_ = std::max(reach_, (points[corner] - middles[i]).norm());
  }

  double
  distance(const Eigen::Vector3d& p) const
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (const auto& [squared, triangle] : tree_.nearest(p, 8))
      minimum = std::min(minimum, distanceTo(p, triangle));
    for (const std::int32_t triangle : tree_.within(p, minimum + reach_))
      minimum = std::min(minimum, distanceTo(p, triangle));
    return minimum;
  }

private:
  static Points
  centers(const Points& points, const Triangles& triangles)
  {
    Points middles;
    for (const Triangle& t : triangles)
      middles.push_back((points[t[0]] + points[t[1]] + points[t[2]]) / 3);
    return middles;
  }

  double
  distanceTo(const Eigen::Vector3d& p, std::int32_t triangle) const
  {
    const Triangle& t = triangles_[triangle];
    return distanceToTriangle(p, points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  const Points& points_;
  const Triangles& triangles_;
  ReferenceTree tree_;
  double reach_ = 0; ///< maximum radius of a triangle about its centre
};

Points
sampleByArea(const Points& points,
             const Triangles& triangles,
             std::size_t samples,
             std::uint64_t seed)
{
  std::vector<double> areas;
  double sum = 0;
  for (const Triangle& t : triangles) {
    sum += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
    areas.push_back(sum);
  }
  Random random(seed);
  Points chosen;
  for (std::size_t i = 0; i < samples; ++i) {
    const double place = (static_cast<double>(i) + random.uniform()) * sum /
                         static_cast<double>(samples);
    const auto found = std::lower_bound(areas.begin(), areas.end(), place);
    const Triangle& t = triangles[std::min<std::size_t>(
        triangles.size() - 1, static_cast<std::size_t>(found - areas.begin()))];
    const double root = std::sqrt(random.uniform());
    const double share = random.uniform();
    chosen.push_back((1 - root) * points[t[0]] + root * (1 - share) * points[t[1]] +
                     root * share * points[t[2]]);
  }
  return chosen;
}

} // namespace

double
distanceToTriangle(const Eigen::Vector3d& point,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const bool above = normal.cross(b - a).dot(point - a) >= 0 &&
                     normal.cross(c - b).dot(point - b) >= 0 &&
                     normal.cross(a - c).dot(point - c) >= 0;
  if (above && normal.squaredNorm() > 0)
    return std::abs(normal.normalized().dot(point - a));
  return std::min({distanceToSegment(point, a, b),
                   distanceToSegment(point, b, c),
                   distanceToSegment(point, c, a)});
}

SurfaceDistance
measureDistance(const Points& from_points,
                const Triangles& from,
                const Points& to_points,
                const Triangles& to,
                std::size_t samples,
                std::uint64_t seed)
{
  const Surface surface(to_points, to);
  SurfaceDistance result;
  for (const Eigen::Vector3d& sample : sampleByArea(from_points, from, samples, seed)) {
    const double distance = surface.distance(sample);
    result.mean += distance / static_cast<double>(samples);
    result.maximum = std::max(result.maximum, distance);
  }
  return result;
}

} // namespace pcl::acmap::bench

#include "snapping.h"

#include <pcl/core/impl/planar_geometry.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double corner_reach = 14; // pixels, as on the page
constexpr double edge_reach = 10;

struct NearPlace {
  SnapPlace place;
  double pixels; ///< from the pointer
};

/** Does a closed line turn at a point? Its first point is repeated at its end. */
bool
turnsAt(const std::vector<Eigen::Vector3f>& loop, std::size_t i)
{
  const float sharp = std::cos(static_cast<float>(M_PI) / 6);
  const Eigen::Vector3f& before = loop[i == 0 ? loop.size() - 2 : i - 1];
  const Eigen::Vector3f in = (loop[i] - before).normalized();
  return in.dot((loop[i + 1] - loop[i]).normalized()) < sharp;
}

/** The point of an edge that is nearest to a ray; the first end if they are parallel. */
Eigen::Vector3d
nearestOn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const PixelRay& ray)
{
  const Eigen::Vector3d edge = b - a, normal = edge.cross(ray.direction);
  if (normal.squaredNorm() == 0)
    return a;
  const double t =
      (ray.eye - a).cross(ray.direction).dot(normal) / normal.squaredNorm();
  return a + std::clamp(t, 0.0, 1.0) * edge;
}

std::vector<SnapPlace>
sorted(std::vector<NearPlace>& places)
{
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return a.pixels < b.pixels;
  });
  std::vector<SnapPlace> result;
  for (const NearPlace& near : places)
    result.push_back(near.place);
  return result;
}

bool
isInView(const Eigen::Vector3d& pixel)
{
  return pixel.z() >= 0 && pixel.z() <= 1;
}

} // namespace

std::vector<SnapPlace>
snapPlaces(const std::vector<MapLine>& outlines,
           const PixelRay& ray,
           const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& pixel_of)
{
  std::vector<NearPlace> corners, edges;
  for (const MapLine& line : outlines) {
    std::vector<Eigen::Vector3d> pixels;
    for (const Eigen::Vector3f& point : line.points)
      pixels.push_back(pixel_of(point.cast<double>()));
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      if (!isInView(pixels[i]))
        continue;
      const Eigen::Vector3d a = line.points[i].cast<double>();
      const double off = (pixels[i].head<2>() - ray.pixel).norm();
      if (off < corner_reach && turnsAt(line.points, i))
        corners.push_back({{a, line.plane}, off});
      if (!isInView(pixels[i + 1]))
        continue;
      const double beside = std::sqrt(
          squaredDistance(ray.pixel, pixels[i].head<2>(), pixels[i + 1].head<2>()));
      if (beside < edge_reach)
        edges.push_back(
            {{nearestOn(a, line.points[i + 1].cast<double>(), ray), line.plane},
             beside});
    }
  }
  std::vector<SnapPlace> places = sorted(corners);
  const std::vector<SnapPlace> more = sorted(edges);
  places.insert(places.end(), more.begin(), more.end());
  return places;
}

} // namespace pcl::acmap

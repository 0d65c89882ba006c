#include "ray.h"

#include <Eigen/Geometry>

namespace pcl::acmap {
namespace {

using Eigen::Vector3d;

/** \brief Intersection of a ray with a triangle, as a multiple of the direction
 * (Moeller and Trumbore, 1997); nothing if there is none. */
std::optional<double>
distanceTo(const Vector3d& eye,
           const Vector3d& direction,
           const Vector3d& a,
           const Vector3d& b,
           const Vector3d& c,
           bool fronts_only)
{
  const Vector3d p = direction.cross(c - a);
  const double volume = p.dot(b - a); // positive if the front faces the eye
  if (volume == 0 || (fronts_only && volume < 0))
    return {};
  const Vector3d way = eye - a;
  const double u = way.dot(p) / volume;
  const Vector3d q = way.cross(b - a);
  const double v = direction.dot(q) / volume;
  const double distance = (c - a).dot(q) / volume;
  if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0)
    return distance;
  return {};
}

} // namespace

std::optional<RayHit>
firstHit(const std::vector<MapFaces>& faces,
         const Vector3d& eye,
         const Vector3d& direction,
         bool fronts_only)
{
  std::optional<RayHit> first;
  for (const MapFaces& part : faces) {
    const auto corner = [&](std::int32_t i) -> Vector3d {
      return part.points[static_cast<std::size_t>(i)].cast<double>();
    };
    for (const auto& face : part.faces)
      for (std::size_t i = 2; i < face.size(); ++i) {
        const auto distance = distanceTo(eye,
                                         direction,
                                         corner(face[0]),
                                         corner(face[i - 1]),
                                         corner(face[i]),
                                         fronts_only);
        if (distance && (!first || *distance < first->distance))
          first = {part.plane, *distance};
      }
  }
  return first;
}

} // namespace pcl::acmap

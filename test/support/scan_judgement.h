#pragma once

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/plane_mapping.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::acmap::test {

/** \brief What is asked of the planes of a scan from the origin. */
struct ScanJudgement {
  double area = 0, facing = 0; ///< square metres, of all outlines
  /** \brief Of planes whose outline is more than twice their triangles. */
  double unsupported = 0;
  std::size_t through_sensor = 0; ///< planes
};

inline ScanJudgement
judgeScan(const MappedPlanes& found)
{
  std::vector<double> triangles(found.planes.size(), 0.0);
  const PointView points = requirePoints(found.vertices);
  for (const TriangleMesh::Triangle& t : found.mesh.triangles) {
    std::int32_t plane = -1;
    bool is_one = true;
    for (const std::int32_t corner : t) {
      const std::int32_t label = found.vertex_labels[static_cast<std::size_t>(corner)];
      is_one = is_one && (label < 0 || plane < 0 || label == plane);
      plane = std::max(plane, label);
    }
    if (!is_one || plane < 0)
      continue;
    const auto corner = [&](std::size_t k) -> Eigen::Vector3f {
      return points[static_cast<std::size_t>(t[k])];
    };
    triangles[static_cast<std::size_t>(plane)] +=
        (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  ScanJudgement result;
  for (std::size_t p = 0; p < found.planes.size(); ++p) {
    const PlanePatch& plane = found.planes[p];
    result.area += plane.area;
    result.facing += plane.coefficients[3] > 0 ? plane.area : 0;
    result.unsupported += plane.area > 2 * triangles[p] ? plane.area : 0;
    result.through_sensor += std::abs(plane.coefficients[3]) < 0.01 ? 1 : 0;
  }
  return result;
}

} // namespace pcl::acmap::test

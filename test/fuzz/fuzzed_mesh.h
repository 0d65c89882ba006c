#pragma once

#include "fuzzed_points.h"

#include <pcl/core/sensor_view.h>
#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap::test {

/** \brief Points and triangles: sheets, so that surfaces are frequent, or arbitrary
 * triples of points. */
struct FuzzedMesh {
  std::vector<Eigen::Vector3f> points;
  TriangleMesh::Triangles triangles;

  FuzzedMesh(FuzzedBytes& bytes, const PointStyle& style, std::size_t max_points);
};

/** \brief Sensor positions: unknown, one for all, or one per view number.
 * \param[out] views view numbers of the points, to which the result refers */
SensorView
fuzzedSensors(FuzzedBytes& bytes,
              const PointStyle& style,
              std::size_t points,
              std::vector<std::int32_t>& views);

} // namespace pcl::acmap::test

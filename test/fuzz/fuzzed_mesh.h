#pragma once

#include "fuzzed_points.h"

#include <pcl/core/sensor_view.h>
#include <pcl/core/triangle_mesh.h>

namespace pcl::acmap::test {

/** \brief Points and triangles between them: as sheets, so that surfaces are common, or any
 * three corners. */
struct FuzzedMesh {
  std::vector<Eigen::Vector3f> points;
  std::vector<TriangleMesh::Triangle> triangles;

  FuzzedMesh(FuzzedBytes& bytes, const PointStyle& style, std::size_t most_points);
};

/** \brief Where the sensors stood: unknown, one for all, or one for each point's number.
 * \param[out] views the numbers, which the view reads */
SensorView
fuzzedSensors(FuzzedBytes& bytes,
              const PointStyle& style,
              std::size_t points,
              std::vector<std::int32_t>& views);

} // namespace pcl::acmap::test

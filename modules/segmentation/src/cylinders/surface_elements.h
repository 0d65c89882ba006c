#pragma once

#include "cylinders/cylinder.h"

#include <pcl/core/impl/nearest_points.h>
#include <pcl/core/impl/vertex_neighbours.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::cylinders {

/** The points over which cylinders are grown, in double precision, relative to their
 * median. */
struct SurfaceElements {
  /** \param[in] hypotheses points, and normals and triangles if there are any: without
   * triangles the nearest points are neighbours; without normals those of local
   * quadrics are computed
   * \param[in] sigma standard deviation of the points across their surface, metres; 0:
   * measured */
  SurfaceElements(const PlaneHypotheses& hypotheses, double sigma);

  LargeVector<Eigen::Vector3d> points;
  LargeVector<Eigen::Vector3d> normals; ///< unit; NaN where there is none

  /** Is the normal that of a smooth surface? Not at edges. */
  std::vector<std::uint8_t> is_smooth;

  VertexNeighbours neighbours;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double extent = 0;        ///< metres, diagonal of the box around the points
  double spacing = 0;       ///< metres, median distance between neighbours
  double sigma = 0;         ///< metres, of the points across their surface
  bool is_oriented = false; ///< do the normals point to the seen side?
  bool is_mesh = false;     ///< are the neighbours those of a mesh?

  std::size_t
  size() const
  {
    return points.size();
  }

  std::vector<Sample>
  samplesOf(const std::vector<std::int32_t>& members) const
  {
    std::vector<Sample> samples;
    samples.reserve(members.size());
    for (const std::int32_t member : members)
      samples.push_back({points[static_cast<std::size_t>(member)]});
    return samples;
  }

private:
  void
  setPoints(const PointView& view);
  void
  connectNearest(const NearestPoints& tree);
  void
  setSpacing();
  void
  fitQuadrics(const NearestPoints& tree, double least);
};

/** Noise of a cloud, and the distance between its neighbouring points, metres. */
struct LocalNoise {
  double sigma = 0;
  double spacing = 0; ///< 0 if there is no surface
};

/** Measures them at a sample of the points, by quadrics over the nearest ones. */
LocalNoise
measureLocalNoise(const PointView& points);

} // namespace pcl::acmap::cylinders

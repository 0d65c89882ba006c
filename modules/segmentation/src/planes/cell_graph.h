#pragma once

#include <pcl/core/impl/vertex_neighbours.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

namespace pcl::acmap::planes {

/** The hypotheses in double precision, relative to their median, with their neighbours
 * and areas in the mesh. */
struct CellGraph {
  /** \param[in] is_consolidated does each hypothesis stand for several points?
   * \param[in] threads 0: all */
  CellGraph(const PlaneHypotheses& hypotheses, bool is_consolidated, unsigned threads);

  LargeVector<Eigen::Vector3d> points;  ///< relative to the origin
  LargeVector<Eigen::Vector3f> normals; ///< NaN where there is none
  LargeVector<double> areas;   ///< surface area that each one represents, square metres
  VertexNeighbours neighbours; ///< in the mesh; without one, in a radius
  Eigen::Vector3d origin;
  double spacing = 0; ///< metres
  double sigma = 0;   ///< metres; with the waves of the surface, if it has such

  /** Area over which normals had to be averaged, square metres: smaller regions may be
   * waves. 0 if the surface has none. */
  double least_area = 0;

  std::size_t
  size() const
  {
    return points.size();
  }

  bool
  hasNormal(std::size_t i) const
  {
    return normals[i].x() == normals[i].x();
  }

  /** Total area of hypotheses, square metres. */
  double
  areaOf(const std::vector<std::int32_t>& members) const;

private:
  void
  addAreas(const TriangleMesh::Triangles& triangles);
  void
  averageWaves();
  void
  connectNear(const PointView& view, unsigned threads);
};

} // namespace pcl::acmap::planes

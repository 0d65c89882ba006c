#pragma once

#include <pcl/core/vertex_neighbours.h>
#include <pcl/segmentation/plane_clustering_kernel.h>

namespace pcl::acmap::planes {

/** The hypotheses as doubles about their middle, with what the mesh says of them. */
struct CellGraph {
  /** \param[in] threads 0: all */
  CellGraph(const PlaneHypotheses& hypotheses, unsigned threads);

  std::vector<Eigen::Vector3d> points;  ///< from the origin
  std::vector<Eigen::Vector3f> normals; ///< NaN where there is none
  std::vector<double> areas;            ///< square metres each one stands for
  VertexNeighbours neighbours;          ///< in the mesh, or near
  Eigen::Vector3d origin;
  double spacing = 0; ///< metres
  double sigma = 0;   ///< metres

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

  /** Square metres that they stand for together. */
  double
  areaOf(const std::vector<std::int32_t>& members) const;

private:
  void
  connectNear(const PointView& view, unsigned threads);
};

} // namespace pcl::acmap::planes

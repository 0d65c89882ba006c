#pragma once

#include <pcl/core/vertex_neighbours.h>
#include <pcl/segmentation/plane_clustering_kernel.h>

namespace pcl::acmap::planes {

/** The hypotheses as doubles about their middle, with what the mesh says of them. */
struct CellGraph {
  explicit CellGraph(const PlaneHypotheses& hypotheses);

  std::vector<Eigen::Vector3d> points;  ///< from the origin
  std::vector<Eigen::Vector3f> normals; ///< NaN where there is none
  std::vector<double> areas;            ///< square metres each one stands for
  VertexNeighbours neighbours;          ///< in the mesh, or near
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
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

private:
  void
  connectNear(const PointView& view);
};

} // namespace pcl::acmap::planes

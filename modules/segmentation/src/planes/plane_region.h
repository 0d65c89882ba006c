#pragma once

#include "planes/cell_graph.h"

#include <pcl/core/impl/moments.h>

namespace pcl::acmap::planes {

/** A plane in the frame of the graph: normal . p + offset = 0. */
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;

  double
  distance(const Eigen::Vector3d& point) const
  {
    return normal.dot(point) + offset;
  }
};

/** Limits for points to join a plane. */
struct PlaneLimits {
  double distance = 0; ///< W_t, metres
  double cosine = 0;   ///< of W_n

  /** Permitted bending of real surfaces and sensor data, as a fraction of the extent,
   * and its maximum in metres. */
  double bow = 0;
  double max_bow = 0;

  double max_warp = 0; ///< deviation of a surface without a step, metres
};

/** Region of a plane: moments are updated with each member, and the plane is fitted to
 * them. */
class PlaneRegion {
public:
  PlaneRegion(const CellGraph& graph, const PlaneLimits& limits, std::size_t seed);

  bool
  accepts(std::size_t i) const
  {
    return graph_->normals[i].cast<double>().dot(plane_.normal) > limits_.cosine &&
           std::abs(plane_.distance(graph_->points[i])) < distance_;
  }

  /** W_t in metres, or more for large regions if bending is permitted. */
  double
  distance() const
  {
    return distance_;
  }

  void
  add(std::size_t i);

  /** Replaces the members. */
  void
  setMembers(const std::vector<std::int32_t>& members);

  /** Fits the plane to the members, unless they do not define a plane. */
  void
  refit();

  const Plane&
  plane() const
  {
    return plane_;
  }

  const Moments&
  moments() const
  {
    return moments_;
  }

private:
  const CellGraph* graph_;
  PlaneLimits limits_;
  Plane plane_;
  double distance_;
  Moments moments_;
  double refit_at_;
};

/** The least squares plane, with its normal towards the side of \a front. */
Plane
planeThrough(const PlaneFit& fit, const Eigen::Vector3d& front);

} // namespace pcl::acmap::planes

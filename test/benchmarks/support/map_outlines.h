#pragma once

#include "plane_raster.h"

#include <pcl/core/plane_patch.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::acmap::bench {

/** \brief An edge of an outline; metres. */
struct OutlineEdge {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /** \brief Other planes with an edge that has the same end points, bit by bit. */
  std::vector<std::size_t> partners;

  double
  distance(const Eigen::Vector3d& point) const;
};

/** \brief The polygons of a plane, in the frame that was asked for. */
struct PlaneOutline {
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();
  Eigen::AlignedBox3d box;
  std::vector<OutlineEdge> edges;

  /** \brief Loops of each polygon, projected into \ref frame; the outer one first. */
  std::vector<std::vector<FlatLoop>> polygons;
  PlaneFrame frame;

  /** \brief Index of the first edge of each loop, in the order of the loops. */
  std::vector<std::size_t> first_edges;

  std::size_t
  loops() const
  {
    return first_edges.size();
  }

  bool
  contains(const Eigen::Vector3d& point) const;

  /** \brief Distance within the plane from a point's projection to the polygons; 0
   * inside, infinite without polygons. */
  double
  distanceWithin(const Eigen::Vector3d& point) const;

  /** \brief Distance to the nearest edge; infinite without edges. */
  double
  distanceToEdges(const Eigen::Vector3d& point) const;

  /** \brief Distance to the surface of the polygons. */
  double
  distanceToSurface(const Eigen::Vector3d& point) const;
};

/** \brief The outlines of all planes of a map.
 * \param[in] T_out_map metres; the bits of the end points are compared before they are
 * transformed */
std::vector<PlaneOutline>
makeOutlines(const std::vector<PlanePatch>& planes,
             const Eigen::Isometry3d& T_out_map = Eigen::Isometry3d::Identity());

/** \brief Counts of outlines. */
struct OutlineCounts {
  std::size_t planes = 0;
  double vertices_mean = 0; ///< of a plane
  double vertices_median = 0;
  std::size_t polygons = 0;
  std::size_t holes = 0;
  std::size_t slivers = 0; ///< holes below 1 dm2
  std::size_t crossed = 0; ///< polygons with edges that cross each other
  double area = 0;         ///< square metres, of the polygons
};

OutlineCounts
countOutlines(const std::vector<PlaneOutline>& outlines);

} // namespace pcl::acmap::bench

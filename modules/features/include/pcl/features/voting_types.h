#pragma once

#include <pcl/core/report.h>

#include <cstddef>
#include <cstdint>

namespace pcl {

/** \brief What the votes at a vertex say about the surface there; the values of the labels
 * of NormalVectorVoting::getVertexClasses. \ingroup features */
enum class VertexClass : std::uint8_t {
  Unknown = 0, ///< too few votes
  Surface = 1, ///< one normal: e1, the eigenvector of the largest eigenvalue
  Crease = 2,  ///< two walls meet; e3 runs along both
  Corner = 3   ///< no direction prevails
};

/** \brief What NormalVectorVoting tells about its last run. \ingroup features */
struct VotingReport : Report {
  std::size_t vertices = 0;       ///< of the whole input cloud, as all counts here
  std::size_t invalid_points = 0; ///< of the vertices those that are not finite
  std::size_t triangles = 0;      ///< of the mesh; polygons are split into some
  std::size_t degenerate_triangles = 0; ///< without area, or with a point not finite
  std::size_t surface = 0;
  std::size_t crease = 0;
  std::size_t corner = 0;
  std::size_t unknown = 0; ///< of less than three votes: their normal is NaN

  double radius = 0;    ///< metres; geodesic radius g_max that was used
  double mean_edge = 0; ///< metres
  double sigma = 0;     ///< metres; noise of the vertices across the surface
};

} // namespace pcl

#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <cstddef>
#include <cstdint>

namespace pcl {

/** \brief Class of the surface at a vertex, determined by the votes; the values are the
 * labels of NormalVectorVoting::getVertexClasses. \ingroup features */
enum class VertexClass : std::uint8_t {
  Unknown = 0, ///< too few votes
  Surface = 1, ///< one normal: e1, the eigenvector of the largest eigenvalue
  Crease = 2,  ///< two walls meet; e3 is parallel to both
  Corner = 3   ///< no dominant direction
};

/** \brief Report of the last run of NormalVectorVoting. \ingroup features */
struct VotingReport : Report {
  std::size_t vertices = 0;       ///< of the whole input cloud, as all counts below
  std::size_t invalid_points = 0; ///< number of vertices that are not finite
  std::size_t triangles = 0;      ///< of the mesh, after splitting polygons
  /** \brief Triangles without area, or with a point that is not finite. */
  std::size_t degenerate_triangles = 0;
  std::size_t surface = 0;
  std::size_t crease = 0;
  std::size_t corner = 0;
  std::size_t unknown = 0; ///< with too few votes: their normal is NaN
  std::size_t votes = 0;   ///< counted ones, over all vertices

  double radius = 0;    ///< metres; geodesic radius g_max, as used
  double mean_edge = 0; ///< metres
  double sigma = 0;     ///< metres; noise of the vertices across the surface
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const VotingReport& report, Visitor&& visit)
{
  visit({"vertices"}, report.vertices);
  visit({"invalid_points"}, report.invalid_points);
  visit({"triangles"}, report.triangles);
  visit({"degenerate_triangles"}, report.degenerate_triangles);
  visit({"surface"}, report.surface);
  visit({"crease"}, report.crease);
  visit({"corner"}, report.corner);
  visit({"unknown"}, report.unknown);
  visit({"votes"}, report.votes);
  visit({"radius", "m"}, report.radius);
  visit({"mean_edge", "m"}, report.mean_edge);
  visit({"sigma", "m"}, report.sigma);
}

} // namespace pcl

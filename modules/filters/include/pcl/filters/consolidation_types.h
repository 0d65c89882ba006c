#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of VoxelConsolidation. \ingroup filters */
struct ConsolidationReport : Report {
  std::size_t points = 0;         ///< of the input
  std::size_t invalid_points = 0; ///< not finite, skipped
  /** \brief Points at least 2^19 voxels away from the others, which were skipped. */
  std::size_t distant_points = 0;
  std::size_t voxels = 0; ///< number of occupied voxels
  std::size_t representatives = 0;
  std::size_t two_sided_voxels = 0; ///< seen from both sides, with one point per side
  /** \brief Voxels at creases, fitted to the flattest 2 x 2 x 2 voxels. */
  std::size_t narrowed_windows = 0;
  std::size_t without_normal = 0; ///< representatives with too few points around them

  /** Are the sensor positions consistent with the surfaces? If not, the normals are
   * made consistent with those of their neighbours instead. */
  bool sensors_fit = false;

  double voxel_size = 0; ///< metres; as used
  double sigma = 0;      ///< metres; median noise of the input across its surface
  double residual = 0;   ///< metres; estimated median noise of a representative
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const ConsolidationReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"distant_points"}, report.distant_points);
  visit({"voxels"}, report.voxels);
  visit({"representatives"}, report.representatives);
  visit({"two_sided_voxels"}, report.two_sided_voxels);
  visit({"narrowed_windows"}, report.narrowed_windows);
  visit({"without_normal"}, report.without_normal);
  visit({"sensors_fit"}, report.sensors_fit);
  visit({"voxel_size", "m"}, report.voxel_size);
  visit({"sigma", "m"}, report.sigma);
  visit({"residual", "m"}, report.residual);
}

/** \brief Maximum edge length of a mesh of consolidated points, in voxels: it bridges the
 * jitter of the representatives. \ingroup filters */
inline constexpr double mesh_edge_in_voxels = 2.5;

namespace acmap {

/** \brief Computes the voxel size for a cloud: the smallest one whose representatives keep
 * at most 1/80 of it as noise, at least twice the spacing where points are sparse and at
 * least four times the noise.
 * \return metres; 0 if the scale has no spacing */
ACMAP_EXPORT double
automaticVoxel(const NoiseScale& scale);

/** \brief Is the noise so large compared with the spacing that a mesh through the points
 * would be crumpled? Other clouds are better meshed as they are: sparse regions keep their
 * detail. */
ACMAP_EXPORT bool
needsConsolidation(const NoiseScale& scale);

} // namespace acmap
} // namespace pcl

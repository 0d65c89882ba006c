#pragma once

#include "noisy_clouds.h"

#include <pcl/filters/voxel_consolidation.h>

namespace pcl::acmap::test {

using MapPoint = PointXYZRGBNormalView;
using MapCloud = PointCloud<MapPoint>;
using MapConsolidation = VoxelConsolidation<MapPoint>;

/** \brief A map cloud whose points have their views and random colours. */
MapCloud::Ptr
toMapCloud(const NoisyCloud& cloud);

/** \brief Complete result of a run. */
struct Consolidated {
  MapCloud cloud;
  ConsolidationReport report;
  MapConsolidation::SourceIndices sources;
  Indices voxel_of_point;
};

/** \param[in] voxel metres, 0 for automatic */
Consolidated
consolidate(const NoisyCloud& cloud, double voxel, unsigned threads = 0);

inline Eigen::Vector3d
placeOf(const MapPoint& point)
{
  return point.getVector3fMap().cast<double>();
}

inline Eigen::Vector3d
normalOf(const MapPoint& point)
{
  return point.getNormalVector3fMap().cast<double>();
}

/** \brief Distance of a projected point from the border of a patch, metres; negative
 * outside. */
double
insetIn(const Patch& patch, const Eigen::Vector3d& place);

/** \brief Deviations of the representatives from a true plane, metres. */
struct SheetFit {
  std::size_t points = 0;
  double mean = 0;         ///< signed distance in front of the true plane
  double rms = 0;          ///< of the signed distance
  double largest = 0;      ///< absolute value of the signed distance
  double coverage = 0;     ///< points per voxel face of the area
  double median_angle = 0; ///< radians between the normal and the true one, including
                           ///< the sign
};

/** \brief Evaluates the representatives within \a reach of a patch and \a inset from
 * its border whose normals point to the patch's side or are unknown. */
SheetFit
fitOf(const MapCloud& cloud,
      const Patch& patch,
      double voxel,
      double reach,
      double inset);

} // namespace pcl::acmap::test

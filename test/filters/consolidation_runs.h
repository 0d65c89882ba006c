#pragma once

#include "noisy_clouds.h"

#include <pcl/filters/voxel_consolidation.h>

namespace pcl::acmap::test {

using MapPoint = PointXYZRGBNormalView;
using MapCloud = PointCloud<MapPoint>;
using MapConsolidation = VoxelConsolidation<MapPoint>;

/** \brief A map whose points know their views; colours are random. */
MapCloud::Ptr
toMapCloud(const NoisyCloud& cloud);

/** \brief All that a run gives. */
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

/** \brief Metres from the rim of the patch to the foot of a place; negative outside. */
double
insetIn(const Patch& patch, const Eigen::Vector3d& place);

/** \brief How the representatives of one plane lie, metres. */
struct SheetFit {
  std::size_t points = 0;
  double mean = 0;         ///< depth before the true plane
  double rms = 0;          ///< of the depth
  double largest = 0;      ///< of the depth, its amount
  double coverage = 0;     ///< points for each voxel face of the area
  double median_angle = 0; ///< radians between normal and the truth, signs count
};

/** \brief Of those that look to the patch's side, or nowhere, and lie within \a reach of
 * it and \a inset from its rim. */
SheetFit
fitOf(const MapCloud& cloud,
      const Patch& patch,
      double voxel,
      double reach,
      double inset);

} // namespace pcl::acmap::test

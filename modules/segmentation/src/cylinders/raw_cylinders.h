#pragma once

#include "cylinders/cylinder_growth.h"

#include <pcl/core/progress.h>
#include <pcl/core/sensor_view.h>
#include <pcl/segmentation/impl/cylinder_clustering_kernel.h>

namespace pcl::acmap::cylinders {

/** A raw cloud whose noise hides the shape between neighbouring points, and the planes
 * that were found in it. */
struct RawCloud {
  PointView points;
  SensorView sensors;
  std::vector<PlanePatch> planes;
  PointLabels labels;                ///< plane of each point, -1 for none
  std::vector<std::uint8_t> is_bent; ///< planes that bend by more than their noise
  double spacing = 0;                ///< metres
  double sigma = 0;                  ///< metres; along the rays where sensors are known
};

/** A point of the cloud with its ray. */
Sample
sampleOf(const RawCloud& cloud, std::size_t i);

/** Points of the cloud with their rays. */
std::vector<Sample>
samplesOf(const RawCloud& cloud, const std::vector<std::int32_t>& members);

/** Finds planes over cells that are larger than the noise.
 * \param[in] sigma metres, 0: measured
 * \throws CancelledException when the progress callback requested to stop */
RawCloud
findRawPlanes(const PointView& points,
              const SensorView& sensors,
              double sigma,
              unsigned threads,
              const Progress& progress);

/** A cylinder of a raw cloud. */
struct RawCylinder {
  CylinderFit fit; ///< in the frame of the cloud
  std::vector<Sample> samples;
  std::vector<std::int32_t> members; ///< ascending
  std::vector<std::int32_t> planes;  ///< that it replaces
  double gain = 0;                   ///< bits that it saves
};

/** Noise along the rays, from the points on planes that are not bent; without sensors
 * across these planes. 0 if there are too few points. */
double
noiseOnPlanes(const RawCloud& cloud);

/** Gathers all points on a cylinder beside those that were found, and fits again: a
 * selection by rays does not shift the fit. Sets its covariance.
 * \param[in] pool numbers of the points that may be gathered, ascending
 * \param[in] reach of the cylinder so far
 * \return false if the points do not determine a cylinder */
bool
gatherRaw(const RawCloud& cloud,
          const std::vector<std::int32_t>& pool,
          CylinderReach reach,
          RawCylinder& cylinder);

/** Do rays pass through a convex cylinder where it should stop them? */
bool
isLookedThrough(const RawCloud& cloud,
                const RawCylinder& cylinder,
                const CylinderReach& reach);

/** Bits of a point on a plane, or of a free point. */
double
bitsOfPoint(const RawCloud& cloud, const DescriptionLength& lengths, std::size_t i);

/** Lengths at the scale of a cloud. */
DescriptionLength
lengthsOf(const RawCloud& cloud);

/** Finds cylinders among points that are on no plane, or on planes that bend more than
 * their noise: clusters of points, each with the axes that its shape and the planes
 * suggest.
 * \throws CancelledException when the progress callback requested to stop */
std::vector<RawCylinder>
findRawCylinders(const RawCloud& cloud,
                 const CylinderLimits& limits,
                 const Progress& progress);

} // namespace pcl::acmap::cylinders

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

  /** Is the noise along the rays of known sensors? Where it is rather across the surface, as
   * in merged clouds of other programs and with a sensor that is a mere default, residuals
   * along the rays would bend what they are fitted to. */
  bool is_along_rays = true;
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

/** Marks the planes whose surface bends by more than its noise, and by more than a share
 * of its width. */
void
markBentPlanes(double min_sagitta, RawCloud& cloud);

/** Marks as bent also the planes that are thicker than the noise, by more than a share of
 * their width: what is strongly curved does not look like a parabola through its noise. */
void
markThickPlanes(double min_sagitta, RawCloud& cloud);

/** A cylinder of a raw cloud. */
struct RawCylinder {
  CylinderFit fit; ///< in the frame of the cloud
  std::vector<Sample> samples;
  std::vector<std::int32_t> members; ///< ascending
  std::vector<std::int32_t> planes;  ///< that it replaces
  double gain = 0;                   ///< bits that it saves

  /** Was it found or fitted again after the search on a mesh? */
  bool is_changed = false;
};

/** Is the noise of the points on planes that are not bent rather along their rays than
 * across the planes? Also true where that cannot be told. */
bool
isAlongRays(const RawCloud& cloud);

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

/** Finds the cylinders that a mesh over the cloud was too coarse or too rough for, as strips
 * of planes and free points of the cloud show them, and adds such strips to those that were
 * found on the mesh. What is left of a scene that was meshed is clutter for the most part, so
 * they have to be surer than those of a whole cloud.
 * \param[in,out] cylinders in: found on the mesh; out: with the missed ones behind them
 * \throws CancelledException when the progress callback requested to stop */
void
addMissedCylinders(const RawCloud& cloud,
                   const CylinderLimits& limits,
                   const Progress& progress,
                   std::vector<RawCylinder>& cylinders);

} // namespace pcl::acmap::cylinders

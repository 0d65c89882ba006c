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
  std::vector<std::int32_t> labels; ///< plane of each point, -1 for none
  double spacing = 0;               ///< metres
  double sigma = 0; ///< metres; along the rays where sensors are known
};

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
};

/** Finds cylinders among points that are on no plane, or on planes that bend more than
 * their noise: clusters of points, each with the axes that its shape and the planes
 * suggest.
 * \throws CancelledException when the progress callback requested to stop */
std::vector<RawCylinder>
findRawCylinders(const RawCloud& cloud,
                 const CylinderLimits& limits,
                 const Progress& progress);

} // namespace pcl::acmap::cylinders

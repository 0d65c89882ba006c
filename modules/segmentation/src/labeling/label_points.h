#pragma once

#include "planes/known_planes.h"

#include <pcl/core/progress.h>
#include <pcl/core/sensor_view.h>
#include <pcl/segmentation/plane_clustering_types.h>

namespace pcl::acmap {

/** Limits of \ref labelPoints. */
struct LabelingLimits {
  double distance = 0;   ///< metres; what one plane may deviate from itself
  double cosine = 1;     ///< between normals of one plane
  double least_area = 0; ///< square metres
  double stray = 0;      ///< metres; so near a hypothesis of no plane joins one
  int coarseness = 1;    ///< edge of a cluster of shared noise in two spacings
};

/** Gives each point its plane and fits the planes to their points; planes that the points
 * refute are dropped, and parts of one plane joined. The hypotheses' labels follow.
 * \param[in,out] known in: as grown; out: what is left
 * \return for each point its plane, -1 for none */
std::vector<std::int32_t>
labelPoints(const PointView& points,
            const SensorView& sensors,
            const LabelingLimits& limits,
            const Progress& progress,
            KnownPlanes& known,
            PlaneClusteringReport& report);

/** Fits the planes to the hypotheses that are theirs by their labels, which stay. */
void
fitLabeled(const PointView& points,
           const SensorView& sensors,
           const LabelingLimits& limits,
           KnownPlanes& known);

} // namespace pcl::acmap

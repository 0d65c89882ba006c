#pragma once

#include "planes/known_planes.h"

#include <pcl/core/progress.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_view.h>
#include <pcl/segmentation/plane_clustering_types.h>

namespace pcl::acmap {

/** Limits of \ref labelPoints. */
struct LabelingLimits {
  double distance = 0; ///< metres; maximum deviation between parts of one plane
  double cosine = 1;   ///< minimum, between normals of parts of one plane
  double min_area = 0; ///< square metres
  double stray = 0;   ///< metres; a hypothesis without a plane joins one that is nearer
  int coarseness = 1; ///< edge length of noise clusters, unit: two spacings
};

/** Assigns each point to its plane and fits the planes to their points. Planes that the
 * points refute are removed, and parts of one plane are merged. The labels of the
 * hypotheses are updated.
 * \param[in,out] known in: as grown; out: the remaining planes
 * \return for each point its plane, -1 for none */
PointLabels
labelPoints(const PointView& points,
            const SensorView& sensors,
            const LabelingLimits& limits,
            const Progress& progress,
            KnownPlanes& known,
            PlaneClusteringReport& report);

/** Fits the planes to the hypotheses with their labels. These labels are not changed,
 * but hypotheses without a plane may join one. */
void
fitLabeled(const PointView& points,
           const SensorView& sensors,
           const LabelingLimits& limits,
           KnownPlanes& known);

} // namespace pcl::acmap

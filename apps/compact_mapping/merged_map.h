#pragma once

#include "depth_stage.h"
#include "tool.h"

#include <pcl/core/sensor_view.h>
#include <pcl/pipeline/observation_sequence.h>

#include <memory>

namespace pcl::acmap {

/** \brief All points of a sequence in the map's frame, each with the observation that saw
 * it. */
struct MergedMap {
  PointCloudFile file; ///< x y z rgb view; metres
  std::vector<Eigen::Vector3f> viewpoints;
  std::size_t observations = 0; ///< that could be read
  std::size_t refined = 0;      ///< whose depth was quantised

  SensorView
  sensors() const;
};

/** \brief Merges the finite points of a sequence, as a step of the tool.
 * \param[in] sensor the depth of views that are quantised is refined before
 * \param[in] most_points of more only each second, fourth ... is kept, with a warning
 * \param[in] skip_broken observations that cannot be read are left out and named
 * \throws InputFileException when one cannot be read and none may be skipped, or all poses
 * are the same though there are several
 * \throws MemoryRefused when this machine has too little */
MergedMap
mergeObservations(Tool& tool,
                  const ObservationSequence& sequence,
                  DepthSensor sensor,
                  bool skip_broken,
                  std::size_t most_points);

/** \brief Each n-th point of a map, so that a million or fewer are left to look at. */
PCLPointCloud2
thinned(const PCLPointCloud2& map);

} // namespace pcl::acmap

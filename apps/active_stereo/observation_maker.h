#pragma once

#include "search_range.h"
#include "shot_source.h"

#include <pcl/core/point_types.h>
#include <pcl/core/progress.h>
#include <pcl/point_cloud.h>
#include <pcl/stereo/disparity_back_projection.h>
#include <pcl/stereo/disparity_fusion.h>

#include <cstddef>

namespace pcl::acmap {

/** \brief Result of the shots of an observation. */
struct MadeObservation {
  MatchedDisparity matched;
  PointCloud<PointXYZRGBSigma> cloud; ///< organized, camera frame
  DisparityFusionReport fusion;
  DisparityBackProjectionReport projection;
};

/** \brief Computes the observations of one rig. */
class ObservationMaker {
public:
  /** \param[in] threads 0 = all
   * \throws BadArgumentException for a range that the matcher does not support */
  ObservationMaker(const TrinocularRig& rig,
                   const SearchRange& range,
                   const StereoOptions& options,
                   unsigned threads);

  /** \throws CancelledException when the callback requests it */
  MadeObservation
  make(const ObservationShots& shots, const ProgressCallback& progress);

private:
  DisparityFusion fusion_;
  DisparityBackProjection projection_;
};

/** \brief Memory for the costs of all disparities of a rig's views, in bytes. The
 * memory of the shots is not included: their number in an observation is not known
 * before they are read. */
std::size_t
disparityMemory(const TrinocularRig& rig, const SearchRange& range);

} // namespace pcl::acmap

#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <memory>

namespace pcl {

/** \brief The kind of sensor that measured a cloud. It decides if planes are searched
 * for in the picture of a view, where the noise of cameras that triangulate is uniform,
 * or in space.
 *
 * \ingroup pipeline */
enum class DepthSensor {
  /** \brief In the picture if the depth is quantised, and for \ref PlaneMapping also if
   * the noise of an organized view is independent between its pixels. */
  Automatic,
  Quantised, ///< structured light, such as a Kinect: in the picture
  Stereo,    ///< in the picture
  TimeOfFlight,
  Laser
};

namespace acmap {

/** \brief The sensor of a merged cloud for \ref PlaneMapping, several views are no picture.
 * \param[in] sensor that measured the views */
inline DepthSensor
sensorOfMerged(DepthSensor sensor, std::size_t views)
{
  const bool needs_picture =
      sensor == DepthSensor::Quantised || sensor == DepthSensor::Stereo;
  return needs_picture && views > 1 ? DepthSensor::Automatic : sensor;
}

} // namespace acmap

/** \brief Removes the quantisation steps of a view with \ref DepthRefinement, if the
 * view is processed as a picture. Points that are removed become NaN.
 * \param[in,out] view in its sensor's frame, metres; need not be organized
 * \param[in] threads 0 for all
 * \return true if it was refined
 * \throws UnorganizedPointCloudException if the sensor requires a picture and the view
 * is none
 *
 * \ingroup pipeline */
ACMAP_EXPORT bool
refineQuantisedDepth(PointCloud<PointXYZ>& view,
                     DepthSensor sensor = DepthSensor::Automatic,
                     unsigned threads = 0);

/** \brief The same for an observation, whose other fields stay as they are.
 * \return a refined copy; the observation itself if it was not refined
 * \throws BadArgumentException without an observation */
ACMAP_EXPORT std::shared_ptr<const PointCloudFile>
refineQuantisedDepth(const std::shared_ptr<const PointCloudFile>& observation,
                     DepthSensor sensor = DepthSensor::Automatic,
                     unsigned threads = 0);

} // namespace pcl

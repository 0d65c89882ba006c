#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/pipeline/depth_sensor.h>

#include <optional>

namespace pcl::acmap {

/** \brief Points that are processed as a picture. */
struct Picture {
  MeasuredDepthView seen;
  std::optional<PictureOrder> order; ///< if the points were not organized
};

/** \brief Arranges points as a picture.
 * \param[in] width pixels per row; that of all points if they are not organized
 * \return nothing if the points are to be processed in space
 * \throws UnorganizedPointCloudException if the sensor requires a picture, and they are
 * none */
ACMAP_EXPORT std::optional<Picture>
pictureOf(const PointView& points, std::size_t width, DepthSensor sensor);

/** \brief The same for finding planes: with DepthSensor::Automatic also organized points
 * whose depth is not quantised, but whose noise is independent between pixels, so that it
 * can be measured by depth. */
ACMAP_EXPORT std::optional<Picture>
planePictureOf(const PointView& points, std::size_t width, DepthSensor sensor);

} // namespace pcl::acmap

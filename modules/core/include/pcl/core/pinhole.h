#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace pcl {

/** \brief A camera without distortion: the ray of pixel (column, row) is ((column - cx)
 * / fx, (row - cy) / fy, 1). \ingroup core */
struct Pinhole {
  double fx = 0; ///< pixels
  double fy = 0;
  double cx = 0;
  double cy = 0;

  /** \param[in] point in the frame of the camera, z > 0 \return column, row */
  Eigen::Vector2d
  project(const Eigen::Vector3d& point) const
  {
    return {fx * point.x() / point.z() + cx, fy * point.y() / point.z() + cy};
  }
};

namespace acmap {

/** \brief Estimates the camera of an organized cloud in the frame of its sensor: x/z is
 * linear in the column, y/z in the row.
 *
 * The rays are regressed on the pixels, at up to 4,096 measured pixels: errors are in
 * the points, not in their image positions.
 * \param[in] points metres, row by row; not finite or z <= 0 for pixels without a
 * measurement
 * \param[in] width pixels per row
 * \return nothing if fewer than 100 points are measured, \a width is not that of an
 * image, or more than one in 20 of these pixels is a pixel or more away from its ray. A
 * focal length is negative if the axis of the points has the opposite direction
 * \ingroup core */
ACMAP_EXPORT std::optional<Pinhole>
fitPinhole(const PointView& points, std::size_t width);

/** \brief The same, but nothing if an axis has the opposite direction: x is right in
 * the image, y down. \ingroup core */
ACMAP_EXPORT std::optional<Pinhole>
fitUprightPinhole(const PointView& points, std::size_t width);

} // namespace acmap

} // namespace pcl

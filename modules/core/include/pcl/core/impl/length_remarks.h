#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Extent of most points of a cloud, robust against outliers. */
struct CloudExtent {
  Eigen::Vector3d minimum = Eigen::Vector3d::Zero(); ///< metres, 10 % quantile per axis
  Eigen::Vector3d maximum = Eigen::Vector3d::Zero(); ///< metres, 90 % quantile per axis
  std::size_t finite_points = 0;

  double
  diagonal() const
  {
    return (maximum - minimum).norm();
  }
};

ACMAP_EXPORT CloudExtent
cloudExtent(const PointView& points);

/** \brief Remarks for a report on the lengths in a cloud: points far away from all
 * others, lengths that are probably in millimetres or implausible in any unit, and
 * positions so far from the origin that the resolution of floats is too coarse.
 * \param[in] points in what the caller assumes to be metres
 * \param[in] median_spacing between neighbouring points, in the same unit; 0 if it is not
 * known
 * \param[in] is_unit_known true: there is no remark on the unit */
ACMAP_EXPORT std::vector<std::string>
lengthRemarks(const PointView& points,
              double median_spacing = 0,
              bool is_unit_known = false);

} // namespace pcl::acmap

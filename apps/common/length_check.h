#pragma once

#include "stage_log.h"

#include <pcl/core/impl/point_view.h>
#include <pcl/core/point_cloud_file.h>

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

CloudExtent
cloudExtent(const PointView& points);

/** \brief Warnings about the lengths in a cloud, one per line: points far away from all
 * others, lengths that are probably in millimetres or implausible in any unit, and
 * positions so far from the origin that the resolution of floats is too coarse.
 * \param[in] points in what the caller assumes to be metres
 * \param[in] median_spacing between neighbouring points, in the same unit
 * \param[in] scale that was applied to the file's numbers, for the advice */
std::vector<std::string>
lengthRemarks(const PointView& points, double median_spacing, double scale);

/** \brief Warns about the lengths of a cloud, without those checks that need its
 * spacing.
 * \param[in] points in metres, by the scale of the controls */
void
warnOfLengths(const PointView& points, const RunControls& controls, StageLog& log);

/** \brief Compares a length that the user gave in metres with the extent of the cloud
 * that it divides: warns if only few parts are left.
 * \param[in] option its name, with its dashes
 * \param[in] points in metres
 * \throws UsageError if it exceeds the cloud, for example if it was given in
 * millimetres */
void
requireFineLength(const std::string& option,
                  double metres,
                  const PointView& points,
                  StageLog& log);

} // namespace pcl::acmap

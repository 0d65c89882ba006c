#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_view.h>

#include <string>
#include <vector>

namespace pcl::acmap {

class Tool;

/** \brief Where most points of a cloud lie, whatever a few strays do. */
struct CloudExtent {
  Eigen::Vector3d least = Eigen::Vector3d::Zero(); ///< metres, 10 % quantile an axis
  Eigen::Vector3d most = Eigen::Vector3d::Zero();  ///< metres, 90 % quantile an axis
  std::size_t finite_points = 0;

  double
  diagonal() const
  {
    return (most - least).norm();
  }
};

CloudExtent
cloudExtent(const PointView& points);

/** \brief What is odd about the lengths in a cloud, a line each: points far away from all
 * others, lengths that look like millimetres or like nothing, and places so far from the
 * origin that floats are too coarse for them.
 * \param[in] points in what the caller takes for metres
 * \param[in] median_spacing between neighbouring points, in the same unit
 * \param[in] scale that was applied to the file's numbers, for the advice */
std::vector<std::string>
lengthRemarks(const PointView& points, double median_spacing, double scale);

/** \brief Warns of what is odd about a file's lengths, as far as its spacing need not be
 * known. \param[in] file in metres, by the tool's scale */
void
warnOfLengths(Tool& tool, const PointCloudFile& file);

/** \brief Compares a length that the user gave in metres with the cloud that it divides:
 * warns where it leaves only few parts.
 * \param[in] option its name, with its dashes
 * \param[in] points in metres
 * \throws UsageError where it is beyond the cloud, as millimetres taken for metres are */
void
requireFineLength(Tool& tool,
                  const std::string& option,
                  double metres,
                  const PointView& points);

} // namespace pcl::acmap

#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief Deviation of a camera from planar motion, from one place to the next.
 * \ingroup pipeline */
struct FreeMotion {
  std::size_t pairs = 0; ///< of places that were compared
  std::size_t free = 0;  ///< of these, those that clearly exceed their noise
  double tilt = 0; ///< of the axis about which a planar motion turns, radians, median
  double rise = 0; ///< along that axis, metres, absolute value, median
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const FreeMotion& motion, Visitor&& visit)
{
  visit({"pairs"}, motion.pairs);
  visit({"free"}, motion.free);
  visit({"tilt", "rad"}, motion.tilt);
  visit({"rise", "m"}, motion.rise);
}

/** \brief What the path of a camera is: planar, as that of a robot on a floor, or in space, as
 * that of a hand. \ingroup pipeline */
struct CameraPathReport {
  bool is_in_space = false;
  double confidence = 0.5; ///< probability that most of its motions are such
  FreeMotion evidence;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CameraPathReport& report, Visitor&& visit)
{
  visit({"is_in_space"}, report.is_in_space);
  visit({"confidence"}, report.confidence);
  visit({"evidence"}, report.evidence);
}

/** \brief Judges a path by its motions: in space if most of them are free. \ingroup pipeline */
ACMAP_EXPORT CameraPathReport
judgePath(const FreeMotion& evidence);

/** \brief How poses deviate from a planar motion: from each to the next one that is .3 m or 10
 * degrees away, about the axis of the camera about which they turn most. A motion is free if it
 * tilts by more than 1 degree and 3 % of its turn; heights alone do not tell, since tripods differ
 * in height. O(n) \ingroup pipeline */
ACMAP_EXPORT FreeMotion
freeMotionOf(const std::vector<Eigen::Isometry3d>& poses);

/** \brief "in space, 0.98 (tilts by 0.8 degrees, rises by 4 mm from one place to the next)".
 * \ingroup pipeline */
ACMAP_EXPORT std::string
textOf(const CameraPathReport& report);

} // namespace pcl

#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/point_view.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>

namespace pcl {

/** \brief What is known of the sensor of a cloud. \ingroup core */
enum class SensorOutcome {
  Stated,      ///< by the file or the caller; the points were not asked
  Proved,      ///< the points were measured from one position
  Refuted,     ///< much of the surface is hidden from the position
  Undetermined ///< neither
};

/** \brief Was a cloud measured by one sensor at a given position, and by what is it known?
 * \ingroup core */
struct SensorEvidence {
  SensorOutcome outcome = SensorOutcome::Undetermined;
  double confidence = 0; ///< in the outcome, 0 to 1
  std::string evidence;  ///< in words, with the figures
  double hidden = 0;     ///< share of the points behind others, seen from the position

  /** \brief Is there a sensor at the position? */
  bool
  isKnown() const
  {
    return outcome == SensorOutcome::Stated || outcome == SensorOutcome::Proved;
  }
};

namespace acmap {

/** \brief The names of \ref SensorOutcome in files and in Python. */
inline constexpr std::array<const char*, 4> sensor_outcome_names{
    "stated", "proved", "refuted", "undetermined"};

/** \brief Asks the points of a cloud whether one sensor measured all of them from a given
 * position. A file that states no sensor has it perhaps at its origin; but floors and walls
 * may pass through the origin of a map as well.
 *
 * It is refuted if more than a quarter of the points is hidden behind others (of leaves and
 * rims, up to 40 % are, if the rest is a proof). It is proved
 * if the cloud is a picture, whose rays have the same handedness everywhere. Otherwise either
 * - the points are in rows of equal elevation about an axis of the frame, as those of a laser
 *   scanner with several beams, or in the rows of a picture; or
 * - the rays advance steadily in the order of the points, as those of a scanner do,
 *
 * and that is at least twice as clear as from positions beside it: regular samples of
 * surfaces have rows and an order, too, but from no particular position. Points without
 * noise that were measured in no order prove nothing.
 *
 * Takes time linear in the points, of which up to 2^18 are asked. The result is the same for
 * each number of threads.
 * \param[in] points those that are not finite or at the position are skipped
 * \param[in] width pixels per row of an organized cloud; 0 or 1: unorganized
 * \param[in] position in the frame of the points, metres */
ACMAP_EXPORT SensorEvidence
assessSensor(const PointView& points,
             std::size_t width,
             const Eigen::Vector3d& position);

/** \brief Are the points the pixels of one camera at \a origin, row by row?
 *
 * The rays to a pixel, its right and its lower neighbour form a triple of the same
 * handedness in the entire image, for any depths; up to 1 % of exceptions are accepted.
 * The test fails for a cloud that was transformed after it was taken.
 * \param[in] width pixels per row */
ACMAP_EXPORT bool
isSingleView(const PointView& view, std::size_t width, const Eigen::Vector3d& origin);

} // namespace acmap

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const SensorEvidence& sensor, Visitor&& visit)
{
  visit({"outcome"}, acmap::Named{sensor.outcome, acmap::sensor_outcome_names});
  visit({"confidence"}, sensor.confidence);
  visit({"evidence"}, sensor.evidence);
  visit({"hidden"}, sensor.hidden);
}

} // namespace pcl

#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/sensor_evidence.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>

namespace pcl {

/** \brief By what the up direction of a cloud is known. \ingroup core */
enum class UpOutcome {
  Stated, ///< by the file or the caller; the points were not asked
  Found,  ///< the surfaces show it
  Assumed ///< by convention: the surfaces show it not at all, or only which axis is vertical
};

/** \brief The up direction of a cloud, and by what it is known. \ingroup core */
struct UpEvidence {
  UpOutcome outcome = UpOutcome::Assumed;
  Eigen::Vector3d value =
      Eigen::Vector3d::UnitZ(); ///< of length 1, in the cloud's frame
  double confidence = 0;        ///< 0 to 1; 0 if it is assumed
  std::string evidence;         ///< what shows it, or why nothing does; a few words

  bool
  isKnown() const
  {
    return outcome != UpOutcome::Assumed;
  }
};

namespace acmap {

/** \brief The names of \ref UpOutcome in files and in Python. */
inline constexpr std::array<const char*, 3> up_outcome_names{
    "stated", "found", "assumed"};

/** \brief Looks for the up direction in the surfaces of a cloud.
 *
 * Which axis of the frame is vertical is found if the building is turned in its frame about
 * that axis alone, since who levels a frame does not turn it to the walls; otherwise by
 * floors, ceilings and walls: most of the surface is along or across it, the lowest wide
 * level covers the plan, and rooms are lower than they are wide. Which of its senses is up
 * is found if there is a floor and no ceiling, with everything above it.
 *
 * What is not found is assumed: -y in a view of a camera, all points of which are in front
 * of the origin along z, and y if they are so along -z; otherwise what is usual, else z, or y where nothing is horizontal with
 * respect to z. Points before an origin that nothing proves to be a sensor are a view up to some
 * 8 m; the axis along which a sensor looks is not found to be vertical.
 * \param[in] points metres
 * \param[in] spacing of the points, metres
 * \param[in] sigma their noise, metres
 * \param[in] usual up direction in clouds of this kind, if there is one
 * \param[in] threads 0 for all; the result is the same
 * \param[in] sensor what is known of one at the origin */
ACMAP_EXPORT UpEvidence
findUp(const PointView& points,
       double spacing,
       double sigma,
       const std::optional<Eigen::Vector3f>& usual = std::nullopt,
       unsigned threads = 0,
       const SensorEvidence& sensor = {});

} // namespace acmap

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const UpEvidence& up, Visitor&& visit)
{
  visit({"value"}, up.value);
  visit({"outcome"}, acmap::Named{up.outcome, acmap::up_outcome_names});
  visit({"confidence"}, up.confidence);
  visit({"evidence"}, up.evidence);
}

} // namespace pcl

#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/scratch_memory.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief What one observation saw of a square cell of a plane. \ingroup pipeline */
struct PlaneSighting {
  /** \brief Along axis_u and axis_v of the plane, counted from its centre. */
  Eigen::Vector2i cell = Eigen::Vector2i::Zero();
  std::int32_t view = 0;    ///< index of the observation; 0 if it is not known
  std::uint32_t points = 0; ///< of those that were asked
  double offset = 0;        ///< mean of their signed distances from the plane, metres
  double spread = 0;        ///< standard deviation of these, metres
};

/** \brief A measured point and the sensor that saw it, metres in the map frame.
 * \ingroup pipeline */
struct SampledRay {
  Eigen::Vector3f sensor = Eigen::Vector3f::Zero();
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  std::int32_t plane = -1; ///< of the point; -1: none
};

/** \brief What observations saw of the planes of a map: a summary of its points, with which the map
 * is judged when the points are gone. \ingroup pipeline */
struct PlaneSightings {
  static constexpr double cell_size = 0.25; ///< metres

  /** \brief One list a plane, by cell and then by observation. */
  std::vector<std::vector<PlaneSighting>> planes;
  std::vector<SampledRay> rays; ///< none if the sensors are not known
  std::size_t observations = 0; ///< 0: it is not known which one saw a point
};

/** \brief Summarizes the points of a map, at most two million of them.
 * \param[in] cloud points, in the map frame, metres
 * \param[in] labels plane of each point, -1 for none
 * \param[in] viewpoints sensor of each observation, to which the field `view` of the points refers; or
 * the one sensor of a cloud without this field; empty: not known \ingroup pipeline */
ACMAP_EXPORT PlaneSightings
collectSightings(const CloudRows& cloud,
                 const PointLabels& labels,
                 const std::vector<PlanePatch>& planes,
                 const std::vector<Eigen::Vector3f>& viewpoints);

} // namespace pcl

#pragma once

#include <pcl/core/export.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/texture/floor_plan.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief A line or an area of a plan in one colour: red, green, blue. \ingroup pipeline */
struct PlanStroke {
  std::vector<Eigen::Vector2d> points; ///< metres
  std::array<std::uint8_t, 3> color{};
  bool is_area = false; ///< drawn below the lines, in the given order
};

/** \brief What is to be shown of a map that is being made: a plan, and what the person who
 * carries the camera should do.
 * \code
 * pcl::LivePlan plan;
 * mapping.setStateCallback ([&] (const pcl::MappingState& state) {
 *   plan.update (state);                                // lock: called from several threads
 *   std::cerr << plan.status () << "\n";               // 12 observations, 31 m², move slower
 * });
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT LivePlan {
public:
  /** \brief Takes a state; the plan is made anew when there is another provisional map. */
  void
  update(const MappingState& state);

  /** \brief Rooms, walls, the way of the camera, and what it looks at now. */
  const std::vector<PlanStroke>&
  strokes() const
  {
    return strokes_;
  }

  /** \brief Observations, seen floor, and a request to move slower or to go back, if it is
   * needed. */
  const std::string&
  status() const
  {
    return status_;
  }

private:
  std::string
  statusOf(const MappingState& state) const;

  std::vector<PlanStroke>
  strokesOf(const MappingState& state) const;

  FloorPlan plan_;
  std::shared_ptr<const CompactMap> provisional_; // of the plan
  std::vector<PlanStroke> strokes_;
  std::string status_;
};

} // namespace pcl

#pragma once

#include "egomotion_options.h"
#include "observation_list.h"

#include <pcl/core/trajectory.h>
#include <pcl/egomotion/egomotion_types.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A pair of observations whose motion was asked for. */
struct EgomotionPair {
  std::size_t now = 0, before = 0; ///< places in the sequence
  EgomotionReport report;
  std::optional<EgomotionEstimate> estimate; ///< T_before_now

  /** \brief Why there is no motion, with the name of a view that is at fault.
   * \param[in] names of the sequence's files */
  std::string
  reason(const std::vector<std::string>& names) const;

  /** \brief How many lie between both. */
  std::size_t
  skipped() const
  {
    return now - before - 1;
  }
};

/** \brief How far a camera leaves what motions in its xz plane and about its y axis can
 * follow, from one observation to the next. */
struct FreeMotion {
  std::size_t pairs =
      0; ///< that were tried with six degrees of freedom, and have a motion
  std::size_t free = 0; ///< of these, clearly beyond their noise
  double tilt = 0;      ///< of its y axis, radians, median
  double rise = 0;      ///< along y, metres, either way, median
};

/** \brief What became of a sequence. */
struct EgomotionRun {
  std::vector<EgomotionPair> pairs;
  std::vector<std::optional<Eigen::Isometry3d>> poses; ///< T_map_camera; lost: none
  FreeMotion free; ///< of a few pairs, where motions were found on the floor

  std::size_t
  posed() const;

  /** \brief Why an observation has no pose: what the pair with the one before told.
   * \param[in] list names that one */
  std::string
  reasonOf(std::size_t lost, const ObservationList& list) const;

  /** \brief Rows of those that have a pose. \param[in] stamps one an observation */
  Trajectory
  trajectory(const std::vector<double>& stamps) const;
};

/** \brief Estimates the motions of a sequence, as a step of the tool, and writes posed
 * observations, and pictures of matches where they are asked for.
 * \throws InputFileException when an observation cannot be used, or differs in size */
EgomotionRun
runEgomotion(Tool& tool,
             const EgomotionOptions& options,
             const ObservationList& list,
             const OutputFolder& folder);

} // namespace pcl::acmap

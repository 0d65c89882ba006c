#pragma once

#include "guard_cases.h"

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Figures of a run. */
struct GuardResult {
  std::string kind;
  std::uint64_t seed = 0;
  double level = 1;
  GuardVariant variant = GuardVariant::Plain;
  RectificationOutcome outcome = RectificationOutcome::Undetermined;
  AbsoluteTrajectoryError before, after;
  double seconds = 0; ///< CPU

  double
  ratio() const
  {
    return after.unaligned / before.unaligned;
  }

  double
  alignedRatio() const
  {
    return after.aligned / before.aligned;
  }

  /** \brief Is the map worse than before? Errors below half a bin, 0.05 m, are within
   * the accuracy of any map made of such bins: a map with less is as good as another.
   * \param[in] factor by which the error has to grow */
  bool
  isWorse(double factor = 1) const
  {
    constexpr double half_bin = 0.05; // metres
    return after.unaligned > factor * before.unaligned && after.unaligned > half_bin;
  }
};

/** \brief A run that is still to be made. */
struct GuardJob {
  std::string kind;
  std::uint64_t seed = 1;
};

/** \brief Makes and rectifies one map. */
RectificationRun
runGuardCase(const GuardCase& made);

/** \brief Makes all runs in some processes. The results are in the order of the runs,
 * and are the same for any number of processes. */
std::vector<GuardResult>
runGuardJobs(const std::vector<GuardJob>& jobs, std::size_t processes);

} // namespace pcl::acmap::bench

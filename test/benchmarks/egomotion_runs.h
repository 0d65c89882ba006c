#pragma once

#include "egomotion_methods.h"
#include "markdown_row.h"

#include <pcl/core/trajectory_error.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Motions estimated by a method between views of a sequence. */
struct EgomotionRun {
  std::string name;            ///< of the method
  std::size_t failures = 0;    ///< reported by the method
  std::size_t wrong = 0;       ///< not reported, with a large error: \ref isWrong
  RelativePoseError estimated; ///< of the motions that it returned
  RelativePoseError all;       ///< with identity instead of failed motions
  /** Errors of the chained motions, with identity for failures; NaN if they are not
   * chained. */
  AbsoluteTrajectoryError chain{no_reach, no_reach};
  std::vector<Eigen::Isometry3d> poses; ///< of the chain, starting with the true first
                                        ///< pose
  double seconds = 0;                   ///< mean CPU time per pair
};

/** \brief Is the error too large for any use? The limits are 10 cm and 5 degrees. */
bool
isWrong(const MotionError& error);

/** \brief Runs a method on neighbouring views, from later to earlier, and chains the
 * motions. For planar sequences only the planar part is evaluated. */
EgomotionRun
runChain(const EgomotionMethod& method, const EgomotionSequence& sequence);

/** \brief Runs a method on views with a given distance in the sequence, for at most 25
 * evenly distributed pairs; the motions are not chained. */
EgomotionRun
runApart(const EgomotionMethod& method,
         const EgomotionSequence& sequence,
         std::size_t step);

} // namespace pcl::acmap::bench

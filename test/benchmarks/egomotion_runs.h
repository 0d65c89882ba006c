#pragma once

#include "egomotion_methods.h"
#include "markdown_row.h"

#include <pcl/core/trajectory_error.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Motions of a method between views of a sequence. */
struct EgomotionRun {
  std::string name;            ///< of the method
  std::size_t failures = 0;    ///< told by the method
  std::size_t wrong = 0;       ///< not told, and far off: \ref isWrong
  RelativePoseError estimated; ///< of the motions it gave
  RelativePoseError all;       ///< with no motion at all in place of a failure
  /** Of all motions one after the other, the same there; NaN where none are chained. */
  AbsoluteTrajectoryError chain{no_reach, no_reach};
  std::vector<Eigen::Isometry3d> poses; ///< of the chain, from the true first one on
  double seconds = 0;                   ///< CPU a pair, its mean
};

/** \brief Further off than any use would bear: by 10 cm or 5 degrees. */
bool
isWrong(const MotionError& error);

/** \brief Runs a method on neighbours, later to earlier, and chains them. Of planar
 * sequences the planar part counts. */
EgomotionRun
runChain(const EgomotionMethod& method, const EgomotionSequence& sequence);

/** \brief Runs a method on views some files apart, at most 25 pairs evenly over the
 * sequence; without a chain. */
EgomotionRun
runApart(const EgomotionMethod& method,
         const EgomotionSequence& sequence,
         std::size_t step);

} // namespace pcl::acmap::bench

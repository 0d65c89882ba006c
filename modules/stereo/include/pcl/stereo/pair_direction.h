#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>

namespace pcl::acmap {

/** \brief On which side a neighbour stands, by what the images show. \ingroup stereo */
struct PairDirection {
  std::size_t as_stated =
      0; ///< sampled pixels that match on the side that the rig states
  std::size_t opposite = 0; ///< sampled pixels that match on the other side

  /** \brief Do the images contradict the rig? False if too few pixels match. */
  bool
  isContradicted() const
  {
    constexpr std::size_t least = 50;
    return opposite >= least && opposite >= 4 * as_stated;
  }
};

/** \brief Matches sampled rows of a reduced image of the reference in both directions of
 * its neighbour, and counts on which side the matches lie that are unique in both.
 *
 * The sign of a baseline, and which image is which, are not visible in any number of a
 * calibration. Takes O(width * disparities) of an image of at most 480 pixels across.
 * \param[in] frame rectified, with the images of both cameras
 * \param[in] neighbour one that the rig has
 * \throws BadArgumentException when an image is missing, incomplete or of another size
 * \ingroup stereo */
ACMAP_EXPORT PairDirection
measureDirection(const TrinocularFrame& frame,
                 const TrinocularRig& rig,
                 RigCamera neighbour);

} // namespace pcl::acmap

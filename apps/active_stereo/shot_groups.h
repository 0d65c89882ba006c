#pragma once

#include <pcl/core/trinocular_frame.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The shots of an observation, rectified. */
struct ObservationShots {
  std::size_t number = 0; ///< of the observation
  std::vector<TrinocularFrame::ConstPtr> frames;
};

/** \brief Tells which frames of a stream are shots of one observation. What comes of an
 * observation after frames of another one is left out, and what is more than can be fused.
 */
class ShotGroups {
public:
  /** \brief Adds a frame to the shots of its observation.
   * \param[in,out] shots so far, empty for a new observation
   * \return false for a frame of another observation, which is not added */
  bool
  add(const TrinocularFrame::ConstPtr& frame, ObservationShots& shots);

  /** \brief The observation is over. */
  void
  close(const ObservationShots& shots)
  {
    done_.insert(shots.number);
  }

  /** \brief What was left out. */
  const std::vector<std::string>&
  remarks() const
  {
    return remarks_;
  }

private:
  void
  leaveOut(const TrinocularFrame& frame, const std::string& reason);

  std::set<std::size_t> done_; // numbers of observations
  std::set<std::int32_t> cut_; // of those with frames left out
  std::vector<std::string> remarks_;
};

} // namespace pcl::acmap

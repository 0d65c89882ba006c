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

/** \brief Assigns the frames of a stream to observations. Frames of an observation that
 * arrive after frames of another one are left out, and so are more frames than can be
 * fused. */
class ShotGroups {
public:
  /** \brief Adds a frame to the shots of its observation.
   * \param[in,out] shots so far, empty for a new observation
   * \return false for a frame of another observation, which is not added */
  bool
  add(const TrinocularFrame::ConstPtr& frame, ObservationShots& shots);

  /** \brief Ends the observation. */
  void
  close(const ObservationShots& shots)
  {
    done_.insert(shots.number);
  }

  /** \brief Warnings about the frames that were left out. */
  const std::vector<std::string>&
  remarks() const
  {
    return remarks_;
  }

private:
  void
  leaveOut(const TrinocularFrame& frame, const std::string& reason);

  std::set<std::size_t> done_; // numbers of observations
  std::set<std::int32_t> cut_; // observations with frames that were left out
  std::vector<std::string> remarks_;
};

} // namespace pcl::acmap

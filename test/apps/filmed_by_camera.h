#pragma once

#include "emulated_iidc_camera.h"
#include "projector_watch.h"

#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/simulation/simulated_scene.h>

#include <atomic>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap::test {

/** \brief A simulated scene in front of an emulated camera: each exposure shows the
 * scene in the light that a projector, watched on its screen, projected during the
 * exposure. */
class FilmedByCamera {
public:
  /** \param[in] lights images that will be shown: the patterns of an observation, then
   * white */
  FilmedByCamera(const SimulatedScene& scene, const std::vector<RgbImage>& lights);

  /** \brief From now on this projector is watched, and the camera is at the first
   * position again. */
  void
  watch(const ProjectorWatch& projector);

  /** \brief Simulates a projector that hangs: from the second pattern on, this pattern
   * remains. Until \ref watch. */
  void
  hang()
  {
    hangs_ = true;
  }

  /** \brief Simulates a projector with latency: an exposure also sees the light of the
   * previous one. Until \ref watch. */
  void
  linger()
  {
    lingers_ = true;
  }

  /** \brief The image of an exposure: one byte per camera. If the light changed during
   * the exposure, it is mixed. After the last pattern of an observation, a dark
   * exposure begins the next one. */
  std::vector<std::uint8_t>
  expose(const Exposure& exposure);

  /** \brief Number of exposures that mixed two lights. */
  int
  mixed() const
  {
    return mixed_;
  }

  const TrinocularRig&
  rig() const
  {
    return rig_;
  }

  /** \brief Records the session of a camera that is synchronised with the projector. */
  void
  record(const std::string& session) const;

  /** \brief Sets the order of the channels in a pixel. */
  void
  setOrder(const std::array<RigCamera, 3>& order);

private:
  using Shot = std::pair<int, int>; // observation, pattern

  void
  fillBytes();

  TrinocularRig rig_;
  int patterns_;
  int observations_;
  std::map<Shot, TrinocularFrame> shots_; ///< grey
  std::array<RigCamera, 3> order_ = {
      RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  std::map<Shot, std::vector<std::uint8_t>> bytes_;
  const ProjectorWatch* projector_ = nullptr;
  int observation_ = 0;
  bool saw_last_ = false; ///< the last pattern of the observation
  std::atomic<bool> hangs_{false};
  std::atomic<bool> lingers_{false};
  std::set<int> before_; ///< lights of the previous exposure, with latency
  std::atomic<int> mixed_{0};
};

} // namespace pcl::acmap::test

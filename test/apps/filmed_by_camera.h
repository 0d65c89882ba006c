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

/** \brief A simulated place before an emulated camera: what the camera sees in an exposure
 * is what a projector, watched on its screen, threw on the walls meanwhile. */
class FilmedByCamera {
public:
  /** \param[in] lights what will be shown: the patterns of an observation, then white */
  FilmedByCamera(const SimulatedScene& scene, const std::vector<RgbImage>& lights);

  /** \brief From now on this projector is looked at, from the first place again. */
  void
  watch(const ProjectorWatch& projector);

  /** \brief The projector hangs: from the second pattern on, that one is on the walls.
   * Until \ref watch. */
  void
  hang()
  {
    hangs_ = true;
  }

  /** \brief The projector is late: an exposure also sees what the one before it saw.
   * Until \ref watch. */
  void
  linger()
  {
    lingers_ = true;
  }

  /** \brief The image of an exposure: a byte of each camera. Where the light changed
   * meanwhile it is mixed. After the last pattern of an observation, the dark begins the
   * next one. */
  std::vector<std::uint8_t>
  expose(const Exposure& exposure);

  /** \brief Exposures that mixed two lights. */
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

  /** \brief Records what a camera in step with the projector sees. */
  void
  record(const std::string& session) const;

  /** \brief Where the bytes of a pixel go: not in the order that is usual. */
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
  bool saw_last_ = false; ///< pattern of the observation
  std::atomic<bool> hangs_{false};
  std::atomic<bool> lingers_{false};
  std::set<int> before_; ///< lights of the last exposure, where they linger
  std::atomic<int> mixed_{0};
};

} // namespace pcl::acmap::test

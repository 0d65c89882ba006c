#pragma once

#include "shot_shading.h"

#include <pcl/simulation/simulated_scene.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief What all cameras see from one place, by \ref RigCamera. */
using LitViews = std::array<LitView, 3>;

/** \brief Cameras and projector in a scene; nothing in it changes. Work runs in all
 * threads of the caller's arena. */
class RigSimulation {
public:
  /** \param[in] cameras rectified or as they are built, those that the scene's rig has
   * \throws BadArgumentException for a light that cannot be, for cameras of another size
   * than the rig's or that it has not, for patterns that are not of the projector's size
   */
  RigSimulation(SimulatedScene scene,
                const std::vector<RgbImage>& patterns,
                const SimulatedLight& light,
                RigRays cameras);

  const SimulatedScene&
  scene() const
  {
    return scene_;
  }

  const SimulatedLight&
  light() const
  {
    return light_;
  }

  /** \brief One with the projector off, then one for each pattern. */
  std::size_t
  shotsOfObservation() const
  {
    return patterns_.size() + 1;
  }

  /** \throws BadArgumentException when the scene has no such view */
  LitViews
  cast(std::size_t observation) const;

  /** \param[in] views of this observation
   * \param[in] shot from 0, below \ref shotsOfObservation */
  TrinocularFrame::Ptr
  shoot(const LitViews& views,
        std::size_t observation,
        std::size_t shot,
        std::uint64_t seed) const;

private:
  SimulatedScene scene_;
  SimulatedLight light_;
  RigRays cameras_;
  std::vector<LightPattern> patterns_;
};

} // namespace pcl::acmap

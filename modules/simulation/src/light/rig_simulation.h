#pragma once

#include "light_pattern.h"
#include "lit_view.h"

#include <pcl/core/trinocular_frame.h>
#include <pcl/simulation/simulated_scene.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Shades a view that was cast: light, blur, noise, conversion to 8 bits. Each
 * row has its own random stream. Runs in all threads of the caller's arena, with the
 * same result for any number of threads.
 * \param[in] view that was cast
 * \param[in] pattern on the projector, nullptr when it is off
 * \param[in] light and camera model
 * \param[in] stream seed of the noise of this image */
CameraImage
shadeShot(const LitView& view,
          const LightPattern* pattern,
          const SimulatedLight& light,
          std::uint64_t stream);

/** \brief Views of all cameras at one pose, indexed by \ref RigCamera. */
using LitViews = std::array<LitView, 3>;

/** \brief Cameras and projector in a scene; it is constant. Functions run in all
 * threads of the caller's arena. */
class RigSimulation {
public:
  /** \param[in] scene building, rig and views
   * \param[in] patterns of the projector's size
   * \param[in] light and camera model
   * \param[in] cameras of the scene's rig, rectified or not
   * \throws BadArgumentException for an invalid light, for cameras that do not match
   * the rig in number and size, for patterns that are not of the projector's size */
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

  /** \brief Number of shots: one with the projector off, then one for each pattern. */
  std::size_t
  shotsOfObservation() const
  {
    return patterns_.size() + 1;
  }

  /** \brief Casts the views of an observation. \throws BadArgumentException when the
   * scene has no such view */
  LitViews
  cast(std::size_t observation) const;

  /** \brief Shades one shot.
   * \param[in] views of this observation
   * \param[in] observation index in the scene
   * \param[in] shot from 0, below \ref shotsOfObservation
   * \param[in] seed of the noise */
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

/** \brief Settings of a sequence of shots. */
struct SequenceSettings {
  std::uint64_t seed = 1;
  std::size_t observations = 0;
  unsigned threads = 0; ///< 0 = all
};

/** \brief A sequence of shots; keeps the views of one observation at a time. */
class ShotSequence {
public:
  ShotSequence(const RigSimulation& simulation, const SequenceSettings& settings)
  : simulation_(simulation)
  , settings_(settings)
  {}

  /** \brief The next shot; null when there is none left. */
  TrinocularFrame::Ptr
  next();

private:
  const RigSimulation& simulation_;
  SequenceSettings settings_;
  std::size_t observation_ = 0;
  std::size_t shot_ = 0;
  LitViews views_; // of the current observation, after its first shot
};

} // namespace pcl::acmap

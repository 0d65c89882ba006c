#pragma once

#include "rig_simulation.h"

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

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

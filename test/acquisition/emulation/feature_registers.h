#pragma once

#include "register_map.h"

#include <chrono>
#include <cstdint>

namespace pcl::acmap::test {

/** \brief Brightness, exposure, white balance, shutter, gain, trigger, frame rate, pan:
 * capabilities, state, and absolute values (s, dB, frames/s). */
class FeatureRegisters {
public:
  explicit FeatureRegisters(RegisterMap& registers);

  /** \brief Called after a write of the host; keeps value and absolute value
   * consistent. */
  void
  written(std::uint32_t offset);

  std::chrono::duration<double>
  shutter() const;

  /** \brief Maximum frames per second; infinite if the feature is off. */
  double
  frameRate() const;

  /** \brief Do frames wait for a trigger? */
  bool
  triggered() const;

private:
  RegisterMap& registers_;
};

} // namespace pcl::acmap::test

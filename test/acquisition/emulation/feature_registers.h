#pragma once

#include "register_map.h"

#include <chrono>
#include <cstdint>

namespace pcl::acmap::test {

/** \brief Brightness, exposure, white balance, shutter, gain, trigger, frame rate, pan:
 * what they can do, their state, and their absolute values (s, dB, frames/s). */
class FeatureRegisters {
public:
  explicit FeatureRegisters(RegisterMap& registers);

  /** \brief After a write of the host: value and absolute value follow each other. */
  void
  written(std::uint32_t offset);

  std::chrono::duration<double>
  shutter() const;

  /** \brief Frames a second at most; infinite when the feature is off. */
  double
  frameRate() const;

  /** \brief Whether frames wait for a trigger. */
  bool
  triggered() const;

private:
  RegisterMap& registers_;
};

} // namespace pcl::acmap::test

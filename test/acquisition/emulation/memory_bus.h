#pragma once

#include "emulated_iidc_camera.h"

#include <pcl/acquisition/iidc_bus.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>

namespace pcl::acmap::test {

/** \brief A cable from a camera to buses in memory, with switchable faults. It must
 * outlive the buses; only one of them streams at a time. */
class MemoryCable {
public:
  explicit MemoryCable(EmulatedIidcCamera& camera);
  ~MemoryCable();

  MemoryCable(const MemoryCable&) = delete;
  MemoryCable&
  operator=(const MemoryCable&) = delete;

  IidcBusOpener
  opener();

  /** \brief Replaces the values of register reads (not of the ROM). */
  using Garble = std::function<std::uint32_t(std::uint64_t address)>;

  // These may only be changed while there is no communication.
  std::atomic<bool> is_plugged{true};
  Garble garble;
  std::size_t accesses = 0;                     ///< reads and writes so far
  std::size_t failing_access = ~std::size_t{0}; ///< index of the access that fails
  CameraFault failure = CameraFault::Silent;    ///< fault of this access
  std::size_t frame_bytes = 0;                  ///< of the last stream

private:
  friend class MemoryBus;

  EmulatedIidcCamera& camera_;
  std::mutex mutex_;
  std::condition_variable changed_; ///< a frame is available, or waiting was cancelled
};

} // namespace pcl::acmap::test

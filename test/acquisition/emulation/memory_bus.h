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

/** \brief A cable from a camera to buses in memory: what goes over it, and what goes wrong
 * with it. It outlives the buses; one streams at a time. */
class MemoryCable {
public:
  explicit MemoryCable(EmulatedIidcCamera& camera);
  ~MemoryCable();

  MemoryCable(const MemoryCable&) = delete;
  MemoryCable&
  operator=(const MemoryCable&) = delete;

  IidcBusOpener
  opener();

  /** \brief What reads of registers (not of the ROM) give in place of what is there. */
  using Garble = std::function<std::uint32_t(std::uint64_t address)>;

  // All of these are set while nothing goes over the cable.
  std::atomic<bool> is_plugged{true};
  Garble garble;
  std::size_t accesses = 0;                     ///< reads and writes till now
  std::size_t failing_access = ~std::size_t{0}; ///< which of them fails, from 0
  CameraFault failure = CameraFault::Silent;    ///< as this
  std::size_t frame_bytes = 0;                  ///< of the last stream

private:
  friend class MemoryBus;

  EmulatedIidcCamera& camera_;
  std::mutex mutex_;
  std::condition_variable changed_; ///< a frame waits, or it was cancelled
};

} // namespace pcl::acmap::test

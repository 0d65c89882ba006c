#pragma once

#include "checks.h"

#include <pcl/acquisition/iidc_bus.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace pcl::acmap::test {

/** \brief What an input makes of a camera: registers that say something else than those of
 * a sound camera, an access that fails, and what comes over the stream. */
struct HostileCamera {
  explicit HostileCamera(FuzzedBytes numbers);

  std::map<std::uint64_t, std::uint32_t> registers; ///< by address
  std::size_t failing_access = 0;                   ///< from 0; no later one comes back
  CameraFault failure = CameraFault::Silent;        ///< as this
  bool refuses_unknown = false; ///< what is no register; else it is 0 at first
  FuzzedBytes stream;
};

/** \brief A bus to such a camera; nothing on it takes time. */
class RegisterBus : public IidcBus {
public:
  explicit RegisterBus(HostileCamera& camera)
  : camera_(camera)
  {}

  std::string
  place() const override
  {
    return "fuzzed";
  }

  std::uint32_t
  readQuadlet(std::uint64_t address) override;

  void
  writeQuadlet(std::uint64_t address, std::uint32_t value) override;

  void
  startStream(std::size_t frame_bytes, std::size_t frames) override;

  IidcWait
  nextFrame(IidcFrame& frame, std::chrono::milliseconds timeout) override;

  void
  stopStream() noexcept override
  {
    frame_bytes_ = 0;
  }

  void
  cancel() noexcept override
  {}

private:
  std::uint32_t&
  access(std::uint64_t address);

  HostileCamera& camera_;
  std::size_t frame_bytes_ = 0;
  std::uint64_t stamp_ = 1000000;
};

} // namespace pcl::acmap::test

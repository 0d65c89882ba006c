#pragma once

#include "checks.h"

#include <pcl/acquisition/iidc_bus.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace pcl::acmap::test {

/** \brief A camera defined by an input: registers that differ from a valid camera, an
 * access that fails, and the data of the stream. */
struct HostileCamera {
  explicit HostileCamera(FuzzedBytes numbers);

  std::map<std::uint64_t, std::uint32_t> registers; ///< by address
  std::size_t failing_access = 0;                   ///< index, from 0; all later ones
                                                    ///< fail too
  CameraFault failure = CameraFault::Silent;        ///< fault of this access
  bool refuses_unknown = false; ///< unknown registers; else they are 0 at first
  FuzzedBytes stream;
};

/** \brief A bus to such a camera, without any delays. */
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

#pragma once

#include "emulated_iidc_camera.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap::test {

/** \brief What the stream has for one transfer. */
struct StreamPart {
  std::vector<std::uint8_t> bytes;
  int status = 0;         ///< as a transfer of the kernel has it
  bool cable_cut = false; ///< the last that comes
};

/** \brief The bulk endpoint: frames one after the other, each in a transfer of its own, or
 * in as many as it takes. */
class StreamEndpoint {
public:
  explicit StreamEndpoint(EmulatedIidcCamera& camera)
  : camera_(camera)
  {}

  /** \brief None: there is nothing yet. */
  std::optional<StreamPart>
  next(std::size_t most);

  void
  clearHalt()
  {
    halted_ = false;
  }

private:
  bool
  hasFrame();
  StreamPart
  partOfFrame(std::size_t most);

  EmulatedIidcCamera& camera_;
  std::optional<CameraFrame> frame_; ///< under way
  std::size_t sent_ = 0;             ///< bytes of it
  bool empty_packet_ = false;        ///< comes next
  bool halted_ = false;
};

} // namespace pcl::acmap::test

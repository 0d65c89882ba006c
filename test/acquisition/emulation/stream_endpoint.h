#pragma once

#include "emulated_iidc_camera.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap::test {

/** \brief Result of one transfer of the stream. */
struct StreamPart {
  std::vector<std::uint8_t> bytes;
  int status = 0;         ///< as in a transfer of the kernel
  bool cable_cut = false; ///< the cable is unplugged after this part
};

/** \brief The bulk endpoint: sends the frames one after another; each one needs one or
 * more transfers. */
class StreamEndpoint {
public:
  explicit StreamEndpoint(EmulatedIidcCamera& camera)
  : camera_(camera)
  {}

  /** \brief Next part of the stream; nothing if there is no data yet. */
  std::optional<StreamPart>
  next(std::size_t maximum);

  void
  clearHalt()
  {
    halted_ = false;
  }

private:
  bool
  hasFrame();
  StreamPart
  partOfFrame(std::size_t maximum);

  EmulatedIidcCamera& camera_;
  std::optional<CameraFrame> frame_; ///< being sent
  std::size_t sent_ = 0;             ///< bytes sent of this frame
  bool empty_packet_ = false;        ///< is sent next
  bool halted_ = false;
};

} // namespace pcl::acmap::test

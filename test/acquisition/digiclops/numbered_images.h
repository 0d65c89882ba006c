#pragma once

#include "emulated_iidc_camera.h"

#include <pcl/acquisition/channel_order.h>
#include <pcl/core/trinocular_frame.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A source of frames that tell their number, each with other stripes and specks:
 * what came of one can be compared with what was sent, byte by byte. Notes exposures.
 * Stripes, as they have no corners: the check of the channel order is soon done. */
class NumberedImages {
public:
  /** \param[in] seed of another camera: other stripes */
  explicit NumberedImages(std::uint64_t seed = 1);

  std::vector<std::uint8_t>
  bytesOf(std::uint64_t number, std::size_t image_bytes) const;

  /** \brief As a camera asks for it. */
  std::vector<std::uint8_t>
  expose(const Exposure& exposure);

  /** \brief The exposure of a frame that was sent. */
  Exposure
  exposureOf(std::uint64_t number) const;

private:
  std::vector<std::uint8_t> noise_;
  mutable std::mutex mutex_;
  std::map<std::uint64_t, Exposure> exposures_;
};

/** \brief How a grabber's frames were sent. */
struct Sending {
  ChannelOrder order{RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  std::size_t cameras = 3;
  std::string tiles;      ///< of the colour filter; empty without
  bool is_counted = true; ///< the camera writes its counter over the first bytes
};

/** \brief Which frame of a source this is. Fails the test unless all bytes are those that
 * were sent: but for the counter, and under a colour filter the margin. */
std::uint64_t
numberOf(const TrinocularFrame& frame,
         const NumberedImages& images,
         const Sending& sending = {});

} // namespace pcl::acmap::test

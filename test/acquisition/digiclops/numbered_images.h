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

/** \brief A source of frames that contain their number, each with different stripes and
 * specks, so that received frames can be compared with the sent ones byte by byte.
 * Records the exposures. Stripes have no corners, so that the check of the channel
 * order ends early. */
class NumberedImages {
public:
  /** \param[in] seed different cameras have different stripes */
  explicit NumberedImages(std::uint64_t seed = 1);

  std::vector<std::uint8_t>
  bytesOf(std::uint64_t number, std::size_t image_bytes) const;

  /** \brief Creates the image of an exposure; called by the emulated camera. */
  std::vector<std::uint8_t>
  expose(const Exposure& exposure);

  /** \brief The exposure of a sent frame. */
  Exposure
  exposureOf(std::uint64_t number) const;

private:
  std::vector<std::uint8_t> noise_;
  mutable std::mutex mutex_;
  std::map<std::uint64_t, Exposure> exposures_;
};

/** \brief The format in which frames were sent. */
struct Sending {
  ChannelOrder order{RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  std::size_t cameras = 3;
  std::string tiles;      ///< of the colour filter; empty if there is none
  bool is_counted = true; ///< the camera overwrites the first bytes with its counter
};

/** \brief Number of a received frame. Fails the test unless all bytes are equal to
 * those sent, except for the counter and, with a colour filter, the margin. */
std::uint64_t
numberOf(const TrinocularFrame& frame,
         const NumberedImages& images,
         const Sending& sending = {});

} // namespace pcl::acmap::test

#pragma once

#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A way to keep frames in a folder. */
class FrameWay {
public:
  virtual ~FrameWay() = default;

  virtual std::string
  name() const = 0;

  virtual void
  write(const TrinocularFrame& frame) = 0;

  /** \brief Called once all are written. */
  virtual void
  finish() = 0;

  /** \brief The images of a frame.
   * \param[in] number counts the frames as they were written */
  virtual std::array<CameraImage, 3>
  read(std::size_t number) const = 0;

  /** \brief Of all its files. */
  virtual std::uintmax_t
  bytes() const = 0;
};

/** \brief The values alone, a file a camera; the recorder's; a PNG a camera: each in a
 * part of the folder of its own. */
std::vector<std::unique_ptr<FrameWay>>
waysToKeepFrames(const std::string& folder, const TrinocularRig& rig);

} // namespace pcl::acmap::bench

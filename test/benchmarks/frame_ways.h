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

/** \brief A method to store frames in a folder. */
class FrameWay {
public:
  virtual ~FrameWay() = default;

  virtual std::string
  name() const = 0;

  virtual void
  write(const TrinocularFrame& frame) = 0;

  /** \brief Called after all frames have been written. */
  virtual void
  finish() = 0;

  /** \brief The images of a frame.
   * \param[in] number in the order of writing */
  virtual std::array<CameraImage, 3>
  read(std::size_t number) const = 0;

  /** \brief Size of all files. */
  virtual std::uintmax_t
  bytes() const = 0;
};

/** \brief Raw values with one file per camera; the recorder; one PNG per camera. Each
 * method uses its own subfolder. */
std::vector<std::unique_ptr<FrameWay>>
waysToKeepFrames(const std::string& folder, const TrinocularRig& rig);

} // namespace pcl::acmap::bench

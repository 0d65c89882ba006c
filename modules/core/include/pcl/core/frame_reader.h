#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief What was found in the frames of a \ref FrameReader so far. Frames are identified
 * by their numbers. \ingroup core */
struct FrameFaults {
  std::vector<std::uint64_t> broken;    ///< they cannot be read
  std::vector<std::uint64_t> saturated; ///< a camera is overexposed
  std::vector<std::uint64_t> black;     ///< a camera is dark
  std::vector<std::string> remarks;     ///< one per fault, those of the opening first
};

/** \brief Frames that can be read in any order: a raw session, lists of images, or frames
 * of your own. \ref frame may be called by several threads. \ingroup core */
class ACMAP_EXPORT FrameReader {
public:
  virtual ~FrameReader() = default;

  /** \brief Folder of the frames, for messages; empty if they have none. */
  virtual std::string
  folder() const = 0;

  /** \brief Geometry of the frames. */
  virtual TrinocularRig
  getRig() const = 0;

  /** \brief Number of frames, including broken ones. */
  virtual std::size_t
  frames() const = 0;

  /** \brief Observation of a frame, which is known without reading its images; nothing if
   * the frame is known to be broken. */
  virtual std::optional<std::int32_t>
  observationOf(std::size_t index) const = 0;

  /** \brief Reads a frame.
   * \param[in] index from 0 to \ref frames - 1; not the frame's number, which may have
   * gaps
   * \throws InputFileException when it is broken */
  virtual TrinocularFrame::Ptr
  frame(std::size_t index) const = 0;

  virtual FrameFaults
  faults() const = 0;
};

} // namespace pcl

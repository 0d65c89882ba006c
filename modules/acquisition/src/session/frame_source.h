#pragma once

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Frames that are stored in files, in their order. May be read from any
 * thread. */
class FrameSource {
public:
  virtual ~FrameSource() = default;

  virtual std::size_t
  size() const = 0;

  /** \brief The number of a frame; does not read the frame. */
  virtual std::uint64_t
  number(std::size_t index) const = 0;

  /** \brief The observation of a frame; does not read its images. Nothing if its header is
   * broken. */
  virtual std::optional<std::int32_t>
  observation(std::size_t index) const = 0;

  /** \brief Folder of a session, else empty. */
  virtual std::string
  folder() const = 0;

  /** \throws InputFileException naming file, frame and fault */
  virtual TrinocularFrame
  read(std::size_t index) const = 0;

  virtual const TrinocularRig&
  rig() const = 0;
};

/** \brief Opens a session.
 * \param[in] folder of the session
 * \param[out] report findings that do not require reading the images
 * \throws InputFileException when there is no session */
std::unique_ptr<FrameSource>
openSession(const std::string& folder, TrinocularFileReport& report);

/** \brief One observation from lists of images, with one entry per pattern.
 * \throws BadArgumentException when the lists have different lengths, do not match the
 * cameras of the rig, or contain a file twice */
std::unique_ptr<FrameSource>
openImageLists(const TrinocularImageLists& lists, const TrinocularRig& rig);

} // namespace pcl::acmap

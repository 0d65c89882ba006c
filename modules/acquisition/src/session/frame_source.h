#pragma once

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Frames that lie in files, in their order. May be read from any thread. */
class FrameSource {
public:
  virtual ~FrameSource() = default;

  virtual std::size_t
  size() const = 0;

  /** \brief The number of a frame, known without reading it. */
  virtual std::uint64_t
  number(std::size_t index) const = 0;

  /** \throws InputFileException naming file, frame and fault */
  virtual TrinocularFrame
  read(std::size_t index) const = 0;

  virtual const TrinocularRig&
  rig() const = 0;
};

/** \brief Opens a session.
 * \param[out] report what can be told of it without reading the images
 * \throws InputFileException when there is none */
std::unique_ptr<FrameSource>
openSession(const std::string& folder, TrinocularFileReport& report);

/** \brief One observation from lists of images, one entry a pattern.
 * \throws BadArgumentException when the lists are not as long as each other, or not as
 * many as the rig has cameras, or a file stands in them twice */
std::unique_ptr<FrameSource>
openImageLists(const TrinocularImageLists& lists, const TrinocularRig& rig);

} // namespace pcl::acmap

#pragma once

#include "frame_rectifier.h"
#include "shot_groups.h"
#include "stereo_options.h"

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Reads the observations of a session, or the one of image lists, one after
 * another, and rectifies them if they are not rectified. */
class ShotSource {
public:
  /** \param[in] threads 0 = all
   * \throws InputFileException when session, rig or the image for the colours are
   * missing or malformed, or the rig cannot be rectified or matched
   * \throws UsageError for lists of a camera that is not in the rig
   * \throws BadArgumentException for lists of different lengths */
  ShotSource(const StereoOptions& options, unsigned threads);

  /** \brief Rig of the rectified frames. */
  const TrinocularRig&
  rig() const
  {
    return rectifier_.rig();
  }

  /** \brief Does the rig's file have unrectified cameras? */
  bool
  hasCameras() const
  {
    return has_cameras_;
  }

  bool
  isRectifying() const
  {
    return rectifier_.isRectifying();
  }

  /** \brief Number of frames, including broken ones. */
  std::size_t
  frames() const
  {
    return grabber_->frames();
  }

  /** \brief Number of frames that belong to the observations so far, or were left
   * out. */
  std::size_t
  passed() const
  {
    return next_ - (pending_ ? 1 : 0);
  }

  /** \brief Reads the next observation. Broken frames of a session are left out and
   * reported in the remarks.
   * \return nothing at the end
   * \throws InputFileException for an image of the lists that cannot be read */
  std::optional<ObservationShots>
  next();

  /** \brief Number of the last observation that can be read.
   * \throws InputFileException when no frame can be read */
  std::size_t
  lastObservation() const;

  /** \brief Warnings so far. */
  std::vector<std::string>
  remarks() const;

  /** \brief Numbers of the frames that could not be read so far. */
  std::vector<std::uint64_t>
  broken() const
  {
    return grabber_->getReport().broken;
  }

private:
  TrinocularFrame::Ptr
  read(std::size_t index) const;

  TrinocularFrame::ConstPtr
  loadOffShot(const std::string& path) const;

  void
  noteBroken();

  std::unique_ptr<TrinocularFileGrabber> grabber_;
  bool skips_broken_;
  bool is_passive_; // the frame was not taken under a pattern
  bool has_cameras_;
  FrameRectifier rectifier_;
  std::size_t next_ = 0;
  // first frame of the next observation, already read
  TrinocularFrame::ConstPtr pending_;
  ShotGroups groups_;
  std::size_t broken_; // number of frames that are known to be
  std::vector<std::string> remarks_;
};

} // namespace pcl::acmap

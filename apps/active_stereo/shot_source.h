#pragma once

#include "stereo_options.h"
#include "stereo_shots.h"

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief The shots of the next observation, and the progress of the whole work. */
struct ComingShots {
  std::optional<ObservationShots> shots; ///< nothing at the end
  double done = 0;                       ///< fraction of all frames
};

/** \brief At which pace the frames of a session are read. */
enum class ReplayPace {
  AtOnce,    ///< as fast as they can be read
  AsRecorded ///< at the times of their stamps, as a camera gives them; pauses of more
             ///< than a minute are cut
};

/** \brief Reads the observations of a session, or the one of image lists, one after
 * another, and rectifies them if they are not rectified. */
class ShotSource {
public:
  /** \param[in] options are referred to
   * \throws InputFileException when session, rig or the image for the colours are
   * missing or malformed, or the rig cannot be rectified or matched
   * \throws UsageError for lists of a camera that is not in the rig
   * \throws BadArgumentException for lists of different lengths */
  ShotSource(const StereoOptions& options,
             unsigned threads,
             ReplayPace pace = ReplayPace::AtOnce);

  /** \brief Sets what is called about ten times a second while a replay waits. */
  void
  setIdle(std::function<void()> idle)
  {
    idle_ = std::move(idle);
  }

  /** \brief Rig of the rectified frames. */
  const TrinocularRig&
  rig() const
  {
    return rectifier_.rig();
  }

  bool
  isRectifying() const
  {
    return rectifier_.isRectifying();
  }

  /** \brief Are images matched as they are, though the rig has unrectified cameras? */
  bool
  mayNeedRectification() const
  {
    return options_.hasLists() && has_cameras_ && !isRectifying();
  }

  /** \brief Reads the next observation. Broken frames of a session are left out and
   * reported in the remarks.
   * \throws InputFileException for an image of the lists that cannot be read */
  ComingShots
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
  TrinocularFrame::ConstPtr
  loadOffShot(const std::string& path) const;

  void
  waitFor(const TrinocularFrame& frame);

  void
  noteBroken();

  const StereoOptions& options_;
  std::unique_ptr<TrinocularFileGrabber> grabber_;
  bool has_cameras_;
  FrameRectifier rectifier_;
  ReplayPace pace_;
  std::function<void()> idle_ = [] {};
  std::size_t next_ = 0;
  ShotGroups groups_;
  std::size_t broken_; ///< number of frames that are known to be
  std::vector<std::string> remarks_;
  std::optional<std::uint64_t> stamp_; ///< of the last frame of a replay, microseconds
  std::chrono::steady_clock::time_point due_; ///< when it was due
};

} // namespace pcl::acmap

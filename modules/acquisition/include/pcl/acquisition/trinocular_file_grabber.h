#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/report.h>
#include <pcl/core/trinocular_grabber.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

/** \brief Which shot of a session. \ingroup acquisition */
struct TrinocularShot {
  std::int32_t observation = 0;
  std::int32_t pattern = TrinocularFrame::no_pattern;
};

inline bool
operator==(const TrinocularShot& a, const TrinocularShot& b)
{
  return a.observation == b.observation && a.pattern == b.pattern;
}

/** \brief What a \ref TrinocularFileGrabber found, when it was opened and in what was read
 * since; each finding has a remark too. Frames are told by their numbers.
 * \ingroup acquisition */
struct TrinocularFileReport : Report {
  std::size_t frames = 0;  ///< how many files there are
  bool is_finished = true; ///< false: the recording did not come to its end

  /** \brief Of frames that cannot be read. Headers are looked at when the session is
   * opened, images when they are read. */
  std::vector<std::uint64_t> broken;

  /** \brief Shots that an observation lacks, and others have; the first 1000. */
  std::vector<TrinocularShot> missing;

  /** \brief Of frames whose shot was there before. They are given as all others. */
  std::vector<std::uint64_t> doubled;

  /** \brief Of frames read with a camera that has 10 % of its values at 255. */
  std::vector<std::uint64_t> saturated;

  /** \brief Of frames read with a camera that has 99 % of its values at most at 4. */
  std::vector<std::uint64_t> black;
};

/** \brief Images as files, as \ref loadRgbImage reads them: one observation, one entry a
 * pattern. \ingroup acquisition */
struct TrinocularImageLists {
  std::vector<std::string> reference;
  std::vector<std::string> horizontal; ///< as many; empty: no such camera
  std::vector<std::string> vertical;   ///< as many; empty: no such camera
};

/** \brief Gives the frames of a raw session, or of lists of images, as a camera would:
 * in the manner of pcl::PCDGrabber. See \ref TrinocularGrabber for what holds of its
 * callbacks.
 *
 * With frames a second \ref start streams to the end of the files, or for ever. Without
 * (0), each \ref start or \ref trigger gives one frame. After the end, \ref rewind comes
 * first.
 * \code
 * pcl::TrinocularFileGrabber grabber ("session", 14.0f);
 * const std::function<pcl::TrinocularGrabber::FrameCallback> look =
 *     [] (const pcl::TrinocularFrame::ConstPtr& frame) { ... };
 * grabber.registerCallback (look);
 * grabber.start ();
 * grabber.wait ();
 * if (grabber.getError ())
 *   std::rethrow_exception (grabber.getError ());
 * \endcode
 * \ingroup acquisition */
class ACMAP_EXPORT TrinocularFileGrabber : public TrinocularGrabber {
public:
  /** \brief Opens a session; one that was never finished too, which the report tells.
   * \param[in] session folder
   * \param[in] frames_per_second 0: one at a time; else within [0.001, 1000]
   * \param[in] repeat begin again after the last frame
   * \throws InputFileException when there is none, or `rig.yaml` or `session.yaml` is
   * malformed
   * \throws BadArgumentException for another rate */
  explicit TrinocularFileGrabber(const std::string& session,
                                 float frames_per_second = 0,
                                 bool repeat = false);

  /** \brief Takes images; those of entry i become frame i, observation 0, pattern i, stamp
   * 0, with three channels.
   * \throws BadArgumentException when the lists differ in length, are not those of the
   * rig's cameras, or name a file twice; for a rig that no camera can have; for another
   * rate */
  TrinocularFileGrabber(const TrinocularImageLists& images,
                        const TrinocularRig& rig,
                        float frames_per_second = 0,
                        bool repeat = false);

  /** \brief Stops. Not to be called from a callback. */
  ~TrinocularFileGrabber() noexcept override;

  void
  start() override;

  void
  stop() override;

  void
  trigger() override;

  void
  rewind() override;

  void
  wait() override;

  bool
  isRunning() const override;

  /** \brief `TrinocularFileGrabber` */
  std::string
  getName() const override;

  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const override;

  std::exception_ptr
  getError() const override;

  /** \brief How many frames there are, broken ones with them. */
  std::size_t
  frames() const;

  /** \brief Reads one frame, whatever the stream does.
   * \param[in] index from 0 to \ref frames; not the frame's number, which may have gaps
   * \throws BadArgumentException for an index beyond
   * \throws InputFileException naming file, frame and fault when it cannot be read, or its
   * images are not those of the rig */
  TrinocularFrame::Ptr
  frame(std::size_t index) const;

  /** \brief Sets whether frames that cannot be read are left out and told by the report;
   * else (default) the first one ends the stream with an error that names it. */
  void
  setSkipBroken(bool skip);

  bool
  getSkipBroken() const;

  TrinocularFileReport
  getReport() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl

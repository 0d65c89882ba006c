#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/fields.h>
#include <pcl/core/frame_reader.h>
#include <pcl/core/report.h>
#include <pcl/core/streamed_grabber.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Identifies a shot of a session. \ingroup acquisition */
struct TrinocularShot {
  std::int32_t observation = 0;
  std::int32_t pattern = TrinocularFrame::no_pattern;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const TrinocularShot& shot, Visitor&& visit)
{
  visit({"observation"}, shot.observation);
  visit({"pattern"}, shot.pattern);
}

inline bool
operator==(const TrinocularShot& a, const TrinocularShot& b)
{
  return a.observation == b.observation && a.pattern == b.pattern;
}

/** \brief Findings of a \ref TrinocularFileGrabber at the opening of the session and in
 * the frames that were read since then. There is also a remark for each finding. Frames
 * are identified by their numbers.
 * \ingroup acquisition */
struct TrinocularFileReport : Report {
  std::size_t frames = 0;  ///< number of frame files
  bool is_finished = true; ///< false: the recording was not finished

  /** \brief Frames that cannot be read. Headers are checked when the session is opened,
   * images when they are read. */
  std::vector<std::uint64_t> broken;

  /** \brief Shots that are missing in an observation but present in others; only the
   * first 1000. */
  std::vector<TrinocularShot> missing;

  /** \brief Frames whose shot occurred earlier. They are passed on as all others. */
  std::vector<std::uint64_t> doubled;

  /** \brief Frames that were read in which one camera has at least 10 % of its values
   * at 255. */
  std::vector<std::uint64_t> saturated;

  /** \brief Frames that were read in which one camera has at least 99 % of its values
   * in 0..4. */
  std::vector<std::uint64_t> black;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const TrinocularFileReport& report, Visitor&& visit)
{
  visit({"frames"}, report.frames);
  visit({"is_finished"}, report.is_finished);
  visit({"broken_frames"}, report.broken);
  visit({"missing"}, report.missing);
  visit({"left_out_frames"}, report.doubled);
  visit({"saturated"}, report.saturated);
  visit({"black"}, report.black);
}

/** \brief Image files, which are read by \ref loadRgbImage, one observation, one entry
 * per pattern. \ingroup acquisition */
struct TrinocularImageLists {
  std::vector<std::string> reference;
  std::vector<std::string> horizontal; ///< as many entries; empty: no such camera
  std::vector<std::string> vertical;   ///< as many entries; empty: no such camera
};

/** \brief Reads the frames of a raw session or of lists of images and passes them on as
 * a camera would, similar to pcl::PCDGrabber. See \ref TrinocularGrabber for the rules
 * of its callbacks.
 *
 * With a frame rate, \ref start streams to the end of the files, or without end if
 * repetition is set. Without a frame rate (0), each \ref start or \ref trigger gives
 * one frame. After the end, \ref rewind must be called first.
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
class ACMAP_EXPORT TrinocularFileGrabber : public acmap::StreamedGrabber,
                                           public FrameReader {
public:
  /** \brief Opens a session. A session that was never finished is accepted and noted in
   * the report.
   * \param[in] session folder
   * \param[in] frames_per_second 0: one frame per call; otherwise within [0.001, 1000]
   * \param[in] repeat start again after the last frame
   * \throws InputFileException when there is no session, or `rig.yaml` or
   * `session.yaml` is malformed
   * \throws BadArgumentException for any other rate */
  explicit TrinocularFileGrabber(const std::string& session,
                                 float frames_per_second = 0,
                                 bool repeat = false);

  /** \brief Opens lists of images; those of entry i become frame i of observation 0 and
   * pattern i, with time stamp 0 and three channels.
   * \throws BadArgumentException when the lists have different lengths, do not match
   * the rig's cameras, or name a file twice; if the rig is invalid; for any other
   * rate */
  TrinocularFileGrabber(const TrinocularImageLists& images,
                        const TrinocularRig& rig,
                        float frames_per_second = 0,
                        bool repeat = false);

  /** \brief Stops the stream. Must not be called from a callback. */
  ~TrinocularFileGrabber() noexcept override;

  void
  start() override;

  void
  trigger() override;

  void
  rewind() override;

  float
  getFramesPerSecond() const override;

  TrinocularRig
  getRig() const override;

  std::string
  folder() const override;

  std::size_t
  frames() const override;

  std::optional<std::int32_t>
  observationOf(std::size_t index) const override;

  /** \brief Reads one frame, independently of the stream.
   * \param[in] index from 0 to \ref frames - 1; not the frame's number, which may have
   * gaps
   * \throws BadArgumentException if the index is out of range
   * \throws InputFileException naming file, frame and fault when the frame cannot be
   * read, or its images do not match the rig */
  TrinocularFrame::Ptr
  frame(std::size_t index) const override;

  FrameFaults
  faults() const override;

  /** \brief Sets whether frames that cannot be read are skipped and only noted in the
   * report; otherwise (default) the first one ends the stream with an error that names
   * it. */
  void
  setSkipBroken(bool skip);

  bool
  getSkipBroken() const;

  TrinocularFileReport
  getReport() const;

private:
  acmap::StreamThread&
  stream() const override;

  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl

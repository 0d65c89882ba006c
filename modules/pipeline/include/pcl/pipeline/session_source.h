#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/frame_reader.h>
#include <pcl/core/progress.h>
#include <pcl/core/report.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/stereo/disparity_back_projection.h>
#include <pcl/stereo/disparity_fusion.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl {

/** \brief How the shots of a session become observations. \ingroup pipeline */
struct SessionSettings {
  ACMAP_EXPORT
  SessionSettings();

  DisparityFusion::Method method = DisparityFusion::Method::SpaceTime;
  TrinocularMatching matching;        ///< its rig and its disparities are not used
  DisparityBackProjection projection; ///< its depths (0.5 to 10 m) are searched
  bool unlit = false;   ///< passive stereo of the shots without projected light
  bool passive = false; ///< passive stereo: no shot was taken under projected light
  std::string rig;      ///< file of the cameras; empty: the rig.yaml of the session
  /** \brief Are the frames as the cameras gave them? Not given: if the file of the cameras
   * has more than the rig of rectified frames. */
  std::optional<bool> rectify;
  /** \brief The cameras of frames that are as the cameras gave them, in place of those in
   * the file. */
  std::optional<RigCalibration> cameras;
  bool keeps_baseline = false; ///< even if the images contradict its sign
  /** \brief Image of the reference view of the first observation, taken without projected
   * light, as the cameras gave it; empty: none. */
  std::string color;
  bool skip_broken = true; ///< leave out frames that cannot be read
  /** \brief Called with each frame that was read, before it is used. */
  std::function<void(const TrinocularFrame&)> arrived;
  unsigned threads = 0; ///< 0 for all

  bool
  isPassive() const
  {
    return unlit || passive;
  }
};

/** \brief An observation, and what was found on the way. \ingroup pipeline */
struct SessionObservation {
  std::size_t number = 0; ///< in the session
  std::size_t frames = 0; ///< number of its shots
  MatchedDisparity matched;
  PointCloud<PointXYZRGBSigma> cloud; ///< organized, camera frame, metres
  DisparityFusionReport fusion;
  DisparityBackProjectionReport projection;
};

/** \brief Sums over the observations of a session that were fused. \ingroup pipeline */
struct SessionReport : Report {
  std::size_t observations = 0;
  std::size_t frames = 0;
  std::size_t points = 0;
  std::size_t too_near = 0; ///< pixels nearer than the depths that are searched
  std::size_t too_far = 0;  ///< pixels farther away
  std::array<std::size_t, disparity_outcomes> outcomes{};
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const SessionReport& report, Visitor&& visit)
{
  visit({"observations"}, report.observations);
  visit({"frames"}, report.frames);
  visit({"points"}, report.points);
  visit({"too_near"}, report.too_near);
  visit({"too_far"}, report.too_far);
  visit({"outcomes"}, acmap::Named{report.outcomes, acmap::disparity_outcome_names});
}

namespace acmap {

/** \brief Does a rig's file have unrectified cameras? The frames of a session with such
 * a file, and those of a camera, are not rectified yet.
 * \throws InputFileException when it cannot be read */
ACMAP_EXPORT bool
hasBuiltCameras(const std::string& path);

/** \brief The shots of an observation, rectified. */
struct ObservationShots {
  std::size_t number = 0; ///< of the observation
  std::vector<TrinocularFrame::ConstPtr> frames;
};

/** \brief Assigns the frames of a stream to observations. Frames of an observation that
 * arrive after frames of another one are left out, and so are more frames than can be
 * fused. */
class ACMAP_EXPORT ShotGroups {
public:
  /** \brief Adds a frame.
   * \return the observation before, if the frame belongs to another one */
  std::optional<ObservationShots>
  add(const TrinocularFrame::ConstPtr& frame);

  /** \brief Ends the current observation.
   * \return nothing if it has no shot */
  std::optional<ObservationShots>
  finish();

  /** \brief Begins anew after other observations. */
  void
  restart(std::set<std::size_t> done);

  /** \brief Warnings about the frames that were left out, one per observation. */
  const std::vector<std::string>&
  remarks() const
  {
    return remarks_;
  }

private:
  ObservationShots shots_;     // of the current observation
  std::set<std::size_t> done_; // numbers of observations
  std::set<std::int32_t> cut_; // observations with frames that were left out
  std::vector<std::string> remarks_;
};

/** \brief Prepares frames for matching: rectifies them unless they are rectified
 * already. */
class ACMAP_EXPORT FrameRectifier {
public:
  /** \param[in] path of the rig's file, for messages
   * \param[in] rig of the frames; cameras that it does not have are not used
   * \param[in] cameras that gave unrectified frames; nothing for rectified ones
   * \param[in] threads 0 = all
   * \throws InputFileException when the rig cannot be matched or the cameras cannot be
   * rectified */
  FrameRectifier(const std::string& path,
                 const TrinocularRig& rig,
                 std::optional<RigCalibration> cameras,
                 unsigned threads);

  /** \brief Rig of the rectified frames. */
  const TrinocularRig&
  rig() const
  {
    return rig_;
  }

  bool
  isRectifying() const
  {
    return rectification_.has_value();
  }

  /** \brief Thread-safe. */
  void
  rectify(TrinocularFrame& frame) const;

  /** \brief Warnings about the cameras. */
  const std::vector<std::string>&
  remarks() const
  {
    return remarks_;
  }

private:
  TrinocularRig rig_;
  std::optional<TrinocularRectification> rectification_;
  std::vector<std::string> remarks_;
};

/** \brief The disparities that are searched. */
struct SearchRange {
  int minimum = 0; ///< px
  int count = 0;   ///< number of disparities, starting at the minimum

  int
  maximum() const
  {
    return minimum + count - 1;
  }
};

/** \brief Disparities between two depths, extended by one pixel at both ends, and
 * limited by the size of the image and the range of the matcher.
 * \param[in] rig with a neighbour
 * \param[in] nearest metres
 * \param[in] farthest metres, above the nearest
 * \throws BadArgumentException when the image is too small for any of them */
ACMAP_EXPORT SearchRange
disparitiesBetween(const TrinocularRig& rig, double nearest, double farthest);

/** \brief Depth of a disparity, metres. */
ACMAP_EXPORT double
depthOf(const TrinocularRig& rig, double disparity);

/** \brief Sets fusion and projection for a rig.
 * \param[in] cost gets the memory for the costs of all disparities. That of the shots is
 * not considered: their number is not known before they are read
 * \return the disparities that are searched
 * \throws BadArgumentException for depths that do not suit the rig, and what the callback
 * throws */
ACMAP_EXPORT SearchRange
setUpStereo(const TrinocularRig& rig,
            const SessionSettings& settings,
            const CostCallback& cost,
            DisparityFusion& fusion,
            DisparityBackProjection& projection);

/** \brief Computes the observations of one rig from their shots. */
class ACMAP_EXPORT ShotFusion {
public:
  /** \throws what \ref setUpStereo does */
  ShotFusion(const TrinocularRig& rig,
             const SessionSettings& settings,
             const CostCallback& cost);

  const SearchRange&
  range() const
  {
    return range_;
  }

  /** \throws CancelledException when the callback requests it */
  SessionObservation
  fuse(const ObservationShots& shots, const ProgressCallback& progress);

private:
  DisparityFusion fusion_;
  DisparityBackProjection projection_;
  SearchRange range_; ///< set with both
};

} // namespace acmap

/** \brief The observations of a session, which are fused of its shots when they are needed.
 * Section II-A of "Active Stereo Based Compact Mapping".
 *
 * There is one observation for each number in the headers of the frames, in the order in
 * which they begin; numbers may have gaps. A frame that cannot be read is left out; an
 * observation without any readable frame cannot be loaded. Reads each frame once, if each
 * observation is loaded once. Poses are not known.
 * \code
 * const auto frames = std::make_shared<pcl::TrinocularFileGrabber> ("session");
 * const auto session = pcl::openSession (frames);
 * while (const auto seen = session->next ())
 *   std::cout << seen->number << ": " << seen->projection.points << " points\n";
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT SessionSource : public ObservationSource {
public:
  /** \throws what \ref openSession does */
  SessionSource(std::shared_ptr<const FrameReader> frames,
                const SessionSettings& settings,
                const CostCallback& cost);

  ~SessionSource() override;

  std::string
  name() const override;

  std::size_t
  size() const override
  {
    return numbers_.size();
  }

  /** \brief Name of a file with the \ref numberOf the observation. */
  std::string
  nameOf(std::size_t i) const override;

  Trajectory
  trajectory() const override
  {
    return {};
  }

  /** \throws InputFileException if no frame of the observation can be read */
  PointCloudFile
  load(std::size_t i) const override;

  /** \brief Warnings about the frames that were read so far. */
  std::vector<std::string>
  remarks() const override;

  /** \brief Number of an observation in the session. */
  std::size_t
  numberOf(std::size_t i) const
  {
    return numbers_.at(i);
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

  /** \brief The disparities that are searched. */
  const acmap::SearchRange&
  range() const
  {
    return fusion_->range();
  }

  /** \brief Reads the shots of an observation; those of several are read one after another.
   * \return nothing if none can be read, or none is of the kind that is used */
  std::optional<acmap::ObservationShots>
  shots(std::size_t i) const;

  /** \throws CancelledException when the callback requests it */
  SessionObservation
  fuse(const acmap::ObservationShots& shots,
       const ProgressCallback& progress = {}) const;

  /** \brief Fuses the next observation that has shots, and reads the one after it
   * meanwhile.
   * \return nothing at the end
   * \throws CancelledException when the callback requests it */
  std::optional<SessionObservation>
  next(const ProgressCallback& progress = {});

  /** \brief Reads the shots of the next observation that \ref next would fuse. */
  std::optional<acmap::ObservationShots>
  nextShots();

  /** \brief Sums over what was fused so far. */
  SessionReport
  getReport() const;

private:
  void
  findObservations();

  TrinocularFrame::ConstPtr
  loadColor() const;

  TrinocularFrame::Ptr
  read(std::size_t index) const;

  void
  checkDirections(const TrinocularFrame& frame) const;

  const std::shared_ptr<const FrameReader> frames_;
  const SessionSettings settings_;
  const std::string rig_file_;
  const acmap::FrameRectifier rectifier_;
  std::vector<std::size_t> begins_;  // first frame of each observation, and the end
  std::vector<std::size_t> numbers_; // of each observation
  TrinocularFrame::ConstPtr color_;

  mutable std::mutex reading_; // of what is read, and of what is noted
  mutable acmap::ShotGroups groups_;
  mutable std::vector<std::string> remarks_;
  mutable std::size_t broken_; // number of frames that are known to be

  mutable std::mutex fusing_;
  mutable std::optional<acmap::ShotFusion> fusion_;
  mutable SessionReport report_;

  std::size_t place_ = 0;                                     // of nextShots
  std::future<std::optional<acmap::ObservationShots>> ahead_; // ends before the others
};

/** \brief Opens a session, or other frames.
 * \param[in] frames such as pcl::TrinocularFileGrabber
 * \param[in] cost is called before the fusion is set up, see \ref CostCallback
 * \throws InputFileException when the file of the rig or the image for the colours is
 * missing or malformed, or the rig cannot be rectified or matched
 * \throws BadArgumentException without frames, for a minimum depth that is not below the
 * maximum, and for depths that do not suit the rig \ingroup pipeline */
ACMAP_EXPORT std::shared_ptr<SessionSource>
openSession(std::shared_ptr<const FrameReader> frames,
            const SessionSettings& settings = {},
            const CostCallback& cost = {});

} // namespace pcl

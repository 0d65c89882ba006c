#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/pose_convention.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

class ObservationSource;
struct RgbdCameras;
struct RgbdSequence;

namespace acmap {
class ByteParcel;
class ObservationCache;
class RgbdReader;

/** \brief Remarks of one kind, not none, as one line: poses that were rectified differ from
 * all VIEWPOINTs. */
std::string
inOneLine(const std::vector<std::string>& remarks);
} // namespace acmap

/** \brief An observation of a sequence with its pose. \ingroup pipeline */
struct PosedObservation {
  std::shared_ptr<const PointCloudFile> file; ///< camera frame, metres; not null
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  std::vector<std::string> remarks; ///< warnings about its pose, one per line
};

/** \brief The observations of a trajectory, read when they are needed.
 *
 * An observation is a PCD file in the frame of its camera, a cloud in memory, or a frame
 * of an RGB-D folder. The pose of a file is the row of `trajectory.txt` that
 * \ref acmap::trajectoryRows finds, or else its VIEWPOINT. What was read stays in memory
 * up to a limit (\ref setCacheSize), so that several stages read it once; copies of a
 * sequence share it.
 * \code
 * const pcl::ObservationSequence sequence ("observations");
 * for (std::size_t i = 0; i < sequence.size (); ++i) {
 *   const pcl::PosedObservation seen = sequence.load (i);
 *   std::cout << sequence.name (i) << ": " << seen.file->points ().size () << " points\n";
 * }
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT ObservationSequence {
public:
  /** \brief Opens a folder of PCD files.
   * \param[in] folder observations, and a trajectory.txt if their poses are known
   *
   * Where clouds or poses are those of a national grid, all clouds lose the same whole
   * kilometres, those that the first readable one asks for, and the map is shifted
   * (\ref shift).
   * \param[in] scale metres in a unit of clouds and trajectory
   * \param[in] shift that of the map, metres; none: found
   * \throws InputFileException if it is no folder, holds no PCD file, or its trajectory
   * cannot be read or has no row for an observation */
  explicit ObservationSequence(const std::string& folder,
                               double scale = 1,
                               const std::optional<Eigen::Vector3d>& shift = {});

  /** \brief Takes PCD files in the given order, with their VIEWPOINTs as poses.
   * \param[in] scale metres in a unit of the clouds
   * \throws BadArgumentException if there is none */
  explicit ObservationSequence(std::vector<std::string> files, double scale = 1);

  /** \brief Takes clouds in memory, which are named as files of a sequence are.
   * \param[in] clouds one per observation, camera frame, metres
   * \param[in] trajectory their poses; empty: those of their sensors
   * \throws BadArgumentException if there is no cloud, one is missing, or the
   * trajectory has another number of poses */
  explicit ObservationSequence(
      std::vector<std::shared_ptr<const PointCloudFile>> clouds,
      Trajectory trajectory = {});

  /** \brief Takes the frames of an RGB-D folder, which are converted to observations
   * when they are needed (\ref loadRgbdObservation), and are named as files of a sequence
   * are. Their poses are read at once; the map is the frame of the first observation's
   * camera.
   *
   * All images must have the sizes of the frame that is loaded first: \ref load throws
   * InputFileException for another size, as for a file that is missing or malformed.
   * \param[in] recorded from \ref openRgbdSequence; without poses if has_poses is false
   * \param[in] cameras such as those of the folder, \ref RgbdSequence::cameras
   * \param[in] threads 0 for all
   * \throws BadArgumentException if there is no frame
   * \throws InputFileException if a pose cannot be read */
  ObservationSequence(const RgbdSequence& recorded,
                      const RgbdCameras& cameras,
                      unsigned threads = 0);

  /** \brief Takes the observations of a file that has several, such as the scans of
   * \ref openScans. They are read when they are needed, and are named as files of a
   * sequence are.
   * \param[in] recorded file; its poses may be unknown
   * \throws BadArgumentException if it is missing or has no observation */
  explicit ObservationSequence(
      const std::shared_ptr<const ObservationSource>& recorded);

  /** \brief Selects observations whose poses were estimated elsewhere, and gives them
   * these poses.
   *
   * Files of the result share memory with those of this sequence.
   * \param[in] places indices of the observations, increasing, at least one
   * \param[in] trajectory their poses, metres
   * \throws BadArgumentException if there are none, they differ in number, or a place is
   * none of this sequence */
  ObservationSequence
  withPoses(const std::vector<std::size_t>& places, Trajectory trajectory) const;

  /** \brief The same observations with another \ref shift, for files whose coordinates were
   * shifted elsewhere. */
  ObservationSequence
  withShift(const Eigen::Vector3d& shift) const;

  /** \brief The same observations with their recorded poses read in another way; those of a
   * format that defines them stay (\ref hasRecordedPoses). */
  ObservationSequence
  withPosesRead(const PoseReading& reading) const;

  /** \brief The observations of this sequence, then those of another one, with the shift of this one.
   *
   * Poses are those of their sequences, and so are times, but those of the other one are
   * moved if it would not begin a second after this one.
   * \throws what \ref pose does */
  ObservationSequence
  followedBy(const ObservationSequence& next) const;

  /** \brief A short hash that changes with the observations: the names, sizes and times
   * of files, the bytes of clouds that are not files, and the poses. */
  std::string
  fingerprint() const;

  /** \brief Number of observations. */
  std::size_t
  size() const
  {
    return paths_.size();
  }

  /** \brief Folder, file or first file that was opened, for messages. */
  const std::string&
  source() const
  {
    return source_;
  }

  /** \brief Folder of the first observation. */
  std::string
  folder() const;

  /** \brief Path of the file of an observation; its name if it has no file. */
  const std::string&
  path(std::size_t i) const
  {
    return paths_[i];
  }

  const std::vector<std::string>&
  paths() const
  {
    return paths_;
  }

  /** \brief Name of the file of an observation, without its folder. */
  std::string
  name(std::size_t i) const;

  std::vector<std::string>
  names() const;

  /** \brief Are the poses those of a trajectory? */
  bool
  hasTrajectory() const
  {
    return !trajectory_.poses.empty();
  }

  /** \brief Time of an observation in seconds; its index if the sequence has neither a
   * trajectory nor times. */
  double
  stamp(std::size_t i) const;

  /** \brief Pose of an observation, T_map_camera; it is read unless it is in memory or
   * the poses are those of a trajectory.
   * \throws what \ref load does */
  Eigen::Isometry3d
  pose(std::size_t i) const;

  /** \brief Are there poses of a text file, of VIEWPOINTs, or of a program, whose convention no
   * format defines? */
  bool
  hasRecordedPoses() const
  {
    return has_recorded_poses_;
  }

  /** \brief How the recorded poses are read. */
  const PoseReading&
  poseReading() const
  {
    return reading_;
  }

  /** \brief The pose of an observation as it was recorded, in its own convention and unit. It
   * is read as \ref pose is, or from the header of a PCD. */
  Eigen::Isometry3d
  recordedPose(std::size_t i) const;

  /** \brief Pose of an observation, T_map_camera, as \ref pose; that of a PCD is read from its
   * header, with the digits that it has there. */
  Eigen::Isometry3d
  poseInHeader(std::size_t i) const;

  /** \brief Frame of the observations in that whose poses were recorded: in the axes of acmap's
   * camera, metres. */
  const Eigen::Isometry3d&
  frameInRecorded() const
  {
    return T_recorded_cloud_;
  }

  /** \brief Reads an observation, unless it is in memory.
   * \throws InputFileException as pcl::loadPointCloud, for a frame of an RGB-D folder as
   * \ref loadRgbdObservation */
  PosedObservation
  load(std::size_t i) const;

  /** \brief Reads the points of an observation as they were measured: those of an RGB-D folder
   * without colours and without removing the steps of their depths, which is faster.
   * \throws what \ref load does */
  std::shared_ptr<const PointCloudFile>
  loadMeasured(std::size_t i) const;

  /** \brief What was subtracted from coordinates of the input, CompactMap::shift: that of
   * the \ref ObservationSource, or of the files and their poses. */
  const Eigen::Vector3d&
  shift() const
  {
    return shift_;
  }

  /** \brief Warnings about the sequence, one per line: poses without observations. */
  std::vector<std::string>
  remarks() const;

  /** \brief Checks that poses of several observations differ.
   * \param[in] poses those of the observations that could be read
   * \throws InputFileException if there is no trajectory and all poses are the same */
  void
  requireDifferent(const std::vector<Eigen::Isometry3d>& poses) const;

  /** \brief Sets how many bytes of points are kept in memory (default 64 MiB of
   * files, which the system keeps anyway, 512 MiB of frames of an RGB-D camera, which take
   * longer to read). */
  void
  setCacheSize(std::size_t bytes);

  /** \brief Are the observations files that other processes can read, too? */
  bool
  areFiles() const
  {
    return scale_.has_value();
  }

  /** \brief Puts some of the observations into a message for another process.
   * \param[in] begin first of them
   * \param[in] end the one after the last
   * \throws BadArgumentException unless \ref areFiles */
  void
  put(std::size_t begin, std::size_t end, acmap::ByteParcel& parcel) const;

  /** \brief Takes a sequence, which may be empty, out of a message of \ref put. */
  static ObservationSequence
  taken(acmap::ByteParcel& parcel);

  /** \brief Number of times that a file or a frame was read, by all copies of this
   * sequence. */
  std::size_t
  getNumberOfReads() const;

private:
  /** \brief What the map's frame is. */
  enum class MapFrame {
    Recorded,    ///< that of the recorded poses
    FirstCamera, ///< of the first observation
    Shifted      ///< that of the recorded poses, less the shift
  };

  ObservationSequence() = default;

  void
  readFiles();

  /** \brief Sets the poses to what those of \ref recorded_ mean. */
  void
  placePoses();

  void
  shiftPoses();

  /** \brief Makes the poses those that were recorded. */
  void
  takeAsRecorded();

  /** \brief Are the poses of files, VIEWPOINTs, those that they state? */
  bool
  isReadAsFiles() const;

  Eigen::Isometry3d
  viewpoint(const PointCloudFile& file) const;

  std::string source_; ///< folder, or first file, for messages
  std::vector<std::string> paths_;
  std::vector<std::size_t> rows_; ///< row in the trajectory, one per observation
  Trajectory trajectory_;
  /** \brief Poses as they were recorded, one per row; empty: none, or those of files. */
  std::vector<Eigen::Isometry3d> recorded_;
  bool has_recorded_poses_ = false;
  PoseReading reading_;
  Eigen::Isometry3d T_recorded_cloud_ = Eigen::Isometry3d::Identity();
  MapFrame map_frame_ = MapFrame::Recorded;
  std::optional<Eigen::Vector3d> stated_shift_;
  std::string shift_remark_;    ///< empty: nothing was shifted
  bool is_given_ = false;       ///< Were the poses given by the caller?
  std::optional<double> scale_; ///< metres in a unit of the files, if they are files
  std::string source_state_;    ///< ObservationSource::fingerprint; may be empty
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d file_shift_ = Eigen::Vector3d::Zero(); ///< of the files themselves
  std::vector<std::string> remarks_;                     ///< of the file
  std::shared_ptr<acmap::ObservationCache> cache_;
  std::shared_ptr<acmap::RgbdReader> rgbd_; ///< of an RGB-D folder; else null
};

} // namespace pcl

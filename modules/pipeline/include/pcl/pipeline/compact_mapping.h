#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/stage_controls.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/io/grabber.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_levelling.h>
#include <pcl/pipeline/chain.h>
#include <pcl/pipeline/compact_mapping_types.h>
#include <pcl/pipeline/estimated_poses.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/pipeline/ranks.h>
#include <pcl/pipeline/sequence_adjustment.h>
#include <pcl/pipeline/visual_odometry.h>
#include <pcl/stereo/disparity_back_projection.h>
#include <pcl/stereo/disparity_fusion.h>
#include <pcl/texture/plane_texturing.h>

#include <boost/signals2/connection.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

namespace acmap {
class ObservationStream;
}

/** \brief Computes a compact map from the images or observations of a robot: the whole
 * chain of "Active Stereo Based Compact Mapping" as one object.
 *
 * Frames of a rig are fused and projected to observations (II-A), poses that are
 * unknown are estimated by visual odometry (II-B.1), the map is rectified by minimum
 * entropy (II-B.2), the merged observations are consolidated and triangulated (II-C.1),
 * their planes are found (II-C.2) and textured (II-C). Every step is an object that can
 * be set; its threads and progress are those of this object.
 * \code
 * pcl::CompactMapping mapping;
 * for (std::size_t i = 0; i < clouds.size (); ++i)
 *   mapping.addObservation (clouds[i], poses[i]);  // organized, with colours, camera frame
 * pcl::CompactMap map;
 * mapping.compute (map);
 * pcl::saveCompactMap ("map", map);
 * \endcode
 * The map has the frame of the poses; if these are estimated, that of the first
 * observation. If it is not level, it is turned about its origin (\ref MapLevelling). Metres. The result is the same for every number of threads, and that of
 * `pcl_compact_mapping` for the same observations. Not thread-safe: observations must
 * not be added while \ref compute runs. A robot that calls \ref start first has most
 * of the work done when the last observation arrives.
 * \ingroup pipeline */
class ACMAP_EXPORT CompactMapping : public StageControls<CompactMappingReport> {
public:
  using Rectification = EntropyRectification<PointNormal>;
  using Levelling = MapLevelling<PointNormal>;
  using Texturing = PlaneTexturing<PointXYZRGB>;

  CompactMapping();
  ~CompactMapping();

  /** \name Input
   * Only one kind of input is allowed: frames, observations, or one sequence.
   * Observations must all have poses, or none; otherwise \ref compute throws. */
  ///@{

  /** \brief Sets the geometry of the rectified frames.
   * \throws BadArgumentException for a rig without neighbours */
  void
  setInputRig(const TrinocularRig& rig);

  /** \brief Works while observations arrive: a thread of this object computes the
   * disparities of each as soon as it is complete, its motion, and its consolidated points,
   * so that \ref compute has less to do. The map is the same as without.
   *
   * Of fusion, back-projection, odometry and the mode, the settings at this call count.
   * When too many observations wait, those who add further ones wait, too, and the
   * callback of \ref setStateCallback is told. What the thread throws is thrown by the
   * next calls that add something, and by \ref compute unless \ref keepProcessed was
   * called. \ref clear ends it.
   * \throws InitFailedException after observations were added
   * \throws OutputFileException if the folder of \ref setObservationFolder cannot be
   * made */
  void
  start();

  /** \brief Sets how many complete observations may wait for the thread of \ref start
   * (default 8). Each has its shots in memory, some 30 MB for eleven of a Digiclops.
   * \throws BadArgumentException for 0 */
  void
  setMaximumWaiting(std::size_t observations);

  std::size_t
  getMaximumWaiting() const
  {
    return maximum_waiting_;
  }

  /** \brief Sets a folder in which \ref start keeps observations as files, of which only
   * some are in memory at a time (\ref ObservationSequence::setCacheSize); files of the
   * same names are replaced (default: none, all stay in memory, 6 MB each for 640 x 480
   * pixels). A full disk is told as other faults of the thread are. */
  void
  setObservationFolder(std::string folder)
  {
    observation_folder_ = std::move(folder);
  }

  const std::string&
  getObservationFolder() const
  {
    return observation_folder_;
  }

  /** \brief Sets a folder for the \ref ScratchMemory of \ref compute : arrays with a value
   * for each point are in files, which have no names, so that the points may be more than
   * the memory has room for (default: none).
   * \param[in] folder that exists; empty: none
   * \param[in] resident bytes of the files that may be in memory at the same time */
  void
  setScratchFolder(std::string folder, std::size_t resident = std::size_t{256} << 20)
  {
    scratch_folder_ = std::move(folder);
    scratch_resident_ = resident;
  }

  const std::string&
  getScratchFolder() const
  {
    return scratch_folder_;
  }

  /** \brief Shares reading, sums and painting of \ref compute out over processes, all of which
   * call it (default: none). Rank 0 makes the map, from its observations and with its settings;
   * the others have no other use for their object and get no map. Observations that are not
   * files are read, and painted with, by rank 0, which is reported. The map has the same
   * bytes. */
  void
  setRanks(std::shared_ptr<Ranks> ranks)
  {
    ranks_ = std::move(ranks);
  }

  const std::shared_ptr<Ranks>&
  getRanks() const
  {
    return ranks_;
  }

  /** \brief Sets what is told while observations arrive, after \ref start. It is called
   * by the threads of this object, and by the one that adds observations when it has to
   * wait, possibly at the same time; it must not call this object. */
  void
  setStateCallback(MappingStateCallback callback)
  {
    state_callback_ = std::move(callback);
  }

  /** \brief Sets the shortest time between two provisional maps, which the callback of
   * \ref setStateCallback is told (default 5). They are made of the consolidated points at
   * the poses of the odometry, with voxels of 10 cm, by a thread that takes at most a
   * fifth of one processor.
   * \param[in] seconds 0 for no such maps
   * \throws BadArgumentException unless within [0, 1e6] */
  void
  setProvisionalInterval(double seconds);

  double
  getProvisionalInterval() const
  {
    return provisional_interval_;
  }

  /** \brief Makes a map all the same after a fault of the thread of \ref start : that of the
   * observations that were processed before it, with a remark of \ref compute, which throws
   * the fault if there are none. Has no effect without a fault. */
  void
  keepProcessed();

  /** \brief Adds a rectified frame. The previous observation is computed when the first
   * frame of another one arrives, and the last one by \ref compute.
   * \throws InitFailedException without a rig
   * \throws BadArgumentException as \ref DisparityFusion::addShot */
  void
  addFrame(const TrinocularFrame::ConstPtr& frame);

  /** \brief Completes the observation of the frames so far, as the first frame of another
   * one does: for a robot that knows that it has taken the last shot. No effect without
   * frames.
   * \throws what \ref DisparityFusion::fuse does */
  void
  finishObservation();

  /** \brief Adds an observation whose pose is to be estimated.
   * \param[in] cloud organized, with colours, camera frame; copied
   * \throws BadArgumentException without a cloud */
  template <typename PointT>
  void
  addObservation(const std::shared_ptr<const PointCloud<PointT>>& cloud)
  {
    add(fileOf(cloud), std::nullopt);
  }

  template <typename PointT>
  void
  addObservation(const std::shared_ptr<PointCloud<PointT>>& cloud)
  {
    addObservation(std::shared_ptr<const PointCloud<PointT>>(cloud));
  }

  /** \brief Adds an observation with its pose.
   * \param[in] T_map_camera from the camera to the map
   * \throws BadArgumentException without a cloud, or for a pose that is not rigid */
  template <typename PointT>
  void
  addObservation(const std::shared_ptr<const PointCloud<PointT>>& cloud,
                 const acmap::RigidMotion& T_map_camera)
  {
    add(fileOf(cloud), T_map_camera);
  }

  template <typename PointT>
  void
  addObservation(const std::shared_ptr<PointCloud<PointT>>& cloud,
                 const acmap::RigidMotion& T_map_camera)
  {
    addObservation(std::shared_ptr<const PointCloud<PointT>>(cloud), T_map_camera);
  }

  /** \brief The same for a cloud with any fields, such as one from a file; the cloud is
   * shared. */
  void
  addObservation(std::shared_ptr<const PointCloudFile> cloud,
                 const std::optional<acmap::RigidMotion>& T_map_camera = std::nullopt)
  {
    add(std::move(cloud), T_map_camera);
  }

  /** \brief Takes the output of a grabber: frames of a \ref TrinocularGrabber, or
   * organized clouds of points with colours (PointXYZRGBSigma, PointXYZRGB,
   * PointXYZRGBA).
   * \param[in] grabber not started; it must be stopped before \ref compute
   * \return the connection, which ends with this object or by its disconnect ()
   * \throws BadArgumentException if it delivers neither */
  boost::signals2::connection
  setInputGrabber(Grabber& grabber);

  /** \brief Sets a sequence, which is read when it is needed.
   * \param[in] has_poses Are its poses known? Otherwise they are estimated. */
  void
  setInputSequence(const ObservationSequence& sequence, bool has_poses);

  /** \brief Sets the observations of an earlier map, which is extended: the map is made
   * of these and of the new ones. Both are joined at places that both have seen
   * (\ref SequenceAlignment), before the rectification; the frame of the earlier map
   * stays.
   * \param[in] sequence with the poses of that map; organized, with colours */
  void
  setEarlierObservations(const ObservationSequence& sequence)
  {
    earlier_ = sequence;
  }

  /** \brief Removes all frames and observations. */
  void
  clear();

  /** \brief Number of complete observations. */
  std::size_t
  getNumberOfObservations() const;
  ///@}

  /** \name Steps */
  ///@{

  /** \brief Sets all steps to the paper's way, or back to the default one (Accurate).
   *
   * Paper, II-A to II-C with nothing added: the median of the shots' disparities
   * (\ref DisparityFusion::Method), the paper's egomotion
   * (\ref VisualEgomotion::setPaperMode), the voting of \ref RectificationMode::Paper
   * on raw points, no refinement of quantised depth, \ref PlaneMapping::setMode without
   * cylinders and boxes, and the colours of points (\ref PlaneTexturing::setPaperMode). Other settings of the
   * steps stay. A step that is set later replaces what this call set: each departure
   * from the paper can be taken back alone. Discards the frames of the current
   * observation: to be called before they are added. */
  void
  setMode(MappingMode mode);

  /** \brief Sets all steps at once, and the mode with its fusion; as \ref setMode, to be
   * called before frames are added. */
  void
  setSettings(const acmap::ChainSettings& settings)
  {
    setMode(settings.mode);
    settings_ = settings;
  }

  const acmap::ChainSettings&
  getSettings() const
  {
    return settings_;
  }

  MappingMode
  getMode() const
  {
    return settings_.mode;
  }

  /** \brief Settings of the fusion of frames and of their projection. */
  DisparityFusion&
  fusion()
  {
    return fusion_;
  }

  DisparityBackProjection&
  backProjection()
  {
    return projection_;
  }

  /** \brief Sets how recorded poses are read (default: camera to world, metres); \ref compute
   * throws InputFileException if the views contradict it. */
  void
  setPoseConventionCheck(const PoseConventionCheck& check)
  {
    settings_.poses = check;
  }

  const PoseConventionCheck&
  getPoseConventionCheck() const
  {
    return settings_.poses;
  }

  void
  setVisualOdometry(const VisualOdometry& odometry)
  {
    settings_.odometry = odometry;
  }

  const VisualOdometry&
  getVisualOdometry() const
  {
    return settings_.odometry;
  }

  /** \brief Sets how the vertical is found before the map is rectified. The frame of the
   * map is then level; in mode Paper, and without rectification, it stays as it is. */
  void
  setLevelling(const Levelling& levelling)
  {
    settings_.levelling = levelling;
  }

  const Levelling&
  getLevelling() const
  {
    return settings_.levelling;
  }

  /** \brief Sets how the map is rectified. If its odometry noise was not set, that of
   * estimated poses is used. Its input are the consolidated points of each
   * observation, in \ref RectificationMode::Paper the raw ones. */
  void
  setRectification(const Rectification& rectification)
  {
    settings_.rectification = rectification;
  }

  const Rectification&
  getRectification() const
  {
    return settings_.rectification;
  }

  /** \brief Rectifies the map (default true). */
  void
  setRectify(bool rectify)
  {
    settings_.rectify = rectify;
  }

  bool
  getRectify() const
  {
    return settings_.rectify;
  }

  /** \brief Adjusts the poses by planes, in six degrees of freedom, after the
   * rectification (\ref SequenceAdjustment, default false), with the same odometry noise.
   * It reads all observations: none may be broken. */
  void
  setAdjust(bool adjust)
  {
    settings_.adjust = adjust;
  }

  bool
  getAdjust() const
  {
    return settings_.adjust;
  }

  /** \brief Finds out what the path of the camera is (default false): one in space, as of a hand, is
   * estimated with six degrees of freedom (\ref VisualOdometry::setMeasureMotion) where its poses
   * are not known, and adjusted. */
  void
  setMeasurePath(bool measure)
  {
    settings_.measure_path = measure;
  }

  bool
  getMeasurePath() const
  {
    return settings_.measure_path;
  }

  /** \brief Leaves out observations that cannot be read, with a remark, in the steps after
   * the odometry (default false). */
  void
  setSkipBroken(bool skip)
  {
    settings_.skip_broken = skip;
  }

  bool
  getSkipBroken() const
  {
    return settings_.skip_broken;
  }

  /** \brief Sets how many bytes the details of the map may take (\ref makeDetails, default
   * 1 MB; 0 in paper mode).
   * \param[in] bytes 0: no details */
  void
  setMaximumDetailBytes(std::size_t bytes)
  {
    settings_.max_detail_bytes = bytes;
  }

  std::size_t
  getMaximumDetailBytes() const
  {
    return settings_.max_detail_bytes;
  }

  /** \brief Keeps the poses that were estimated, rectified or adjusted in a folder, so that
   * a later run goes on from them; it then has no report of these stages (default: none).
   * \param[in] folder is created; each stage has a folder in it (\ref acmap::StageStore).
   * Poses are taken over if the observations and the settings of the stage are the same */
  void
  setFolder(const std::string& folder)
  {
    folder_ = folder;
  }

  /** \brief Sets how observations are merged; whether broken ones are skipped is decided
   * by this object, and quantised depth stays as it is where planes are found in space
   * (\ref PlaneMapping::getUsedDepthSensor). */
  void
  setMerging(const ObservationMerging& merging)
  {
    settings_.merging = merging;
  }

  const ObservationMerging&
  getMerging() const
  {
    return settings_.merging;
  }

  void
  setPlaneMapping(const PlaneMapping& planes)
  {
    settings_.planes = planes;
  }

  const PlaneMapping&
  getPlaneMapping() const
  {
    return settings_.planes;
  }

  /** \brief Sets what is called before planes are found and painted, with the memory and
   * time that this may take; what it throws, \ref compute throws. */
  void
  setCostCallback(CostCallback callback)
  {
    cost_callback_ = std::move(callback);
  }

  void
  setTexturing(const Texturing& texturing)
  {
    settings_.texturing = texturing;
  }

  const Texturing&
  getTexturing() const
  {
    return settings_.texturing;
  }
  ///@}

  /** \brief Computes the map.
   * \param[out] map no planes, with the reason in the report, if there are none
   * \throws InitFailedException without an observation, or if observations have poses only
   * in part
   * \throws EmptyInputException if no observation could be joined to another one, or no
   * place of an earlier map was seen again
   * \throws what the steps throw; OutputFileException if the folder cannot be written
   * \throws CancelledException if the progress callback stopped it */
  void
  compute(CompactMap& map);

  /** \brief Mesh, normals and planes of the last run. */
  const MappedPlanes&
  getMappedPlanes() const
  {
    return mapped_;
  }

  /** \brief Observations of the last run with the poses of the map.
   * \throws InitFailedException before the first run */
  const ObservationSequence&
  getMappedSequence() const;

  /** \brief Poses of the last run before the rectification, in the level frame, metres; empty if the map was not
   * rectified. */
  const Trajectory&
  getOdometryTrajectory() const
  {
    return before_;
  }

private:
  template <typename PointT>
  static std::shared_ptr<const PointCloudFile>
  fileOf(const std::shared_ptr<const PointCloud<PointT>>& cloud);

  void
  add(std::shared_ptr<const PointCloudFile> cloud,
      const std::optional<acmap::RigidMotion>& T_map_camera);

  ObservationSequence
  collected();

  void
  makeMap(CompactMap& map);

  std::optional<std::int32_t> current_;              ///< observation of the last frame
  std::shared_ptr<acmap::ObservationStream> stream_; ///< since \ref start
  std::size_t maximum_waiting_ = 8;
  std::shared_ptr<Ranks> ranks_;
  std::string scratch_folder_;       ///< empty: memory
  std::size_t scratch_resident_ = 0; ///< bytes
  std::string observation_folder_;   ///< of stream_; empty: memory
  double provisional_interval_ = 5;  ///< seconds
  MappingStateCallback state_callback_;
  std::vector<std::shared_ptr<const PointCloudFile>> clouds_;
  std::vector<std::optional<Eigen::Isometry3d>> poses_;
  std::optional<ObservationSequence> sequence_;
  std::optional<ObservationSequence> earlier_; ///< of a map that is extended
  bool has_poses_ = false;                     ///< of the sequence
  DisparityFusion fusion_;
  DisparityBackProjection projection_;
  std::vector<boost::signals2::scoped_connection> connections_;
  acmap::ChainSettings settings_;
  std::string folder_; ///< of poses for later runs; empty: none
  CostCallback cost_callback_;
  MappedPlanes mapped_;
  std::optional<ObservationSequence> mapped_sequence_;
  Trajectory before_;
};

template <typename PointT>
std::shared_ptr<const PointCloudFile>
CompactMapping::fileOf(const std::shared_ptr<const PointCloud<PointT>>& cloud)
{
  return cloud ? acmap::fileOf(cloud) : nullptr;
}

} // namespace pcl

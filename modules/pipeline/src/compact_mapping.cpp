#include "observation_stream.h"
#include "part_of_progress.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/trinocular_grabber.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/fingerprint.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/pipeline/sequence_alignment.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/texture/floor_plan.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace pcl {

namespace {

namespace fs = std::filesystem;

using acmap::partOf;
using acmap::StepTimer;

void
addRemarks(const Report& step, Report& report)
{
  // a broken observation is told once, by the step that reads it first
  for (const std::string& remark : step.remarks)
    if (std::find(report.remarks.begin(), report.remarks.end(), remark) ==
        report.remarks.end())
      report.remarks.push_back(remark);
}

/** A pose as it is read from a trajectory file, bit by bit, so that the map has the same
 * bytes whether steps pass poses in memory or in files. */
Eigen::Isometry3d
asInFiles(Eigen::Isometry3d pose)
{
  Eigen::Quaterniond written(pose.linear());
  written.normalize();
  if (written.w() < 0)
    written.coeffs() = -written.coeffs();
  pose.linear() = written.normalized().toRotationMatrix();
  return pose;
}

void
roundAsInFiles(Trajectory& trajectory)
{
  for (Eigen::Isometry3d& pose : trajectory.poses)
    pose = asInFiles(pose);
}

/** \throws OutputFileException if the folder cannot be made */
void
makeFolder(const std::string& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw OutputFileException(folder + ": " + error.message());
}

/** Connects a callback that adds clouds of a point type.
 * \return nothing if the grabber does not deliver them */
template <typename PointT>
std::optional<boost::signals2::connection>
connectClouds(Grabber& grabber, CompactMapping& mapping)
{
  using Cloud = PointCloud<PointT>;
  using Callback = void(const typename Cloud::ConstPtr&);
  if (!grabber.providesCallback<Callback>())
    return std::nullopt;
  return grabber.registerCallback(
      std::function<Callback>([&mapping](const typename Cloud::ConstPtr& cloud) {
        mapping.addObservation(cloud);
      }));
}

} // namespace

CompactMapping::CompactMapping()
{
  // cameras see walls from a shorter distance than laser scanners
  rectification_.setBinSize(0.05);
  planes_.setComputeCylinders(true);
  planes_.setComputeBoxes(true);
}

CompactMapping::~CompactMapping() = default;

void
CompactMapping::setInputRig(const TrinocularRig& rig)
{
  fusion_.setInputRig(rig);
  projection_.setInputRig(rig);
}

void
CompactMapping::setMode(MappingMode mode)
{
  const bool is_paper = mode == MappingMode::Paper;
  mode_ = mode;
  fusion_.setMethod(is_paper ? DisparityFusion::Method::Median
                             : DisparityFusion::Method::SpaceTime);
  fusion_.clear();
  current_.reset();
  VisualOdometry::Egomotion egomotion = odometry_.getEgomotion();
  egomotion.setPaperMode(is_paper);
  odometry_.setEgomotion(egomotion);
  rectification_.setMode(is_paper ? RectificationMode::Paper
                                  : RectificationMode::Guarded);
  merging_.setDepthSensor(is_paper ? DepthSensor::Laser : DepthSensor::Automatic);
  planes_.setMode(mode);
  planes_.setComputeCylinders(!is_paper);
  planes_.setComputeBoxes(!is_paper);
  texturing_.setPaperMode(is_paper);
}

void
CompactMapping::setMaximumWaiting(std::size_t observations)
{
  if (observations == 0)
    throw BadArgumentException("at least one observation has to be allowed to wait");
  maximum_waiting_ = observations;
}

void
CompactMapping::setProvisionalInterval(double seconds)
{
  acmap::requireInRange("interval of provisional maps", seconds, 0, 1e6, "s");
  provisional_interval_ = seconds;
}

void
CompactMapping::keepProcessed()
{
  if (stream_)
    stream_->keepProcessed();
}

void
CompactMapping::addFrame(const TrinocularFrame::ConstPtr& frame)
{
  if (frame && current_ != frame->observation)
    finishObservation();
  fusion_.addShot(frame);
  current_ = frame->observation;
}

void
CompactMapping::start()
{
  if (sequence_ || current_ || getNumberOfObservations() > 0)
    PCL_THROW_EXCEPTION(InitFailedException,
                        "observations were added before start (): clear () first");
  acmap::ObservationStream::Steps steps;
  steps.projection = projection_;
  steps.odometry = odometry_;
  steps.consolidation.setRawPoints(rectification_.getMode() ==
                                   RectificationMode::Paper);
  steps.maximum_waiting = maximum_waiting_;
  steps.folder = observation_folder_;
  if (!steps.folder.empty())
    makeFolder(steps.folder);
  steps.callback = state_callback_;
  steps.provisional_interval = provisional_interval_;
  fusion_.setNumberOfThreads(threads_);
  steps.projection.setNumberOfThreads(threads_);
  steps.odometry.setNumberOfThreads(threads_);
  steps.consolidation.setNumberOfThreads(threads_);
  stream_ = std::make_unique<acmap::ObservationStream>(std::move(steps));
}

void
CompactMapping::finishObservation()
{
  if (!current_)
    return;
  current_.reset();
  if (stream_) {
    stream_->add(fusion_.release());
    return;
  }
  fusion_.setNumberOfThreads(threads_);
  projection_.setNumberOfThreads(threads_);
  add(acmap::projectFused(fusion_, projection_), std::nullopt);
  fusion_.clear();
}

void
CompactMapping::add(std::shared_ptr<const PointCloudFile> cloud,
                    const std::optional<Eigen::Isometry3d>& T_map_camera)
{
  if (!cloud)
    throw BadArgumentException("an observation needs a cloud");
  if (T_map_camera && !acmap::isRigid(*T_map_camera, acmap::float_pose_tolerance))
    throw BadArgumentException("the pose of an observation is no rigid motion");
  poses_.push_back(T_map_camera);
  if (T_map_camera && !acmap::isRigid(*T_map_camera)) // rounded to floats
    poses_.back() = asInFiles(*T_map_camera);
  if (stream_)
    stream_->add(std::move(cloud), poses_.back());
  else
    clouds_.push_back(std::move(cloud));
}

boost::signals2::connection
CompactMapping::setInputGrabber(Grabber& grabber)
{
  std::optional<boost::signals2::connection> connection;
  if (auto* const frames = dynamic_cast<TrinocularGrabber*>(&grabber)) {
    setInputRig(frames->getRig());
    connection =
        grabber.registerCallback(std::function<TrinocularGrabber::FrameCallback>(
            [this](const TrinocularFrame::ConstPtr& frame) { addFrame(frame); }));
  }
  if (!connection)
    connection = connectClouds<PointXYZRGBSigma>(grabber, *this);
  if (!connection)
    connection = connectClouds<PointXYZRGB>(grabber, *this);
  if (!connection)
    connection = connectClouds<PointXYZRGBA>(grabber, *this);
  if (!connection)
    throw BadArgumentException(grabber.getName() +
                               " delivers neither frames of a rig nor clouds of points "
                               "with colours");
  connections_.emplace_back(*connection);
  return *connection;
}

void
CompactMapping::setInputSequence(const ObservationSequence& sequence, bool has_poses)
{
  sequence_ = sequence;
  has_poses_ = has_poses;
}

void
CompactMapping::clear()
{
  fusion_.clear();
  current_.reset();
  stream_.reset();
  clouds_.clear();
  poses_.clear();
  sequence_.reset();
  earlier_.reset();
}

std::size_t
CompactMapping::getNumberOfObservations() const
{
  if (stream_)
    return stream_->size();
  return sequence_ ? sequence_->size() : clouds_.size();
}

ObservationSequence
CompactMapping::collected()
{
  if (stream_) {
    stream_->finish();
    poses_.resize(stream_->consolidated().size());
  }
  const auto posed = static_cast<std::size_t>(std::count_if(
      poses_.begin(), poses_.end(), [](const auto& pose) { return pose.has_value(); }));
  if (poses_.empty())
    PCL_THROW_EXCEPTION(InitFailedException, "there is no observation");
  if (posed != 0 && posed != poses_.size())
    PCL_THROW_EXCEPTION(InitFailedException,
                        posed << " of " << poses_.size()
                              << " observations have poses: give all of them, or none");
  const ObservationSequence all =
      stream_ ? stream_->observations() : ObservationSequence(clouds_);
  Trajectory trajectory;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < posed; ++i) {
    trajectory.stamps.push_back(static_cast<double>(i));
    trajectory.poses.push_back(*poses_[i]);
    places.push_back(i);
  }
  return posed == 0 ? all : all.withPoses(places, std::move(trajectory));
}

void
CompactMapping::estimatePoses(const ObservationSequence& sequence,
                              CompactMappingReport& report)
{
  VisualOdometry odometry = odometry_;
  odometry.setNumberOfThreads(threads_);
  odometry.setProgressCallback(partOf(progress_, 0, 0.2));
  report.odometry = stream_ ? stream_->odometry().finish(sequence.size())
                            : odometry.compute(sequence);
  const VisualOdometryResult& found = *report.odometry;
  if (found.posed() == 0)
    PCL_THROW_EXCEPTION(EmptyInputException,
                        "no observation could be joined to another one; the first one "
                            << found.reasonOf(0, sequence.names()));
  std::vector<double> stamps;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    stamps.push_back(sequence.stamp(i));
    if (!found.poses[i])
      report.remarks.push_back("lost: " + sequence.name(i) + ": " +
                               found.reasonOf(i, sequence.names()));
  }
  estimated_ = found.estimated(stamps);
  roundAsInFiles(estimated_.trajectory);
}

/** \param[in] sequence the earlier observations, then the new ones in their own map */
void
CompactMapping::extend(const ObservationSequence& sequence,
                       CompactMappingReport& report)
{
  SequenceAlignment alignment;
  alignment.setInputTarget(*earlier_);
  alignment.setMotionModel(odometry_.getEgomotion().getMotionModel());
  alignment.setNumberOfThreads(threads_);
  alignment.setProgressCallback(partOf(progress_, 0.15, 0.2));
  estimated_ = extendedPoses(sequence, earlier_->size(), alignment, estimated_.noise);
  report.extension = alignment.getReport();
}

void
CompactMapping::rectify(const ObservationSequence& sequence,
                        CompactMappingReport& report)
{
  SequenceConsolidation consolidation;
  consolidation.setSkipBroken(skip_broken_);
  consolidation.setRawPoints(rectification_.getMode() == RectificationMode::Paper);
  consolidation.setNumberOfThreads(threads_);
  consolidation.setProgressCallback(partOf(progress_, 0.2, 0.3));
  if (stream_) {
    std::vector<ConsolidatedObservation> done;
    const std::size_t earlier = earlier_ ? earlier_->size() : 0;
    for (std::size_t i = 0; i < earlier; ++i)
      done.push_back(
          consolidation.consolidate(*sequence.load(i).file, sequence.path(i)));
    for (const std::size_t place : processed_places_)
      done.push_back(stream_->consolidated()[place]);
    consolidation.setConsolidated(std::move(done));
  }
  ConsolidatedObservations observations;
  consolidation.compute(sequence, observations);
  report.consolidation = consolidation.getReport();
  addRemarks(*report.consolidation, report);

  Levelling levelling = levelling_;
  if (!sequence.shift().isZero(0) && !levelling.getUpDirection())
    levelling.setUpDirection(Eigen::Vector3d::UnitZ()); // of a surveyed grid
  else if (rectification_.getMode() == RectificationMode::Paper &&
           !levelling.getUpDirection())
    levelling.setUpDirection(-Eigen::Vector3d::UnitY()); // as the paper assumes
  report.levelling = levelObservations(levelling, observations, threads_);
  addRemarks(*report.levelling, report);
  Rectification rectification = rectification_;
  rectification.setUpDirection(report.levelling->axis);
  rectification.setOdometryNoise(odometry_noise_);
  rectification.setNumberOfThreads(threads_);
  rectification.setProgressCallback(partOf(progress_, 0.3, 0.45));
  rectification.clear();
  for (std::size_t i = 0; i < observations.clouds.size(); ++i)
    rectification.addPointCloud(observations.clouds[i],
                                observations.trajectory.poses[i],
                                observations.weights[i]);
  rectification.compute();
  report.rectification = rectification.getReport();
  addRemarks(*report.rectification, report);
  estimated_ = {observations.places, observations.trajectory, std::nullopt, {}};
  if (report.levelling->found)
    estimated_.up = report.levelling->axis;
  for (std::size_t i = 0; i < estimated_.places.size(); ++i)
    estimated_.trajectory.poses[i] = rectification.getPose(i);
  roundAsInFiles(estimated_.trajectory);
  before_ = std::move(observations.trajectory);
  roundAsInFiles(before_);
}

void
CompactMapping::adjust(const ObservationSequence& sequence,
                       CompactMappingReport& report)
{
  SequenceAdjustment adjustment;
  adjustment.setOdometryNoise(odometry_noise_);
  adjustment.setNumberOfThreads(threads_);
  adjustment.setProgressCallback(partOf(progress_, 0.45, 0.5));
  adjustment.setPosesBefore(before_.poses);
  Trajectory adjusted;
  adjustment.compute(sequence, adjusted);
  report.adjustment = adjustment.getReport();
  report.revisits = adjustment.getRevisitReport();
  addRemarks(*report.adjustment, report);
  EstimatedPoses poses;
  for (std::size_t i = 0; i < sequence.size(); ++i)
    poses.places.push_back(i);
  roundAsInFiles(adjusted);
  poses.trajectory = std::move(adjusted);
  poses.up = estimated_.up;
  estimated_ = std::move(poses);
}

/** Takes the poses of a step from the folder if they are there; otherwise runs it. */
ObservationSequence
CompactMapping::goOnFrom(const std::string& step,
                         const ObservationSequence& sequence,
                         PoseStep run,
                         CompactMappingReport& report)
{
  const auto posed = [&] {
    return sequence.withPoses(estimated_.places, estimated_.trajectory);
  };
  if (folder_.empty()) {
    (this->*run)(sequence, report);
    return posed();
  }
  const std::string folder = (fs::path(folder_) / step).string();
  const std::string before = (fs::path(folder) / "trajectory_before.txt").string();
  acmap::Fingerprint hash;
  hash.add(sequence.fingerprint());
  hash.add(settings_);
  hash.add(ACMAP_VERSION);
  hash.add(odometry_.getEgomotion().getMotionModel() == MotionModel::Rigid ? "rigid"
                                                                           : "planar");
  hash.add(skip_broken_ ? "skips broken" : "");
  if (mode_ == MappingMode::Paper)
    hash.add("paper");
  const std::string made_of = hash.text();
  if (auto kept = loadEstimatedPoses(folder, made_of)) {
    estimated_ = std::move(*kept);
    std::error_code error;
    if (fs::exists(before, error))
      before_ = loadTrajectory(before);
    report.remarks.push_back(step + ": poses of an earlier run, from " + folder);
    return posed();
  }
  (this->*run)(sequence, report);
  makeFolder(folder);
  if (!before_.poses.empty())
    saveTrajectory(before, before_);
  saveEstimatedPoses(folder, estimated_, made_of);
  // The last bits of a rotation may differ in the file: later runs begin with those.
  if (auto saved = loadEstimatedPoses(folder, made_of))
    estimated_ = std::move(*saved);
  return posed();
}

CompactMap
CompactMapping::paint(const ObservationSequence& sequence,
                      RankedWork* work,
                      CompactMappingReport& report)
{
  Texturing texturing = texturing_;
  texturing.setPlanes(mapped_.planes);
  texturing.setCylinders(mapped_.cylinders);
  texturing.clearObservations();
  acmap::addObservations(
      work,
      sequence.size(),
      [&](std::size_t i) { return acmap::loadTextured(sequence, i, skip_broken_); },
      texturing);
  texturing.setNumberOfThreads(threads_);
  texturing.setProgressCallback(partOf(progress_, 0.8, 1));
  if (cost_callback_)
    cost_callback_(
        "painting the planes", acmap::wholeBytes(texturing.estimateMemory()), 0);
  CompactMap map;
  texturing.texture(map);
  report.texture = texturing.getReport();
  addRemarks(report.texture, report);
  return map;
}

void
CompactMapping::compute(CompactMap& map)
{
  if (!ranks_)
    return makeMap(map);
  if (ranks_->rank() > 0) {
    map = CompactMap();
    return serveRanks(*ranks_);
  }
  try {
    makeMap(map);
  }
  catch (...) {
    endRanks(*ranks_);
    throw;
  }
  endRanks(*ranks_);
}

void
CompactMapping::makeMap(CompactMap& map)
{
  finishObservation();
  if (sequence_ && (stream_ || !clouds_.empty()))
    PCL_THROW_EXCEPTION(InitFailedException,
                        "there are a sequence and observations: give one of both");
  std::optional<ScratchMemory> scratch;
  if (!scratch_folder_.empty())
    scratch.emplace(scratch_folder_, scratch_resident_);
  CompactMappingReport report;
  report.mode = mode_;
  StepTimer timer(report);
  before_ = Trajectory();
  estimated_ = EstimatedPoses();
  ObservationSequence sequence = sequence_ ? *sequence_ : collected();
  if (stream_ && stream_->missing() > 0)
    report.remarks.push_back("the last " + std::to_string(stream_->missing()) + " of " +
                             std::to_string(stream_->size()) +
                             " observations are missing, a fault has ended the work");
  const bool has_poses = sequence_ ? has_poses_ : poses_.front().has_value();
  if (!has_poses && sequence.size() > 1) {
    sequence = goOnFrom("odometry", sequence, &CompactMapping::estimatePoses, report);
    timer.finish("odometry");
  }
  processed_places_ = estimated_.places;
  if (processed_places_.empty())
    for (std::size_t i = 0; i < sequence.size(); ++i)
      processed_places_.push_back(i);
  if (earlier_) {
    sequence = goOnFrom(
        "extension", earlier_->followedBy(sequence), &CompactMapping::extend, report);
    timer.finish("extension");
  }
  odometry_noise_ = rectification_.getOdometryNoise();
  if (estimated_.noise && !rectification_.hasOdometryNoise())
    odometry_noise_ = *estimated_.noise;
  if (rectify_ && sequence.size() > 1) {
    sequence = goOnFrom("rectification", sequence, &CompactMapping::rectify, report);
    timer.finish("rectification");
  }
  if (adjust_ && sequence.size() > 1) {
    sequence = goOnFrom("adjustment", sequence, &CompactMapping::adjust, report);
    timer.finish("adjustment");
  }

  ObservationMerging merging = merging_;
  merging.setSkipBroken(skip_broken_);
  if (mode_ != MappingMode::Paper && planes_.getUsedDepthSensor() == DepthSensor::Laser)
    merging.setDepthSensor(DepthSensor::Laser);
  merging.setNumberOfThreads(threads_);
  merging.setProgressCallback(partOf(progress_, 0.5, 0.6));
  const std::shared_ptr<RankedWork> work = acmap::shareOut(
      ranks_, sequence, threads_, scratch_folder_, scratch_resident_, report.remarks);
  merging.setRankedWork(work);
  MergedCloud merged;
  merging.compute(sequence, merged);
  report.merging = merging.getReport();
  addRemarks(report.merging, report);
  timer.finish("merging");

  PlaneMapping planes = planes_;
  planes.setInputCloud(merged.cloud);
  planes.setViewpoints(merged.viewpoints);
  planes.setDepthSensor(
      acmap::sensorOfMerged(planes.getDepthSensor(), merged.viewpoints.size()));
  planes.setNumberOfThreads(threads_);
  if (cost_callback_)
    planes.setCostCallback(cost_callback_);
  planes.setProgressCallback(partOf(progress_, 0.6, 0.8));
  planes.compute(mapped_);
  report.planes = planes.getReport();
  addRemarks(report.planes, report);
  timer.finish("planes");

  CompactMap result;
  if (!mapped_.planes.empty() || !mapped_.cylinders.empty()) {
    result = paint(sequence, work.get(), report);
    result.boxes = mapped_.boxes;
    result.recesses = mapped_.recesses;
    result.up = estimated_.up.value_or(Eigen::Vector3d::Zero());
    result.shift = sequence.shift();
    setRooms(makeFloorPlan(result), result);
  }
  timer.finish("texture");
  if (work) {
    report.ranks = ranks_->size();
    report.rank_messages = ranks_->getNumberOfMessages();
    report.rank_bytes = ranks_->getNumberOfBytes();
  }
  if (scratch && scratch->getRefused() > 0)
    report.remarks.push_back(scratch_folder_ + ": the disk is full, " +
                             std::to_string(scratch->getRefused()) +
                             " bytes stayed in memory");
  map = std::move(result);
  mapped_sequence_ = sequence;
  report_ = std::move(report);
}

const ObservationSequence&
CompactMapping::getMappedSequence() const
{
  if (!mapped_sequence_)
    PCL_THROW_EXCEPTION(InitFailedException, "no map was computed");
  return *mapped_sequence_;
}

} // namespace pcl

#include "chain/chain_stages.h"
#include "live/observation_stream.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/trinocular_grabber.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/ranked_work.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace pcl {

namespace {

namespace fs = std::filesystem;

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
  settings_.rectification.setBinSize(0.05);
  settings_.planes.setComputeCylinders(true);
  settings_.planes.setComputeBoxes(true);
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
  settings_.mode = mode;
  fusion_.setMethod(is_paper ? DisparityFusion::Method::Median
                             : DisparityFusion::Method::SpaceTime);
  fusion_.clear();
  current_.reset();
  VisualOdometry::Egomotion egomotion = settings_.odometry.getEgomotion();
  egomotion.setPaperMode(is_paper);
  settings_.odometry.setEgomotion(egomotion);
  settings_.rectification.setMode(is_paper ? RectificationMode::Paper
                                           : RectificationMode::Guarded);
  settings_.merging.setDepthSensor(is_paper ? DepthSensor::Laser
                                            : DepthSensor::Automatic);
  settings_.planes.setMode(mode);
  settings_.planes.setComputeCylinders(!is_paper);
  settings_.planes.setComputeBoxes(!is_paper);
  settings_.texturing.setPaperMode(is_paper);
  settings_.max_detail_bytes = is_paper ? 0 : default_detail_bytes;
}

void
CompactMapping::setMaximumWaiting(std::size_t observations)
{
  if (observations == 0)
    throw acmap::BadArgument("at least one observation has to be allowed to wait");
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
    throw acmap::InitFailed("observations were added before start (): clear () first");
  acmap::ObservationStream::Steps steps = acmap::streamSteps(settings_, threads_);
  steps.projection = projection_;
  steps.maximum_waiting = maximum_waiting_;
  steps.folder = observation_folder_;
  if (!steps.folder.empty())
    makeFolder(steps.folder);
  steps.callback = state_callback_;
  steps.provisional_interval = provisional_interval_;
  fusion_.setNumberOfThreads(threads_);
  steps.projection.setNumberOfThreads(threads_);
  stream_ = std::make_shared<acmap::ObservationStream>(std::move(steps));
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
                    const std::optional<acmap::RigidMotion>& T_map_camera)
{
  acmap::requireGiven<acmap::BadArgument>(cloud);
  acmap::requirePoints(CloudRows::of(cloud->cloud)); // else a thread would find out
  poses_.emplace_back();
  if (T_map_camera)
    poses_.back() = acmap::requirePlace(*T_map_camera).get();
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
    throw acmap::BadArgument(grabber.getName() +
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
    throw acmap::InitFailed("no observation was added");
  if (posed != 0 && posed != poses_.size())
    throw acmap::InitFailed(posed,
                            " of ",
                            poses_.size(),
                            " observations have poses: give all of them, or none");
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
    throw acmap::InitFailed("there are a sequence and observations: give one of both");
  const ObservationSequence sequence = sequence_ ? *sequence_ : collected();
  acmap::Chain chain(settings_);
  chain.setInput(
      stream_, sequence, sequence_ ? has_poses_ : poses_.front().has_value());
  if (earlier_)
    chain.setEarlierObservations(*earlier_);
  if (!folder_.empty())
    chain.setStore(acmap::StageStore(folder_));
  chain.setScratchFolder(scratch_folder_, scratch_resident_);
  chain.setRanks(ranks_);
  chain.setCostCallback(cost_callback_);
  chain.setNumberOfThreads(threads_);
  chain.setProgressCallback(progress_);
  chain.run();
  acmap::ChainState& made = chain.state();
  report_ = std::move(made.report);
  for (const acmap::DoneStage& stage : chain.done())
    if (stage.is_taken)
      report_.remarks.push_back(stage.name + ": poses of an earlier run, from " +
                                chain.getStore().path(stage.name));
  if (stream_ && stream_->missing() > 0)
    report_.remarks.push_back("the last " + std::to_string(stream_->missing()) +
                              " of " + std::to_string(stream_->size()) +
                              " observations are missing, a fault has ended the work");
  map = std::move(made.map);
  mapped_ = std::move(made.planes);
  mapped_sequence_ = std::move(made.observations);
  before_ = std::move(made.before);
}

const ObservationSequence&
CompactMapping::getMappedSequence() const
{
  if (!mapped_sequence_)
    throw acmap::InitFailed("no map was computed");
  return *mapped_sequence_;
}

} // namespace pcl

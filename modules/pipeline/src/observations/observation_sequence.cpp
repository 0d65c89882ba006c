#include "observations/cloud_folder.h"
#include "observations/observation_cache.h"
#include "rgbd/rgbd_reader.h"
#include <pcl/core/impl/file_ending.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/byte_parcel.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/map_shift.h>
#include <pcl/core/impl/pcd_viewpoint.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/rigid_motion.h>
#include <pcl/pipeline/fingerprint.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/pipeline/stage_store.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <utility>

namespace pcl {

namespace {

namespace fs = std::filesystem;

Eigen::Isometry3d
viewpointOf(const PointCloudFile& file)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      file.sensor_orientation.cast<double>().normalized().toRotationMatrix();
  pose.translation() = file.sensor_origin.cast<double>();
  return pose;
}

bool
isKnown(const Eigen::Isometry3d& viewpoint)
{
  return !viewpoint.matrix().isIdentity(0);
}

std::shared_ptr<acmap::ObservationCache>
cacheOfFiles(const acmap::CloudStatement& stated)
{
  const auto cache =
      std::make_shared<acmap::ObservationCache>([stated](const std::string& path) {
        return std::make_shared<const PointCloudFile>(
            acmap::loadObservationFile(path, stated));
      });
  cache->setLimit(std::size_t{64} << 20); // the system keeps files in memory anyway
  return cache;
}

/** A reader checks its files, but nobody what a program gives. */
void
requireObservation(const std::string& name,
                   const std::shared_ptr<const PointCloudFile>& file)
{
  try {
    acmap::requireGiven(file);
    acmap::requirePoints(CloudRows::of(file->cloud));
  }
  catch (const InitFailedException& fault) {
    throw acmap::BadArgument(name, ": ", fault.what());
  }
}

/** Moves the map to the frame of the first camera. */
void
startAtFirst(std::vector<Eigen::Isometry3d>& poses)
{
  if (poses.empty())
    return;
  const Eigen::Isometry3d T_first_world = poses.front().inverse();
  poses.front().setIdentity();
  for (std::size_t i = 1; i < poses.size(); ++i)
    poses[i] = T_first_world * poses[i];
}

void
requirePoses(const Trajectory& trajectory)
{
  for (const Eigen::Isometry3d& pose : trajectory.poses)
    acmap::requirePlace(pose.matrix()); // an Isometry3d leaves its last row unchecked
}

} // namespace

ObservationSequence::ObservationSequence(const std::string& folder,
                                         double scale,
                                         const std::optional<Eigen::Vector3d>& shift)
: source_(folder)
, scale_(scale)
{
  acmap::CloudFolder clouds = acmap::openCloudFolder(folder);
  paths_ = std::move(clouds.paths);
  rows_ = std::move(clouds.rows);
  trajectory_ = std::move(clouds.trajectory);
  remarks_ = std::move(clouds.remarks);
  is_given_ = clouds.is_recorded; // and not compared with VIEWPOINTs
  readFiles();
  recorded_ = trajectory_.poses;
  has_recorded_poses_ = true;
  T_recorded_cloud_ = clouds.T_recorded_cloud;
  if (hasTrajectory() && !file_shift_.isZero(0))
    T_recorded_cloud_ = T_recorded_cloud_ * Eigen::Translation3d(file_shift_);
  reading_.scale = scale;
  stated_shift_ = shift;
  map_frame_ = MapFrame::Shifted;
  placePoses();
}

ObservationSequence::ObservationSequence(std::vector<std::string> files, double scale)
: paths_(std::move(files))
, scale_(scale)
{
  if (paths_.empty())
    throw acmap::BadArgument("a sequence of no files");
  source_ = paths_.front();
  has_recorded_poses_ = true;
  reading_.scale = scale;
  map_frame_ = MapFrame::Shifted;
  readFiles();
  placePoses();
}

/** All files lose the same kilometres, those that the first readable one asks for. */
void
ObservationSequence::readFiles()
{
  cache_ = cacheOfFiles({*scale_, {}, {}, false});
  for (const std::string& path : paths_) {
    try {
      file_shift_ = cache_->load(path)->shift;
      break;
    }
    catch (const InputFileException&) { // told when it is its turn
    }
  }
  cache_ = cacheOfFiles({*scale_, file_shift_, {}, false});
}

/** A point p of a file is p - file_shift_ in the memory, and T p in the map is T p - shift_
 * there. */
void
ObservationSequence::placePoses()
{
  std::vector<Eigen::Isometry3d>& poses = trajectory_.poses;
  poses.clear();
  for (const Eigen::Isometry3d& recorded : recorded_)
    poses.push_back(readPose(recorded, reading_));
  if (map_frame_ == MapFrame::Shifted)
    shiftPoses();
  if (!T_recorded_cloud_.matrix().isIdentity(0))
    for (Eigen::Isometry3d& pose : poses)
      pose = pose * T_recorded_cloud_;
  if (map_frame_ == MapFrame::FirstCamera)
    startAtFirst(poses);
}

void
ObservationSequence::shiftPoses()
{
  std::vector<Eigen::Vector3d> places = {file_shift_};
  if (hasTrajectory())
    places.clear();
  for (const Eigen::Isometry3d& pose : trajectory_.poses)
    places.emplace_back(pose * T_recorded_cloud_.translation());
  shift_ = acmap::shiftOfPlaces(places, stated_shift_);
  if (shift_.isZero(0) && file_shift_.isZero(0))
    return;
  shift_remark_ = source_ + ": its map has the coordinates of the files less " +
                  acmap::shiftText(shift_) + ", so that they keep their millimetres";
  for (Eigen::Isometry3d& pose : trajectory_.poses)
    pose = Eigen::Translation3d(-shift_) * pose;
}

void
ObservationSequence::takeAsRecorded()
{
  recorded_ = trajectory_.poses;
  has_recorded_poses_ = true;
  reading_ = PoseReading();
  T_recorded_cloud_.setIdentity();
  map_frame_ = MapFrame::Recorded;
}

ObservationSequence::ObservationSequence(
    std::vector<std::shared_ptr<const PointCloudFile>> clouds, Trajectory trajectory)
: source_("the sequence in memory")
, trajectory_(std::move(trajectory))
, is_given_(true)
, cache_(std::make_shared<acmap::ObservationCache>())
{
  if (clouds.empty())
    throw acmap::BadArgument("no observation was added");
  if (hasTrajectory() && trajectory_.poses.size() != clouds.size())
    throw acmap::BadArgument("there are ",
                             trajectory_.poses.size(),
                             " poses for ",
                             clouds.size(),
                             " clouds");
  requirePoses(trajectory_);
  takeAsRecorded();
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    paths_.push_back(acmap::observationName(i));
    requireObservation(paths_.back(), clouds[i]);
    cache_->hold(paths_.back(), std::move(clouds[i]));
    rows_.push_back(i);
  }
}

ObservationSequence::ObservationSequence(const RgbdSequence& recorded,
                                         const RgbdCameras& cameras,
                                         unsigned threads)
: source_(recorded.folder)
, is_given_(true)
, source_state_(acmap::stateOfRgbd(recorded, cameras))
, remarks_(recorded.remarks)
{
  if (recorded.frames.empty())
    throw acmap::BadArgument("a sequence of no frames");
  trajectory_ = acmap::recordedTrajectory(recorded);
  recorded_ = trajectory_.poses;
  has_recorded_poses_ = true;
  T_recorded_cloud_ = frameOfObservations(cameras);
  map_frame_ = MapFrame::FirstCamera;
  placePoses();
  for (std::size_t i = 0; i < recorded.frames.size(); ++i) {
    paths_.push_back(acmap::observationName(i));
    rows_.push_back(i);
  }
  rgbd_ = std::make_shared<acmap::RgbdReader>(recorded, cameras, trajectory_, threads);
  cache_ = std::make_shared<acmap::ObservationCache>(
      [reader = rgbd_](const std::string& name) {
        return std::make_shared<const PointCloudFile>(reader->read(name));
      });
}

ObservationSequence::ObservationSequence(
    const std::shared_ptr<const ObservationSource>& recorded)
: is_given_(true)
{
  if (!recorded || recorded->size() == 0)
    throw acmap::BadArgument("a sequence of no observations");
  source_ = recorded->name();
  source_state_ = recorded->fingerprint();
  shift_ = recorded->shift();
  remarks_ = recorded->remarks();
  trajectory_ = recorded->trajectory();
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < recorded->size(); ++i) {
    paths_.push_back(recorded->nameOf(i));
    rows_.push_back(i);
    numbers[paths_.back()] = i;
  }
  cache_ = std::make_shared<acmap::ObservationCache>(
      [recorded, numbers](const std::string& name) {
        const auto file =
            std::make_shared<const PointCloudFile>(recorded->load(numbers.at(name)));
        requireObservation(name, file);
        return file;
      });
}

ObservationSequence
ObservationSequence::withPoses(const std::vector<std::size_t>& places,
                               Trajectory trajectory) const
{
  if (places.empty())
    throw acmap::BadArgument("a sequence of no observations");
  if (trajectory.poses.size() != places.size())
    throw acmap::BadArgument("there are ",
                             trajectory.poses.size(),
                             " poses for ",
                             places.size(),
                             " observations");
  requirePoses(trajectory);
  ObservationSequence posed = *this;
  posed.paths_.clear();
  std::size_t next = 0;
  for (const std::size_t place : places) {
    if (place < next || place >= size())
      throw acmap::BadArgument(
          "observation ", place, " is none of ", source_, ", or out of order");
    posed.paths_.push_back(paths_[place]);
    next = place + 1;
  }
  posed.rows_.resize(places.size());
  std::iota(posed.rows_.begin(), posed.rows_.end(), std::size_t{0});
  posed.trajectory_ = std::move(trajectory);
  posed.takeAsRecorded();
  posed.is_given_ = true;
  return posed;
}

ObservationSequence
ObservationSequence::withShift(const Eigen::Vector3d& shift) const
{
  ObservationSequence shifted = *this;
  shifted.shift_ = shift;
  return shifted;
}

ObservationSequence
ObservationSequence::followedBy(const ObservationSequence& next) const
{
  constexpr double pause = 1; // seconds
  std::map<std::string,
           std::pair<std::shared_ptr<acmap::ObservationCache>, std::string>>
      origins;
  ObservationSequence joined = *this;
  joined.paths_.clear();
  joined.source_state_.clear();
  joined.trajectory_ = Trajectory();
  joined.is_given_ = true;
  if (next.scale_ != scale_ || next.file_shift_ != file_shift_)
    joined.scale_.reset();
  const auto add = [&](const ObservationSequence& sequence, double delay) {
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      std::string name = sequence.paths_[i];
      if (origins.count(name) > 0) {
        name = "next/" + name; // clouds in memory are called alike in all sequences
        joined.scale_.reset();
      }
      joined.paths_.push_back(name);
      origins.emplace(name, std::pair(sequence.cache_, sequence.paths_[i]));
      joined.trajectory_.stamps.push_back(sequence.stamp(i) + delay);
      joined.trajectory_.poses.push_back(sequence.pose(i));
    }
  };
  add(*this, 0);
  add(next, std::max(0.0, joined.trajectory_.stamps.back() + pause - next.stamp(0)));
  joined.takeAsRecorded();
  joined.rgbd_.reset();
  joined.rows_.resize(joined.size());
  std::iota(joined.rows_.begin(), joined.rows_.end(), std::size_t{0});
  joined.cache_ = std::make_shared<acmap::ObservationCache>(
      [origins = std::move(origins)](const std::string& path) {
        const auto& [cache, name] = origins.at(path);
        return cache->load(name);
      });
  joined.setCacheSize(0); // those of both sequences are sufficient
  return joined;
}

void
ObservationSequence::put(std::size_t begin,
                         std::size_t end,
                         acmap::ByteParcel& parcel) const
{
  if (!scale_)
    throw acmap::BadArgument(source_ + ": its observations are no files");
  parcel.put(*scale_);
  parcel.putAll(file_shift_.data(), 3);
  parcel.put(is_given_);
  parcel.put(reading_.convention);
  parcel.put(reading_.scale);
  parcel.put(hasTrajectory());
  parcel.put(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    parcel.putText(paths_[i]);
    parcel.put(stamp(i));
    if (hasTrajectory())
      parcel.putAll(pose(i).matrix().data(), 16);
  }
}

ObservationSequence
ObservationSequence::taken(acmap::ByteParcel& parcel)
{
  ObservationSequence sequence;
  sequence.scale_ = parcel.take<double>();
  parcel.takeAll(sequence.file_shift_.data(), 3);
  sequence.cache_ = cacheOfFiles({*sequence.scale_, sequence.file_shift_, {}, false});
  sequence.is_given_ = parcel.take<bool>();
  sequence.reading_.convention = parcel.take<PoseConvention>();
  sequence.reading_.scale = parcel.take<double>();
  const bool has_trajectory = parcel.take<bool>();
  for (auto left = parcel.take<std::size_t>(); left > 0; --left) {
    sequence.rows_.push_back(sequence.paths_.size());
    sequence.paths_.push_back(parcel.takeText());
    sequence.trajectory_.stamps.push_back(parcel.take<double>());
    if (has_trajectory)
      parcel.takeAll(sequence.trajectory_.poses.emplace_back().matrix().data(), 16);
  }
  return sequence;
}

std::string
ObservationSequence::fingerprint() const
{
  acmap::Fingerprint hash;
  hash.add(source_state_);
  if (scale_)
    hash.add(&*scale_, sizeof *scale_);
  if (!shift_.isZero(0))
    hash.add(shift_.data(), 3 * sizeof(double));
  if (!hasTrajectory() && !isReadAsFiles())
    hash.add(textOf(reading_));
  for (std::size_t i = 0; i < size(); ++i) {
    hash.add(paths_[i]);
    const double time = stamp(i);
    hash.add(&time, sizeof time);
    if (areFiles())
      hash.add(acmap::stateOfFile(paths_[i]));
    else if (source_state_.empty()) {
      const std::shared_ptr<const PointCloudFile> file = cache_->load(paths_[i]);
      for (const PCLPointField& field : file->cloud.fields)
        hash.add(field.name + ":" + std::to_string(field.datatype));
      hash.add(file->cloud.data.data(), file->cloud.data.size());
      hash.add(viewpointOf(*file).matrix());
    }
    if (hasTrajectory())
      hash.add(trajectory_.poses[rows_[i]].matrix());
  }
  return hash.text();
}

std::string
ObservationSource::nameOf(std::size_t i) const
{
  return acmap::observationName(i);
}

std::string
ObservationSequence::folder() const
{
  return fs::path(paths_.front()).parent_path().string();
}

std::string
ObservationSequence::name(std::size_t i) const
{
  return fs::path(paths_[i]).filename().string();
}

std::vector<std::string>
ObservationSequence::names() const
{
  std::vector<std::string> names;
  for (std::size_t i = 0; i < size(); ++i)
    names.push_back(name(i));
  return names;
}

double
ObservationSequence::stamp(std::size_t i) const
{
  const std::size_t row = i < rows_.size() ? rows_[i] : i;
  return row < trajectory_.stamps.size() ? trajectory_.stamps[row]
                                         : static_cast<double>(i);
}

Eigen::Isometry3d
ObservationSequence::pose(std::size_t i) const
{
  return hasTrajectory() ? trajectory_.poses[rows_[i]]
                         : viewpoint(*cache_->load(paths_[i]));
}

bool
ObservationSequence::isReadAsFiles() const
{
  return reading_.convention == PoseConvention::CameraToWorld &&
         reading_.scale == scale_.value_or(1);
}

/** The pose that the VIEWPOINT of a file means. */
Eigen::Isometry3d
ObservationSequence::viewpoint(const PointCloudFile& file) const
{
  Eigen::Isometry3d pose = viewpointOf(file);
  if (isReadAsFiles())
    return pose;
  pose.translation() /= scale_.value_or(1);
  return readPose(pose, reading_);
}

Eigen::Isometry3d
ObservationSequence::recordedPose(std::size_t i) const
{
  if (!recorded_.empty())
    return recorded_[rows_[i]];
  if (areFiles() && acmap::endingOf(paths_[i]) == ".pcd")
    return acmap::loadPcdViewpoint(paths_[i]);
  Eigen::Isometry3d pose = viewpointOf(*cache_->load(paths_[i]));
  pose.translation() /= scale_.value_or(1);
  return pose;
}

Eigen::Isometry3d
ObservationSequence::poseInHeader(std::size_t i) const
{
  return hasTrajectory() ? pose(i) : readPose(recordedPose(i), reading_);
}

ObservationSequence
ObservationSequence::withPosesRead(const PoseReading& reading) const
{
  ObservationSequence other = *this;
  if (!has_recorded_poses_)
    return other;
  other.reading_ = reading;
  other.placePoses();
  return other;
}

PosedObservation
ObservationSequence::load(std::size_t i) const
{
  PosedObservation observation;
  observation.file = cache_->load(paths_[i]);
  const Eigen::Isometry3d viewpoint = viewpointOf(*observation.file);
  if (!hasTrajectory()) {
    observation.T_map_camera = this->viewpoint(*observation.file);
    return observation;
  }
  observation.T_map_camera = trajectory_.poses[rows_[i]];
  const double apart =
      (observation.T_map_camera.translation() - viewpoint.translation()).norm();
  constexpr double max_apart = 0.001; // metres
  if (!is_given_ && isKnown(viewpoint) && apart > max_apart)
    observation.remarks.push_back(paths_[i] + ": its VIEWPOINT is " +
                                  acmap::shortNumber(apart) + " m from its pose in " +
                                  acmap::trajectory_name + ", which holds");
  return observation;
}

std::shared_ptr<const PointCloudFile>
ObservationSequence::loadMeasured(std::size_t i) const
{
  return rgbd_ ? std::make_shared<const PointCloudFile>(rgbd_->readMeasured(paths_[i]))
               : cache_->load(paths_[i]);
}

std::string
acmap::inOneLine(const std::vector<std::string>& remarks)
{
  const std::size_t others = remarks.size() - 1;
  return remarks.front() +
         (others > 0 ? "; and " + std::to_string(others) + " further files likewise"
                     : "");
}

std::vector<std::string>
ObservationSequence::remarks() const
{
  std::vector<std::string> remarks = remarks_;
  if (!shift_remark_.empty())
    remarks.push_back(shift_remark_);
  if (const std::size_t poses = trajectory_.poses.size(); poses > size())
    remarks.push_back((fs::path(source_) / acmap::trajectory_name).string() + ": has " +
                      std::to_string(poses) + " poses, the folder " +
                      std::to_string(size()) + " observations: the others are missing");
  return remarks;
}

void
ObservationSequence::requireDifferent(const std::vector<Eigen::Isometry3d>& poses) const
{
  if (poses.size() < 2 || hasTrajectory())
    return;
  for (const Eigen::Isometry3d& pose : poses)
    if (pose.matrix() != poses.front().matrix())
      return;
  throw InputFileException(source_ + ": the observations have no poses: there is no " +
                           acmap::trajectory_name +
                           ", and their VIEWPOINTs are all the same; "
                           "pcl_visual_egomotion finds poses");
}

void
ObservationSequence::setCacheSize(std::size_t bytes)
{
  cache_->setLimit(bytes);
}

std::size_t
ObservationSequence::getNumberOfReads() const
{
  return cache_->reads();
}

} // namespace pcl

#include "shot_source.h"

#include "exit_code.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/yaml_node.h>
#include <pcl/stereo/matched_disparity.h>

#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::size_t most_shots = 256; // that DisparityFusion takes

/** \brief The rig of image lists: cameras without a list are not used.
 * \throws UsageError for a list of a camera that the rig has not */
TrinocularRig
rigOfLists(const StereoOptions& options)
{
  TrinocularRig rig = loadTrinocularRig(options.rig);
  const auto use =
      [&](RigCamera camera, const std::vector<std::string>& images, double& baseline) {
        const std::string name = nameOf(camera);
        if (images.empty())
          baseline = 0.0;
        else if (baseline == 0.0)
          throw UsageError("--" + name + ": " + options.rig + " has no " + name +
                           " camera");
      };
  use(RigCamera::Horizontal, options.images.horizontal, rig.baseline_horizontal);
  use(RigCamera::Vertical, options.images.vertical, rig.baseline_vertical);
  return rig;
}

std::unique_ptr<TrinocularFileGrabber>
openGrabber(const StereoOptions& options)
{
  if (options.hasLists())
    return std::make_unique<TrinocularFileGrabber>(options.images, rigOfLists(options));
  return std::make_unique<TrinocularFileGrabber>(options.session);
}

} // namespace

ShotSource::ShotSource(const StereoOptions& options, unsigned threads)
: grabber_(openGrabber(options))
, skips_broken_(!options.hasLists())
, has_cameras_(loadYaml(options.rigPath()).find("camera_reference") != nullptr)
, rig_(grabber_->getRig())
, broken_(grabber_->getReport().broken.size())
, remarks_(grabber_->getReport().remarks)
{
  if (disparityBaseline(rig_) == 0.0)
    throw InputFileException(options.rigPath() +
                             ": the reference has no neighbour, both baselines are 0");
  // a session says by its rig.yaml what its frames are
  if (options.hasLists() ? options.rectify : has_cameras_)
    setUpRectification(options.rigPath(), threads);
  if (!options.color.empty())
    pending_ = loadOffShot(options.color);
}

void
ShotSource::setUpRectification(const std::string& path, unsigned threads)
{
  rectification_.emplace();
  rectification_->setNumberOfThreads(threads);
  RigCalibration cameras = loadRigCalibration(path);
  cameras.camera(RigCamera::Horizontal).is_there = rig_.baseline_horizontal != 0.0;
  cameras.camera(RigCamera::Vertical).is_there = rig_.baseline_vertical != 0.0;
  try {
    rectification_->setInputCalibration(cameras);
  }
  catch (const BadArgumentException& fault) {
    throw InputFileException(path + ": " + fault.what());
  }
  const double sigma = rig_.disparity_sigma; // no matter of rectification
  rig_ = rectification_->getRig();
  rig_.disparity_sigma = sigma;
  for (const std::string& remark : rectification_->getReport().remarks)
    remarks_.push_back(path + ": " + remark);
}

TrinocularFrame::Ptr
ShotSource::read(std::size_t index) const
{
  TrinocularFrame::Ptr frame = grabber_->frame(index);
  if (rectification_)
    rectification_->rectify(*frame, *frame);
  return frame;
}

/** \return false for a frame of another observation */
bool
ShotSource::add(const TrinocularFrame::ConstPtr& frame, ObservationShots& shots)
{
  const auto number = static_cast<std::size_t>(frame->observation);
  if (!shots.frames.empty() && number != shots.number)
    return false;
  if (done_.count(number) > 0)
    leaveOut(*frame, "frames of another one stand before them");
  else if (shots.frames.size() == most_shots)
    leaveOut(*frame, "there are " + std::to_string(most_shots) + " before them");
  else {
    shots.number = number;
    shots.frames.push_back(frame);
  }
  return true;
}

void
ShotSource::leaveOut(const TrinocularFrame& frame, const std::string& reason)
{
  if (cut_.insert(frame.observation).second)
    remarks_.push_back("observation " + std::to_string(frame.observation) +
                       ": its frames from " + std::to_string(frame.number) +
                       " on are left out, " + reason);
}

std::optional<ObservationShots>
ShotSource::next(const std::function<void()>& step)
{
  ObservationShots shots;
  if (pending_)
    add(std::exchange(pending_, nullptr), shots);
  while (next_ < frames() && !pending_) {
    step();
    const std::size_t index = next_++;
    try {
      const TrinocularFrame::ConstPtr frame = read(index);
      if (!add(frame, shots))
        pending_ = frame;
    }
    catch (const InputFileException&) {
      if (!skips_broken_)
        throw;
      noteBroken();
    }
  }
  if (shots.frames.empty())
    return std::nullopt;
  done_.insert(shots.number);
  return shots;
}

std::size_t
ShotSource::lastObservation() const
{
  for (std::size_t index = frames(); index-- > 0;)
    try {
      return static_cast<std::size_t>(grabber_->frame(index)->observation);
    }
    catch (const InputFileException&) {
      if (index == 0)
        throw;
    }
  throw InputFileException("the session has no frames");
}

TrinocularFrame::ConstPtr
ShotSource::loadOffShot(const std::string& path) const
{
  TrinocularFrame::Ptr frame(new TrinocularFrame);
  CameraImage& image = frame->image(RigCamera::Reference);
  image = loadCameraImage(path);
  const auto size = [](std::int32_t width, std::int32_t height) {
    return std::to_string(width) + " x " + std::to_string(height) + " pixels";
  };
  if (image.width != rig_.width || image.height != rig_.height)
    throw InputFileException(path + ": has " + size(image.width, image.height) +
                             ", the rig " + size(rig_.width, rig_.height));
  if (rectification_)
    rectification_->rectify(*frame, *frame);
  // a shot has an image of each camera, but colour is only taken from the reference
  if (rig_.baseline_horizontal != 0.0)
    frame->image(RigCamera::Horizontal) = image;
  if (rig_.baseline_vertical != 0.0)
    frame->image(RigCamera::Vertical) = image;
  return frame;
}

void
ShotSource::noteBroken()
{
  const TrinocularFileReport report = grabber_->getReport();
  if (report.broken.size() == broken_)
    return; // it was found when the session was opened
  broken_ = report.broken.size();
  remarks_.push_back(report.remarks.back());
}

std::vector<std::string>
ShotSource::remarks() const
{
  std::vector<std::string> all = remarks_;
  const TrinocularFileReport report = grabber_->getReport();
  const auto count = [&](const std::vector<std::uint64_t>& found,
                         const std::string& fault) {
    if (!found.empty())
      all.push_back(std::to_string(found.size()) + " of " + std::to_string(frames()) +
                    " frames have a camera that is " + fault + ", the first is " +
                    std::to_string(found.front()));
  };
  count(report.saturated, "saturated");
  count(report.black, "black");
  return all;
}

} // namespace pcl::acmap

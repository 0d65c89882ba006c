#include "shot_source.h"

#include "tool.h"

#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace pcl::acmap {

namespace {

/** \brief The rig of image lists: cameras without a list are not used.
 * \throws UsageError for a list of a camera that is not in the rig */
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

ShotSource::ShotSource(const StereoOptions& options, unsigned threads, ReplayPace pace)
: options_(options)
, grabber_(openGrabber(options))
, has_cameras_(hasBuiltCameras(options.rigPath()))
// the rig.yaml of a session defines if its frames are rectified
, rectifier_(options.rigPath(),
             grabber_->getRig(),
             options.hasLists() ? options.rectify : has_cameras_,
             threads)
, pace_(pace)
, broken_(grabber_->getReport().broken.size())
, remarks_(grabber_->getReport().remarks)
{
  const std::vector<std::string>& more = rectifier_.remarks();
  remarks_.insert(remarks_.end(), more.begin(), more.end());
  if (!options.color.empty())
    groups_.add(loadOffShot(options.color));
}

ComingShots
ShotSource::next()
{
  const auto count = static_cast<double>(grabber_->frames());
  while (next_ < grabber_->frames()) {
    const std::size_t index = next_++;
    try {
      const TrinocularFrame::Ptr frame = grabber_->frame(index);
      waitFor(*frame);
      if (options_.unlit && frame->pattern != TrinocularFrame::no_pattern)
        continue;
      rectifier_.rectify(*frame);
      if (options_.isPassive())
        frame->pattern = TrinocularFrame::no_pattern;
      if (auto shots = groups_.add(frame))
        return {std::move(shots), static_cast<double>(index) / count};
    }
    catch (const InputFileException&) {
      if (options_.hasLists())
        throw;
      noteBroken();
    }
  }
  return {groups_.finish(), 1.0};
}

std::size_t
ShotSource::lastObservation() const
{
  for (std::size_t index = grabber_->frames(); index-- > 0;)
    try {
      return static_cast<std::size_t>(grabber_->frame(index)->observation);
    }
    catch (const InputFileException&) {
      if (index == 0)
        throw;
    }
  throw InputFileException("the session has no frames");
}

std::vector<std::string>
ShotSource::remarks() const
{
  std::vector<std::string> all = remarks_;
  all.insert(all.end(), groups_.remarks().begin(), groups_.remarks().end());
  const TrinocularFileReport report = grabber_->getReport();
  const auto count = [&](const std::vector<std::uint64_t>& found,
                         const std::string& fault) {
    if (!found.empty())
      all.push_back(std::to_string(found.size()) + " of " +
                    std::to_string(grabber_->frames()) +
                    " frames have a camera that is " + fault + ", the first is " +
                    std::to_string(found.front()));
  };
  count(report.saturated, "saturated");
  count(report.black, "black");
  return all;
}

TrinocularFrame::ConstPtr
ShotSource::loadOffShot(const std::string& path) const
{
  TrinocularFrame::Ptr frame(new TrinocularFrame);
  CameraImage& image = frame->image(RigCamera::Reference);
  image = loadCameraImage(path);
  if (image.width != rig().width || image.height != rig().height)
    throw InputFileException(path + ": has " + sizeText(image) + " pixels, the rig " +
                             sizeText(rig()) + " pixels");
  rectifier_.rectify(*frame);
  // a shot has an image of each camera, but colour is only taken from the reference
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    if (hasCamera(rig(), camera))
      frame->image(camera) = image;
  return frame;
}

/** Lets the time pass that passed between the frame before and this one. */
void
ShotSource::waitFor(const TrinocularFrame& frame)
{
  if (pace_ == ReplayPace::AtOnce)
    return;
  using Clock = std::chrono::steady_clock;
  constexpr std::uint64_t longest = 60000000; // microseconds
  constexpr std::chrono::milliseconds step(100);
  const std::uint64_t before = stamp_.value_or(frame.stamp);
  if (!stamp_)
    due_ = Clock::now();
  stamp_ = frame.stamp;
  if (frame.stamp > before)
    due_ += std::chrono::microseconds(std::min(frame.stamp - before, longest));
  while (Clock::now() < due_) {
    stopIfInterrupted();
    idle_();
    std::this_thread::sleep_until(std::min(due_, Clock::now() + step));
  }
}

void
ShotSource::noteBroken()
{
  const TrinocularFileReport report = grabber_->getReport();
  if (report.broken.size() == broken_)
    return; // already found when the session was opened
  broken_ = report.broken.size();
  remarks_.push_back(report.remarks.back());
}

} // namespace pcl::acmap

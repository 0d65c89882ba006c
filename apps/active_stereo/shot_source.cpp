#include "shot_source.h"

#include "exit_code.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/rig_cameras.h>

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

FrameRectifier
rectifierOf(const StereoOptions& options,
            const TrinocularRig& rig,
            bool has_cameras,
            unsigned threads)
{
  // the rig.yaml of a session defines if its frames are rectified
  if (options.hasLists() ? options.rectify : has_cameras)
    return FrameRectifier(options.rigPath(), rig, threads);
  return FrameRectifier(options.rigPath(), rig);
}

} // namespace

ShotSource::ShotSource(const StereoOptions& options, unsigned threads)
: grabber_(openGrabber(options))
, skips_broken_(!options.hasLists())
, is_passive_(options.isPassive())
, has_cameras_(hasBuiltCameras(options.rigPath()))
, rectifier_(rectifierOf(options, grabber_->getRig(), has_cameras_, threads))
, broken_(grabber_->getReport().broken.size())
, remarks_(grabber_->getReport().remarks)
{
  for (const std::string& remark : rectifier_.remarks())
    remarks_.push_back(remark);
  if (!options.color.empty())
    pending_ = loadOffShot(options.color);
}

TrinocularFrame::Ptr
ShotSource::read(std::size_t index) const
{
  TrinocularFrame::Ptr frame = grabber_->frame(index);
  rectifier_.rectify(*frame);
  if (is_passive_)
    frame->pattern = TrinocularFrame::no_pattern;
  return frame;
}

std::optional<ObservationShots>
ShotSource::next()
{
  ObservationShots shots;
  if (pending_)
    groups_.add(std::exchange(pending_, nullptr), shots);
  while (next_ < frames() && !pending_) {
    const std::size_t index = next_++;
    try {
      const TrinocularFrame::ConstPtr frame = read(index);
      if (!groups_.add(frame, shots))
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
  groups_.close(shots);
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
  if (image.width != rig().width || image.height != rig().height)
    throw InputFileException(path + ": has " + size(image.width, image.height) +
                             ", the rig " + size(rig().width, rig().height));
  rectifier_.rectify(*frame);
  // a shot has an image of each camera, but colour is only taken from the reference
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    if (hasCamera(rig(), camera))
      frame->image(camera) = image;
  return frame;
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

std::vector<std::string>
ShotSource::remarks() const
{
  std::vector<std::string> all = remarks_;
  all.insert(all.end(), groups_.remarks().begin(), groups_.remarks().end());
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

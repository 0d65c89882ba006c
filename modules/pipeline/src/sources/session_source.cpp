#include <pcl/conversions.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/session_source.h>
#include <pcl/stereo/pair_direction.h>

#include <cstring>
#include <utility>

namespace pcl {

namespace {

using acmap::ObservationShots;

const FrameReader&
required(const std::shared_ptr<const FrameReader>& frames)
{
  if (!frames)
    throw acmap::BadArgument("there are no frames");
  return *frames;
}

std::string
rigFileOf(const FrameReader& frames, const SessionSettings& settings)
{
  return settings.rig.empty() && !frames.folder().empty()
             ? frames.folder() + "/rig.yaml"
             : settings.rig;
}

/** The cameras of frames that are not rectified. */
std::optional<RigCalibration>
rawCamerasOf(const std::string& rig, const SessionSettings& settings)
{
  if (settings.cameras)
    return settings.cameras;
  if (settings.rectify ? *settings.rectify
                       : !rig.empty() && acmap::hasBuiltCameras(rig))
    return loadRigCalibration(rig);
  return std::nullopt;
}

/** The cloud as a file has it: without the padding of points, whose bytes are arbitrary. */
PCLPointCloud2
withoutPadding(const PointCloud<PointXYZRGBSigma>& cloud)
{
  PCLPointCloud2 padded;
  toPCLPointCloud2(cloud, padded);
  PCLPointCloud2 packed = padded;
  packed.point_step = 0;
  for (PCLPointField& field : packed.fields) {
    field.offset = packed.point_step;
    packed.point_step += sizeof(float);
  }
  packed.row_step = packed.width * packed.point_step;
  packed.data.resize(cloud.size() * packed.point_step);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::size_t field = 0; field < packed.fields.size(); ++field)
      std::memcpy(&packed.data[i * packed.point_step + packed.fields[field].offset],
                  &padded.data[i * padded.point_step + padded.fields[field].offset],
                  sizeof(float));
  return packed;
}

} // namespace

SessionSource::SessionSource(std::shared_ptr<const FrameReader> frames,
                             const SessionSettings& settings,
                             const CostCallback& cost)
: frames_(std::move(frames))
, settings_(settings)
, rig_file_(rigFileOf(required(frames_), settings_))
, rectifier_(rig_file_,
             frames_->getRig(),
             rawCamerasOf(rig_file_, settings_),
             settings_.threads)
, remarks_(frames_->faults().remarks)
, broken_(frames_->faults().broken.size())
{
  findObservations();
  const std::vector<std::string>& more = rectifier_.remarks();
  remarks_.insert(remarks_.end(), more.begin(), more.end());
  if (!settings_.color.empty())
    color_ = loadColor();
  fusion_.emplace(rig(), settings_, cost);
}

SessionSource::~SessionSource() = default;

/** An observation begins with its first frame; all frames up to the next beginning are
 * read with it, also those that belong to earlier ones. */
void
SessionSource::findObservations()
{
  std::set<std::size_t> known;
  for (std::size_t index = 0; index < frames_->frames(); ++index)
    if (const auto observation = frames_->observationOf(index);
        observation && known.insert(static_cast<std::size_t>(*observation)).second) {
      begins_.push_back(begins_.empty() ? 0 : index);
      numbers_.push_back(static_cast<std::size_t>(*observation));
    }
  begins_.push_back(frames_->frames());
}

TrinocularFrame::ConstPtr
SessionSource::loadColor() const
{
  TrinocularFrame::Ptr frame(new TrinocularFrame);
  if (!numbers_.empty())
    frame->observation = static_cast<std::int32_t>(numbers_.front());
  CameraImage& image = frame->image(RigCamera::Reference);
  image = loadCameraImage(settings_.color);
  if (image.width != rig().width || image.height != rig().height)
    throw InputFileException(settings_.color + ": has " + acmap::sizeText(image) +
                             " pixels, the rig " + acmap::sizeText(rig()) + " pixels");
  rectifier_.rectify(*frame);
  // a shot has an image of each camera, but colour is only taken from the reference
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    if (acmap::hasCamera(rig(), camera))
      frame->image(camera) = image;
  return frame;
}

/** \return nothing for a broken frame, and one that is not of the kind that is used */
TrinocularFrame::Ptr
SessionSource::read(std::size_t index) const
{
  try {
    const TrinocularFrame::Ptr frame = frames_->frame(index);
    if (settings_.arrived)
      settings_.arrived(*frame);
    if (settings_.unlit && frame->pattern != TrinocularFrame::no_pattern)
      return {};
    rectifier_.rectify(*frame);
    if (settings_.isPassive())
      frame->pattern = TrinocularFrame::no_pattern;
    return frame;
  }
  catch (const InputFileException&) {
    if (!settings_.skip_broken)
      throw;
    const FrameFaults faults = frames_->faults();
    if (faults.broken.size() > broken_) // else found when the session was opened
      remarks_.push_back(faults.remarks.back());
    broken_ = faults.broken.size();
    return {};
  }
}

std::optional<ObservationShots>
SessionSource::shots(std::size_t i) const
{
  const std::lock_guard lock(reading_);
  groups_.restart(
      {numbers_.begin(), numbers_.begin() + static_cast<std::ptrdiff_t>(i)});
  if (i == 0 && color_)
    groups_.add(color_);
  std::optional<ObservationShots> found;
  for (std::size_t index = begins_.at(i); index < begins_.at(i + 1); ++index)
    if (const TrinocularFrame::Ptr frame = read(index))
      if (auto complete = groups_.add(frame))
        found = std::move(complete);
  return found ? found : groups_.finish();
}

std::string
SessionSource::name() const
{
  const std::string folder = frames_->folder();
  return folder.empty() ? rig_file_ : folder;
}

std::string
SessionSource::nameOf(std::size_t i) const
{
  return acmap::observationName(numberOf(i));
}

PointCloudFile
SessionSource::load(std::size_t i) const
{
  const std::optional<ObservationShots> found = shots(i);
  if (!found)
    throw InputFileException(name() + ": observation " + std::to_string(numberOf(i)) +
                             " has no shot that can be used");
  PointCloudFile file;
  file.cloud = withoutPadding(fuse(*found).cloud);
  return file;
}

std::vector<std::string>
SessionSource::remarks() const
{
  const std::lock_guard lock(reading_);
  std::vector<std::string> all = remarks_;
  const std::vector<std::string>& more = groups_.remarks();
  all.insert(all.end(), more.begin(), more.end());
  const FrameFaults faults = frames_->faults();
  const auto count = [&](const std::vector<std::uint64_t>& found,
                         const std::string& fault) {
    if (!found.empty())
      all.push_back(std::to_string(found.size()) + " of " +
                    std::to_string(frames_->frames()) +
                    " frames have a camera that is " + fault + ", the first is " +
                    std::to_string(found.front()));
  };
  count(faults.saturated, "saturated");
  count(faults.black, "black");
  return all;
}

/** The sign of a baseline is in no other number, and a wrong one gives a wrong map. */
void
SessionSource::checkDirections(const TrinocularFrame& frame) const
{
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical}) {
    if (!acmap::hasCamera(rig(), camera))
      continue;
    const acmap::PairDirection found = acmap::measureDirection(frame, rig(), camera);
    if (!found.isContradicted())
      continue;
    const double baseline = camera == RigCamera::Horizontal ? rig().baseline_horizontal
                                                            : rig().baseline_vertical;
    const double share = static_cast<double>(found.opposite) /
                         static_cast<double>(found.opposite + found.as_stated);
    const std::string name = pcl::nameOf(camera);
    const std::string fault =
        rig_file_ + ": baseline_" + name + " = " + acmap::shortNumber(baseline) +
        " m has the wrong sign, or the images of both cameras are swapped: " +
        acmap::shortNumber(100.0 * share) +
        " % of the pixels that match do so on the other side";
    if (!settings_.keeps_baseline)
      throw InputFileException(fault + "; " + acmap::shortNumber(-baseline) +
                               " m there, or as --baseline, is what they show");
    const std::lock_guard lock(reading_);
    remarks_.push_back(fault);
  }
}

SessionObservation
SessionSource::fuse(const ObservationShots& shots,
                    const ProgressCallback& progress) const
{
  const std::lock_guard lock(fusing_);
  if (report_.observations == 0)
    checkDirections(*shots.frames.front());
  SessionObservation made = fusion_->fuse(shots, progress);
  ++report_.observations;
  report_.frames += made.frames;
  report_.points += made.projection.points;
  report_.too_near += made.projection.too_near;
  report_.too_far += made.projection.too_far;
  for (std::size_t i = 0; i < report_.outcomes.size(); ++i)
    report_.outcomes[i] += made.fusion.outcomes[i];
  return made;
}

std::optional<SessionObservation>
SessionSource::next(const ProgressCallback& progress)
{
  if (const std::optional<ObservationShots> coming = nextShots())
    return fuse(*coming, progress);
  return std::nullopt;
}

std::optional<ObservationShots>
SessionSource::nextShots()
{
  const auto read_on = [this] {
    ahead_ =
        std::async(std::launch::async, [this]() -> std::optional<ObservationShots> {
          while (place_ < size())
            if (auto found = shots(place_++))
              return found;
          return std::nullopt;
        });
  };
  if (!ahead_.valid())
    read_on();
  std::optional<ObservationShots> coming = ahead_.get();
  if (coming)
    read_on();
  return coming;
}

SessionReport
SessionSource::getReport() const
{
  const std::vector<std::string> found = remarks();
  const std::lock_guard lock(fusing_);
  SessionReport report = report_;
  report.remarks = found;
  return report;
}

std::shared_ptr<SessionSource>
openSession(std::shared_ptr<const FrameReader> frames,
            const SessionSettings& settings,
            const CostCallback& cost)
{
  return std::make_shared<SessionSource>(std::move(frames), settings, cost);
}

} // namespace pcl

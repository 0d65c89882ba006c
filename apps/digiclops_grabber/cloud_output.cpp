#include "cloud_output.h"

#include "active_stereo/stereo_files.h"
#include "memory.h"

namespace pcl::acmap {

FrameRectifier
rectifierOf(const GrabberOptions& options, const Device& device, unsigned threads)
{
  if (device.cameras)
    return FrameRectifier(options.rigPath(), device.rig, threads);
  return FrameRectifier(options.rigPath(), device.rig);
}

CloudOutput::CloudOutput(Tool& tool,
                         const GrabberOptions& options,
                         const Device& device)
: options_(options.stereo)
, rectifier_(rectifierOf(options, device, tool.threads()))
, range_(disparitiesBetween(rectifier_.rig(), options_.nearest, options_.farthest))
, maker_(rectifier_.rig(), range_, options_, tool.threads())
{
  requireMemory(disparityMemory(rectifier_.rig(), range_),
                std::to_string(range_.count) + " disparities of " +
                    std::to_string(device.rig.width) + " x " +
                    std::to_string(device.rig.height) + " pixels");
  if (!options.clouds.empty())
    requireNoStereo(folder_.emplace(options.clouds));
  for (const std::string& remark : rectifier_.remarks())
    tool.warn(remark);
}

PointCloud<PointXYZRGBSigma>::ConstPtr
CloudOutput::make(ObservationShots shots, const ProgressCallback& progress)
{
  if (rectifier_.isRectifying())
    for (TrinocularFrame::ConstPtr& frame : shots.frames) {
      const TrinocularFrame::Ptr rectified(new TrinocularFrame(*frame));
      rectifier_.rectify(*rectified);
      frame = rectified;
    }
  const MadeObservation made = maker_.make(shots, progress);
  if (folder_)
    saveResults(*folder_, options_, shots, made, Eigen::Isometry3d::Identity());
  results_.add(shots, made);
  return PointCloud<PointXYZRGBSigma>::ConstPtr(
      new PointCloud<PointXYZRGBSigma>(made.cloud));
}

void
CloudOutput::commit()
{
  if (folder_)
    folder_->commit();
}

void
CloudOutput::tell(Tool& tool) const
{
  results_.warnOfRemarks(tool);
  nlohmann::ordered_json& details = tool.details();
  details["method"] = options_.method;
  details["least_disparity"] = range_.least;
  details["most_disparity"] = range_.most();
  details["points"] = results_.points();
  details["matched_share"] = results_.matchedShare();
  details["observations"] = results_.entries();
  tool.tell("matched", results_.matchedText());
  tool.tell("points", std::to_string(results_.points()));
  tool.tell("rejected", results_.rejected());
}

} // namespace pcl::acmap

#include <pcl/core/impl/yaml_node.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/pipeline/session_source.h>
#include <pcl/stereo/matched_disparity.h>

#include <utility>

namespace pcl::acmap {

std::optional<ObservationShots>
ShotGroups::add(const TrinocularFrame::ConstPtr& frame)
{
  const auto number = static_cast<std::size_t>(frame->observation);
  std::optional<ObservationShots> before;
  if (number != shots_.number)
    before = finish();
  const auto leave_out = [&](const std::string& reason) {
    if (cut_.insert(frame->observation).second)
      remarks_.push_back("observation " + std::to_string(frame->observation) +
                         ": its frames from " + std::to_string(frame->number) +
                         " on are left out, " + reason);
  };
  if (done_.count(number) > 0)
    leave_out("frames of another one stand before them");
  else if (shots_.frames.size() == max_shots)
    leave_out("there are " + std::to_string(max_shots) + " before them");
  else {
    shots_.number = number;
    shots_.frames.push_back(frame);
  }
  return before;
}

std::optional<ObservationShots>
ShotGroups::finish()
{
  ObservationShots shots = std::exchange(shots_, {});
  if (shots.frames.empty())
    return std::nullopt;
  done_.insert(shots.number);
  return shots;
}

void
ShotGroups::restart(std::set<std::size_t> done)
{
  shots_ = {};
  done_ = std::move(done);
}

FrameRectifier::FrameRectifier(const std::string& path,
                               const TrinocularRig& rig,
                               std::optional<RigCalibration> cameras,
                               unsigned threads)
: rig_(rig)
{
  if (disparityBaseline(rig_) == 0.0)
    throw InputFileException(path +
                             ": the reference has no neighbour, both baselines are 0");
  if (!cameras)
    return;
  rectification_.emplace();
  rectification_->setNumberOfThreads(threads);
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    cameras->camera(camera).is_there = hasCamera(rig_, camera);
  try {
    rectification_->setInputCalibration(*cameras);
  }
  catch (const BadArgumentException& fault) {
    throw InputFileException(path + ": " + fault.what());
  }
  const double sigma = rig_.disparity_sigma; // the rectification does not affect it
  rig_ = rectification_->getRig();
  rig_.disparity_sigma = sigma;
  for (const std::string& remark : rectification_->getReport().remarks)
    remarks_.push_back(path + ": " + remark);
}

void
FrameRectifier::rectify(TrinocularFrame& frame) const
{
  if (rectification_)
    rectification_->rectify(frame, frame);
}

bool
hasBuiltCameras(const std::string& path)
{
  return loadYaml(path).find("camera_reference") != nullptr;
}

} // namespace pcl::acmap

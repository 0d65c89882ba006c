#include "frame_rectifier.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/core/yaml_node.h>
#include <pcl/stereo/matched_disparity.h>

namespace pcl::acmap {

FrameRectifier::FrameRectifier(const std::string& path, const TrinocularRig& rig)
: rig_(rig)
{
  if (disparityBaseline(rig_) == 0.0)
    throw InputFileException(path +
                             ": the reference has no neighbour, both baselines are 0");
}

FrameRectifier::FrameRectifier(const std::string& path,
                               const TrinocularRig& rig,
                               unsigned threads)
: FrameRectifier(path, rig)
{
  rectification_.emplace();
  rectification_->setNumberOfThreads(threads);
  RigCalibration cameras = loadRigCalibration(path);
  for (const RigCamera camera : {RigCamera::Horizontal, RigCamera::Vertical})
    cameras.camera(camera).is_there = hasCamera(rig_, camera);
  try {
    rectification_->setInputCalibration(cameras);
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

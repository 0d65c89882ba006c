#include <pcl/core/calibration_file.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/image_file.h>
#include <pcl/pipeline/rgbd_assessment.h>
#include <pcl/pipeline/rgbd_statement.h>

namespace pcl {

namespace {

/** \brief The depth camera of a file, for images of the folder's size. */
Pinhole
statedDepthCamera(const std::string& path, const RgbdSequence& sequence)
{
  const ImageSize size = depthSizeOf(sequence);
  return fittedPinhole(loadCameraPinhole(path), size.width, size.height, path);
}

} // namespace

ImageSize
depthSizeOf(const RgbdSequence& sequence)
{
  if (sequence.frames.empty())
    throw acmap::BadArgument("a recording without frames");
  for (std::size_t i = 0;; ++i)
    try {
      const GrayImage16 image = loadGrayImage16(sequence.frames.at(i).depth);
      return {image.width, image.height};
    }
    catch (const InputFileException&) {
      if (i + 1 >= sequence.frames.size())
        throw;
    }
}

RgbdSequenceSettings
settingsOf(const RgbdStatement& stated)
{
  RgbdSequenceSettings settings;
  settings.has_poses = !stated.no_poses;
  settings.max_stamp_gap = stated.max_stamp_gap;
  settings.has_camera =
      !stated.intrinsics.empty() || (stated.fx && stated.cx && stated.cy);
  return settings;
}

RgbdCameras
camerasOf(const RgbdStatement& stated, const RgbdSequence& sequence, DepthSensor sensor)
{
  RgbdCameras cameras = sequence.cameras();
  Pinhole& depth = cameras.depth;
  if (!stated.intrinsics.empty())
    depth = statedDepthCamera(stated.intrinsics, sequence);
  if (stated.fx)
    depth.fx = depth.fy = *stated.fx;
  depth.fy = stated.fy.value_or(depth.fy);
  depth.cx = stated.cx.value_or(depth.cx);
  depth.cy = stated.cy.value_or(depth.cy);
  if (stated.is_registered)
    cameras.color.reset();
  else if (!stated.color_camera.empty())
    cameras.color = loadColorCamera(stated.color_camera);
  cameras.meaning = {stated.depth_scale.value_or(sequence.depth_scale),
                     stated.max_depth};
  cameras.sensor = sensor;
  return cameras;
}

std::vector<std::string>
rgbdRemarks(const RgbdStatement& stated,
            const RgbdSequence& sequence,
            const RgbdCameras& cameras)
{
  std::vector<std::string> remarks = sequence.remarks;
  if (!cameras.color && !sequence.is_registered && !stated.is_registered)
    remarks.emplace_back(
        "the camera of the colours is not known: took them pixel by pixel as the "
        "depths; --color-camera names it, --registered says that this is right");
  const auto count = [&](std::size_t frames, const std::string& fault) {
    if (frames > 0)
      remarks.push_back(std::to_string(frames) + fault);
  };
  count(sequence.unmatched,
        " depth images left out: no colour image was taken near them");
  count(sequence.unposed, " frames left out: no pose is known near them");
  for (const std::string& remark : assessRgbd(sequence, cameras).remarks)
    remarks.push_back(remark);
  return remarks;
}

} // namespace pcl

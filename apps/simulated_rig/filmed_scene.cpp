#include "filmed_scene.h"

#include "memory.h"

#include <pcl/stereo/trinocular_rectification.h>

namespace pcl::acmap {

namespace {

/** \brief Refuses cameras whose images, rays and tables do not fit into memory. */
void
requireMemoryFor(const RigCalibration& cameras)
{
  constexpr std::size_t bytes_per_pixel = 200;
  requireMemory(bytes_per_pixel * static_cast<std::size_t>(cameras.width) *
                    static_cast<std::size_t>(cameras.height),
                "images of " + std::to_string(cameras.width) + " x " +
                    std::to_string(cameras.height) + " pixels");
}

} // namespace

std::vector<std::string>
setBuiltCameras(const std::string& path, FilmedScene& filmed)
{
  filmed.cameras = loadRigCalibration(path);
  filmed.cameras_path = path;
  requireMemoryFor(*filmed.cameras);
  TrinocularRectification rectification;
  try {
    rectification.setInputCalibration(*filmed.cameras);
  }
  catch (const BadArgumentException& exception) {
    throw InputFileException(path + ": " + exception.what());
  }
  filmed.scene.rig = rectification.getRig();
  filmed.T_rectified_reference.linear() =
      rectification.getRotation(RigCamera::Reference);
  return rectification.getReport().remarks;
}

std::unique_ptr<SimulatedRigGrabber>
grabberOf(const FilmedScene& filmed,
          const std::vector<RgbImage>& patterns,
          const SimulatedLight& light)
{
  if (!filmed.cameras)
    return std::make_unique<SimulatedRigGrabber>(filmed.scene, patterns, light);
  SimulatedScene scene = filmed.scene;
  for (Eigen::Isometry3d& view : scene.views)
    view = view * filmed.T_rectified_reference;
  SimulatedLight turned = light;
  Eigen::Isometry3d& projector = turned.projector.T_reference_projector;
  projector = filmed.T_rectified_reference.inverse() * projector;
  try {
    return std::make_unique<SimulatedRigGrabber>(
        scene, patterns, *filmed.cameras, turned);
  }
  catch (const BadArgumentException& exception) {
    throw InputFileException(filmed.cameras_path + ": " + exception.what());
  }
}

} // namespace pcl::acmap

#include <pcl/core/rig_calibration.h>

#include <exception>
#include <filesystem>
#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 2) {
    std::cerr << "usage: write_rig_seeds FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  pcl::TrinocularRig rig;
  saveTrinocularRig((folder / "rectified.yaml").string(), rig);
  pcl::RigCalibration cameras = pcl::calibrationOf(rig);
  for (pcl::CameraCalibration& camera : cameras.cameras)
    camera.distortion = {-0.25, 0.08, 5e-4, -4e-4, 0};
  saveRigCalibration((folder / "three.yaml").string(), rig, cameras);
  rig.baseline_vertical = 0;
  cameras.camera(pcl::RigCamera::Vertical).is_there = false;
  cameras.camera(pcl::RigCamera::Horizontal)
      .T_reference_camera.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
  saveRigCalibration((folder / "two.yaml").string(), rig, cameras);
  return 0;
}
catch (const std::exception& exception) {
  std::cerr << exception.what() << "\n";
  return 1;
}

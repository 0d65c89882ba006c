#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator_types.h>

#include <vector>

namespace pcl::acmap::test {

/** \brief A realistic rig: strong distortion, cameras rotated by one or two degrees,
 * baselines that are perpendicular, but not parallel to the axes of the reference.
 * \param[in] scale of its images; 1 for 640 x 480 pixels */
RigCalibration
builtRig(double scale = 1);

/** \brief Grey level, 0 to 255, of a point (x, y, 0) on a plane, metres in the frame of
 * the plane. */
using Brightness = double (*)(double x, double y);

/** \brief Renders planes as seen by the cameras of a rig, with sixteen rays per
 * pixel. */
class RigRenderer {
public:
  explicit RigRenderer(const RigCalibration& rig);

  /** \brief Renders the plane z = 0 of a frame; grey, without noise.
   * \param[in] T_reference_plane pose of the plane */
  TrinocularFrame
  frameOf(const Eigen::Isometry3d& T_reference_plane, Brightness brightness) const;

private:
  CameraImage
  imageOf(RigCamera camera,
          const Eigen::Isometry3d& T_camera_plane,
          Brightness brightness) const;

  RigCalibration rig_;
  // Rays of the pixels' corners at z = 1, by camera.
  std::array<std::vector<Eigen::Vector2d>, 3> rays_;
};

/** \brief A board of 9 x 6 corners and 30 mm squares with a white margin on a grey
 * wall.
 * \param[in] x,y relative to the first corner; x along a row, y down */
double
boardBrightness(double x, double y);

/** \brief Realistic poses of a hand-held board in front of a rig: all over the image,
 * near and far, tilted and rotated. */
std::vector<Eigen::Isometry3d>
boardPoses(std::size_t count);

/** \brief Adds Gaussian blur, px, and noise, grey levels. */
void
spoil(CameraImage& image, double blur, double noise, unsigned seed);

/** \brief Shots of the board at these poses with realistic blur of 0.7 px and noise of
 * 2 grey levels. */
std::vector<TrinocularFrame>
boardShots(const RigCalibration& rig, std::size_t count);

/** \brief Such as "reference_03.png". */
std::array<std::string, 3>
shotNames(std::size_t shot);

} // namespace pcl::acmap::test

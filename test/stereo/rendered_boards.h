#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator_types.h>

#include <vector>

namespace pcl::acmap::test {

/** \brief A rig as a workshop builds it: strong distortion, cameras turned by one or two
 * degrees, baselines that are perpendicular, but not along the axes of the reference. */
RigCalibration
builtRig();

/** \brief Grey, 0 to 255, of a point of a plane, metres in the frame of the plane. */
using Brightness = double (*)(const Eigen::Vector3d& point);

/** \brief Draws what a camera of a rig sees of planes, sixteen rays a pixel. */
class RigRenderer {
public:
  explicit RigRenderer(const RigCalibration& rig);

  /** \brief The images of a plane z = 0 of a frame; grey, without noise.
   * \param[in] T_reference_plane where the plane stands */
  TrinocularFrame
  frameOf(const Eigen::Isometry3d& T_reference_plane, Brightness brightness) const;

private:
  CameraImage
  imageOf(RigCamera camera,
          const Eigen::Isometry3d& T_camera_plane,
          Brightness brightness) const;

  RigCalibration rig_;
  // Where the corners of the pixels look, on the plane z = 1, by camera.
  std::array<std::vector<Eigen::Vector2d>, 3> rays_;
};

/** \brief A board of 9 x 6 corners and 30 mm squares with a white margin on a grey wall.
 * \param[in] point from the first corner; x along a row, y down */
double
boardBrightness(const Eigen::Vector3d& point);

/** \brief Places of boards before a rig, as a hand holds them: all over the image, near
 * and far, tilted and turned. */
std::vector<Eigen::Isometry3d>
boardPoses(std::size_t count);

/** \brief Gaussian blur, px, and noise, grey levels, with a seed. */
void
spoil(CameraImage& image, double blur, double noise, unsigned seed);

/** \brief Shots of the board in all these places, as a real camera gives them: blur 0.7
 * px, noise 2 grey levels. */
std::vector<TrinocularFrame>
boardShots(const RigCalibration& rig, std::size_t count);

/** \brief "reference_03.png" and so on. */
std::array<std::string, 3>
shotNames(std::size_t shot);

} // namespace pcl::acmap::test

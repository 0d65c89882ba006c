#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

namespace pcl {

/** \brief The projector of the patterns. Pixel coordinates are those of a camera: the
 * centre of the first pixel is at (0, 0), and (u, v) is projected along ((u - center_x)
 * / focal_length, (v - center_y) / focal_length, 1). \ingroup simulation */
struct SimulatedProjector {
  int width = 1024; ///< px, at least 2
  int height = 768; ///< px, at least 2

  /** \brief px; with the default, 80 % of the standard rig's view is lit. */
  double focal_length = 931.0;
  double center_x = 511.5; ///< px, principal point
  double center_y = 383.5; ///< px

  /** \brief Pose in the frame of the reference camera, metres; by default to the right
   * of and below the camera. */
  Eigen::Isometry3d T_reference_projector =
      Eigen::Isometry3d(Eigen::Translation3d(0.05, 0.08, 0.0));

  /** \brief Radius of the lit area around the principal point, px; there is no light
   * outside. */
  double aperture_radius = 640.0;

  /** \brief Light of a white pattern on a surface that faces the projector at
   * \ref falloff_distance, in the unit of \ref SimulatedLight::ambient. It is
   * proportional to the cosine of the angle of incidence and inversely proportional to
   * the squared distance. */
  double power = 1.0;
  double falloff_distance = 2.0; ///< metres

  /** \brief Standard deviation of the lens's blur, in projector px. Below 0.8 there is
   * aliasing if a camera pixel covers two projector pixels. */
  double blur = 1.0;
};

/** \brief Light and camera model. Before noise, a grey level is exposure * surface
 * colour * (ambient + projector's light). \ingroup simulation */
struct SimulatedLight {
  SimulatedProjector projector;
  double ambient = 0.45; ///< fraction of the surface colour, without projector
  double exposure = 1.0; ///< gain of the cameras

  double read_noise = 1.0;  ///< grey levels, standard deviation in the dark
  double shot_noise = 0.02; ///< grey levels, increase of the variance per grey level

  double blur = 0.5; ///< standard deviation of the cameras' blur, px; 0 for none

  /** \brief True if the brightness decreases towards the image border, with the fourth
   * power of the cosine. */
  bool vignetting = false;
};

/** \brief Checks the parameters of the light.
 * \throws BadArgumentException naming value, valid range and unit
 * \ingroup simulation */
ACMAP_EXPORT void
requireSoundLight(const SimulatedLight& light);

} // namespace pcl

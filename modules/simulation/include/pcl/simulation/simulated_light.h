#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

namespace pcl {

/** \brief The lamp that throws the patterns. Pixels are counted as a camera's: the first
 * has its centre at (0, 0), and (u, v) is thrown along ((u - center_x) / focal_length,
 * (v - center_y) / focal_length, 1). \ingroup simulation */
struct SimulatedProjector {
  int width = 1024; ///< px, at least 2
  int height = 768; ///< px, at least 2

  /** \brief px; at the default the standard rig's view is lit to 80 % of its area. */
  double focal_length = 931.0;
  double center_x = 511.5; ///< px, of the principal point
  double center_y = 383.5; ///< px

  /** \brief Place in the frame of the reference camera, metres: by default beside and
   * below it. */
  Eigen::Isometry3d T_reference_projector =
      Eigen::Isometry3d(Eigen::Translation3d(0.05, 0.08, 0.0));

  /** \brief px round the principal point; what lies outside is dark. */
  double aperture_radius = 640.0;

  /** \brief Full light at \ref falloff_distance on a surface that faces the projector,
   * with the light of the room as unit of \ref SimulatedLight::ambient; it falls with the
   * square of the distance and the cosine of the angle. */
  double power = 1.0;
  double falloff_distance = 2.0; ///< metres

  /** \brief One standard deviation of the lens's blur, projector px. Below 0.8 a camera
   * that sees two of them in a pixel takes chance samples of a line. */
  double blur = 1.0;
};

/** \brief What light and cameras make of a scene. A grey level, before noise, is exposure
 * * surface colour * (ambient + projector's light). \ingroup simulation */
struct SimulatedLight {
  SimulatedProjector projector;
  double ambient = 0.45; ///< of the colour of a surface, without the projector
  double exposure = 1.0; ///< gain of the cameras

  double read_noise = 1.0;  ///< grey levels, one standard deviation in the dark
  double shot_noise = 0.02; ///< grey levels: variance that a grey level adds

  double blur = 0.5; ///< one standard deviation of the cameras' blur, px; 0 for none

  /** \brief Whether light falls off towards the rim of the image, with the fourth power
   * of the cosine. */
  bool vignetting = false;
};

/** \brief Refuses a light that cannot be.
 * \throws BadArgumentException naming value, legal range and unit \ingroup simulation */
ACMAP_EXPORT void
requireSoundLight(const SimulatedLight& light);

} // namespace pcl

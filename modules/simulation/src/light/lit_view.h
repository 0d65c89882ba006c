#pragma once

#include "camera_rays.h"
#include "pinhole_scene.h"

#include <pcl/simulation/simulated_light.h>

#include <vector>

namespace pcl::acmap {

/** \brief View of a camera, prepared for shading under any pattern: a grey level is
 * color * (ambient + light * pattern (u, v)). Rows from the top, each from the left. */
struct LitView {
  int width = 0;            ///< px; 0: there is no such camera
  int height = 0;           ///< px
  std::vector<float> color; ///< red, green, blue, times exposure; 0 for nothing
  std::vector<float> light; ///< of the projector for a white pattern, 0 in shadow
  std::vector<float> u;     ///< position in the projector's image, px
  std::vector<float> v;
};

/** \brief The projector at one pose. */
class PlacedProjector {
public:
  PlacedProjector(const SceneGeometry& scene,
                  const SimulatedProjector& projector,
                  const Eigen::Isometry3d& T_scene_projector);

  /** \brief Light of the projector at a point of a surface. */
  struct Light {
    float strength = 0; ///< for a white pattern
    float u = 0;        ///< px
    float v = 0;
  };

  /** \param[in] point scene frame
   * \param[in] normal unit length, towards the camera */
  Light
  lightAt(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;

private:
  SimulatedProjector projector_;
  Eigen::Isometry3d T_projector_scene_;
  PinholeScene seen_;
};

/** \brief Casts the view of one camera. Runs in all threads of the caller's arena. */
LitView
castLitView(const SceneGeometry& scene,
            const CameraRays& rays,
            const Eigen::Isometry3d& T_scene_camera,
            const PlacedProjector& projector,
            const SimulatedLight& light);

} // namespace pcl::acmap

#pragma once

#include "camera_rays.h"
#include "pinhole_scene.h"

#include <pcl/simulation/simulated_light.h>

#include <vector>

namespace pcl::acmap {

/** \brief What a camera sees, ready to be shaded under any pattern: a grey level is
 * color * (ambient + light * pattern (u, v)). Rows from the top, each from the left. */
struct LitView {
  int width = 0;  ///< px; 0: there is no such camera
  int height = 0; ///< px
  std::vector<float>
      color; ///< red, green, blue of a pixel, with exposure; 0 for nothing
  std::vector<float> light; ///< of the projector under full white, 0 in its shadow
  std::vector<float> u;     ///< px of the projector, within its image
  std::vector<float> v;
};

/** \brief The projector at one place. */
class PlacedProjector {
public:
  PlacedProjector(const SceneGeometry& scene,
                  const SimulatedProjector& projector,
                  const Eigen::Isometry3d& T_scene_projector);

  /** \brief What falls on a place of a surface. */
  struct Light {
    float strength = 0; ///< under full white
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

/** \brief Casts one camera. Runs in all threads of the caller's arena. */
LitView
castLitView(const SceneGeometry& scene,
            const CameraRays& rays,
            const Eigen::Isometry3d& T_scene_camera,
            const PlacedProjector& projector,
            const SimulatedLight& light);

} // namespace pcl::acmap

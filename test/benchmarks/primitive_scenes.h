#pragma once

#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/simulation/simulated_scene.h>

#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A box of a scene, in the scene's frame. */
struct SceneBox {
  std::string name;
  Eigen::AlignedBox3d place;

  /** Is the face a surface of the scene? The order is that of BoxPatch::faces. */
  std::array<bool, 6> has_face{};
};

/** \brief The boxes of a scene with a top; blocks and partitions, which reach the ceiling,
 * are part of the building. */
std::vector<SceneBox>
boxesOf(const SimulatedScene& scene);

/** \brief A scene without the surfaces of some names. */
SimulatedScene
withoutSurfaces(SimulatedScene scene,
                const std::function<bool(const std::string& name)>& is_left_out,
                bool keeps_cylinders);

/** \brief The building alone: walls, blocks and doors. */
SimulatedScene
withoutBoxes(const SimulatedScene& scene);

/** \brief Is a place in the image of a view, and in reach? It may be occluded.
 * \param[in] place in the frame of the scene, metres */
bool
isInSight(const SimulatedScene& scene, const Eigen::Vector3d& place);

inline double
distanceToAxis(const Eigen::Vector3d& place,
               const Eigen::Vector3d& point,
               const Eigen::Vector3d& axis)
{
  const Eigen::Vector3d way = place - point;
  return (way - way.dot(axis) * axis).norm();
}

/** \brief The patch nearly on the axis of a cylinder, with nearly its radius; nullptr for
 * none. */
const CylinderPatch*
patchOf(const Eigen::Vector3d& point,
        const Eigen::Vector3d& axis,
        double radius,
        const std::vector<CylinderPatch>& patches);

/** \brief The planes of all views of a scene, in the frame of the first one, by
 * PlaneMapping with the sensors of the points. */
MappedPlanes
mapScene(const SimulatedScene& scene, bool searches_cylinders);

} // namespace pcl::acmap::bench

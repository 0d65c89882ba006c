#pragma once

#include "map_drawing.h"
#include "scene.h"
#include "scene_renderer.h"

#include <pcl/visualization/layered_scene.h>

#include <string>

namespace pcl::acmap {

/** \brief A scene, its view, and the objects needed to draw it. */
struct LayerMaking {
  const LayeredScene& scene;
  const LayeredView& view;
  const MapDrawing* drawing; ///< null if there are no planes
  const Camera& camera;
};

/** \brief The cloud that is shown in the layer of the points. */
const PCLPointCloud2&
cloudOf(const LayeredScene& scene);

/** \brief Camera for a scene without planes. */
Camera
cameraOf(const LayeredScene& scene, const LayeredView& view);

/** \brief Some of the points and vertices of the layers that are shown at first. */
std::vector<Eigen::Vector3f>
pointsToSee(const LayeredScene& scene, const LayeredView& view);

Actors
actorsOfLayer(const LayerMaking& making, SceneLayer layer);

/** \brief The outlines of the planes or of the proposed surfaces; nothing for others. */
std::vector<SurfaceOutline>
outlinesOfLayer(const LayerMaking& making, SceneLayer layer);

/** \brief The layer of the points or of the trajectory with other poses, as they were
 * before rectification or on the way from there.
 * \param[in] step every how many points one is shown */
Actors
actorsBefore(const LayerMaking& making,
             SceneLayer layer,
             const Trajectory& poses,
             std::size_t step = 1);

/** \brief Poses on the way from before rectification (share 0) to after it (1). */
Trajectory
posesBetween(const LayeredScene& scene, double share);

/** \brief The layer of the mesh at a step of the walls. */
Actors
actorsOfStep(const LayerMaking& making, std::size_t step);

/** \brief Do the points have an int32 field `view`, the number of their observation? */
bool
hasViews(const PCLPointCloud2& cloud);

/** \brief The points under other poses, as those before rectification: those of view i
 * are moved by T_i * T_after_i^-1; points without a valid view become NaN.
 * \param[in] scene has points with view and x y z
 * \param[in] poses one for each pose of the map
 * \param[in] step every how many points one is returned
 * \throws BadArgumentException when the fields are missing or not inside the cloud */
PCLPointCloud2
pointsUnder(const LayeredScene& scene, const Trajectory& poses, std::size_t step = 1);

/** \brief The triangles that were constructed by the walls up to a step: those of this
 * step in the full colour of their depth, those of earlier steps in a pale one; at the
 * last step all others in grey. The points of the mesh are shown faintly.
 * \param[in] scene with wall depths
 * \param[in] steps of the whole mesh */
Actors
actorsOfWalls(const Scene& scene, std::size_t step, std::size_t steps, bool hide_backs);

/** \brief Describes a step in one line. */
std::string
describeWalls(const TriangleMesh& mesh, std::size_t step);

} // namespace pcl::acmap

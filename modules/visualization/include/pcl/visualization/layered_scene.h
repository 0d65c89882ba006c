#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/visualization/map_snapshot.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>

namespace pcl {

/** \brief A way to look at a building; one may lie upon the other. The key of a layer in a
 * window is its number. \ingroup visualization */
enum class SceneLayer {
  Points = 1,    ///< of the cloud, else the mesh's vertices
  Mesh = 2,      ///< facets under light
  Normals = 3,   ///< short lines at vertices of the mesh, 3000 at most
  Planes = 4,    ///< translucent, each with its outline in a colour of its own
  Texture = 5,   ///< planes with the colours of their charts
  Trajectory = 6 ///< a line, and the camera's axes at 50 poses at most
};

/** \brief All that there is of a building; any part may be empty. \ingroup visualization */
struct LayeredScene {
  PCLPointCloud2 points;
  PCLPointCloud2 vertices;
  TriangleMesh mesh; ///< of the vertices
  CompactMap map;

  /** \brief The poses of the map's trajectory as they were before rectification. Points
   * with an int32 field `view`, the number of the pose that saw them, go with these. */
  Trajectory trajectory_before;
};

/** \brief How a layered scene is shown; \ref MapView's paint does not count. A scene
 * without planes has no view from inside, and one without trajectory too no plan.
 * \ingroup visualization */
struct LayeredView : MapView {
  std::set<SceneLayer> layers; ///< shown at first; none: the usual ones

  /** \brief As it was before rectification: points and trajectory alone. */
  bool before = false;

  /** \brief The mesh as far as the walls of this step and those before it have made it
   * (Fig. 5), 0 to \ref wallSteps - 1. The eye stands as for the whole mesh, so that
   * pictures of all steps fit upon each other. */
  std::optional<std::size_t> wall_step;

  /** \brief The eye is that of this pose of the trajectory, wide; no other place of the
   * eye may be given then. */
  std::optional<std::size_t> at_pose;
};

/** \brief The layers a scene has something for. \ingroup visualization */
ACMAP_EXPORT std::set<SceneLayer>
layersOf(const LayeredScene& scene);

/** \brief The layers that show how it was before rectification: the trajectory where each
 * pose has one before, and points that name their poses. \ingroup visualization */
ACMAP_EXPORT std::set<SceneLayer>
layersBefore(const LayeredScene& scene);

/** \brief In how many steps the walls of a mesh are shown: one for each depth of walls, and
 * one more for the halves that were divided no further, whose triangles have the
 * greatest depth. 0 without wall depths, or where nothing was divided.
 * \ingroup visualization */
ACMAP_EXPORT std::size_t
wallSteps(const TriangleMesh& mesh);

/** \brief What is shown when nobody chooses: texture, else planes, else mesh, else points;
 * and the trajectory. \ingroup visualization */
ACMAP_EXPORT std::set<SceneLayer>
usualLayers(const LayeredScene& scene);

/** \brief Draws layers into a PNG file.
 *
 * The points of a plan are those up to a little above the cameras, or one would see
 * nothing but ceilings.
 * \throws OutputFileException when it could not be written
 * \throws InitFailedException without an X server, or when there is nothing to draw
 * \throws BadArgumentException when the scene has nothing for a layer, a place of the eye
 * needs what there is not, there is nothing before rectification, no such
 * step or pose, or as \ref saveSnapshot and \ref saveMapSnapshot
 * \ingroup visualization */
ACMAP_EXPORT void
saveSnapshot(const std::string& path,
             const LayeredScene& scene,
             const LayeredView& view = {});

/** \brief Shows layers in a window that follows the mouse, until it is closed.
 *
 * Keys: 1 to 6 layers on and off, b before and after rectification, t planes with and
 * without texture, n and N steps of the walls on and back, space a flight along the
 * trajectory, p (or a click with shift) the card of the plane under the mouse, h help, r
 * all in view, q end.
 * \param[in] tell gets help, cards and what a key could not do, a text each
 * \throws InitFailedException, BadArgumentException as \ref saveSnapshot
 * \ingroup visualization */
ACMAP_EXPORT void
showScene(const std::string& title,
          const LayeredScene& scene,
          const LayeredView& view = {},
          const std::function<void(const std::string&)>& tell = {});

} // namespace pcl

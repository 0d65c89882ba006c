#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/visualization/map_snapshot.h>

#include <functional>
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
};

/** \brief How a layered scene is shown; \ref MapView's paint does not count. A scene
 * without planes has no other place of the eye than outside, as \ref saveSnapshot has.
 * \ingroup visualization */
struct LayeredView : MapView {
  std::set<SceneLayer> layers; ///< shown at first; none: the usual ones
};

/** \brief The layers a scene has something for. */
ACMAP_EXPORT std::set<SceneLayer>
layersOf(const LayeredScene& scene);

/** \brief What is shown when nobody chooses: texture and trajectory, else planes and
 * trajectory, else mesh, else points. */
ACMAP_EXPORT std::set<SceneLayer>
usualLayers(const LayeredScene& scene);

/** \brief Draws layers into a PNG file.
 * \throws OutputFileException when it could not be written
 * \throws InitFailedException without an X server, or when there is nothing to draw
 * \throws BadArgumentException when the scene has nothing for a layer, a place of the eye
 * needs planes and there are none, or as \ref saveSnapshot and \ref saveMapSnapshot
 * \ingroup visualization */
ACMAP_EXPORT void
saveSnapshot(const std::string& path,
             const LayeredScene& scene,
             const LayeredView& view = {});

/** \brief Shows layers in a window that follows the mouse, until it is closed.
 *
 * Keys: 1 to 6 layers on and off, p (or a click with shift) the card of the plane under
 * the mouse, h help, r all in view, q end.
 * \param[in] tell gets help, cards and what a key could not do, a text each
 * \throws InitFailedException, BadArgumentException as \ref saveSnapshot
 * \ingroup visualization */
ACMAP_EXPORT void
showScene(const std::string& title,
          const LayeredScene& scene,
          const LayeredView& view = {},
          const std::function<void(const std::string&)>& tell = {});

} // namespace pcl

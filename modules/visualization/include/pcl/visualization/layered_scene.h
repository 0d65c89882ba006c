#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/visualization/map_snapshot.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace pcl {

/** \brief A representation of a building; layers can be shown together. The key of a
 * layer in a window is its number. \ingroup visualization */
enum class SceneLayer {
  Points = 1,     ///< of the cloud, or the vertices of the mesh if there is no cloud
  Mesh = 2,       ///< facets with lighting
  Normals = 3,    ///< short lines at the vertices of the mesh, at most 3000
  Planes = 4,     ///< translucent, each with an outline in its own colour
  Texture = 5,    ///< planes with the colours of their charts
  Trajectory = 6, ///< a line, and the axes of the camera at up to 50 poses
  Proposed = 7    ///< PlanePatch::proposed, as the planes
};

/** \brief Everything that is known of a building; any part may be empty.
 * \ingroup visualization */
struct LayeredScene {
  PCLPointCloud2 points;
  PCLPointCloud2 vertices;
  TriangleMesh mesh; ///< indexes the vertices
  CompactMap map;

  /** \brief The poses of the map's trajectory before rectification. Points with an
   * int32 field `view`, the number of the pose that observed them, move with these. */
  Trajectory trajectory_before;
};

/** \brief How a layered scene is shown; the `paint` of \ref MapView is ignored. A view
 * from inside needs planes, and a plan needs planes or a trajectory.
 * \ingroup visualization */
struct LayeredView : MapView {
  std::set<SceneLayer> layers; ///< shown at first; empty: see usualLayers

  /** \brief Shows the state before rectification: points and trajectory only. */
  bool before = false;

  /** \brief Shows only the triangles that were constructed by the walls up to this step
   * (Fig. 5), 0 to \ref wallSteps - 1. The camera is the one for the whole mesh, so
   * that the pictures of all steps can be compared. */
  std::optional<std::size_t> wall_step;

  /** \brief Places the camera at this pose of the trajectory, with a wide angle; no
   * other camera position may be set then. */
  std::optional<std::size_t> at_pose;
};

/** \brief The layers for which a scene has data. \ingroup visualization */
ACMAP_EXPORT std::set<SceneLayer>
layersOf(const LayeredScene& scene);

/** \brief The layers that can be shown as before rectification: the trajectory if there
 * is an earlier pose for each pose, and points with a `view` field.
 * \ingroup visualization */
ACMAP_EXPORT std::set<SceneLayer>
layersBefore(const LayeredScene& scene);

/** \brief Number of steps in which the walls of a mesh are shown: one for each depth of
 * the walls, and one for the halves that were not divided further, whose triangles
 * have the largest depth. 0 if there are no wall depths or nothing was divided.
 * \ingroup visualization */
ACMAP_EXPORT std::size_t
wallSteps(const TriangleMesh& mesh);

/** \brief The default layers: texture, else planes, else mesh, else points; and the
 * trajectory. \ingroup visualization */
ACMAP_EXPORT std::set<SceneLayer>
usualLayers(const LayeredScene& scene);

/** \brief Draws layers into a PNG file.
 *
 * A plan shows only the points up to 0.3 m above the cameras; otherwise the ceilings
 * would hide everything else.
 * \throws OutputFileException when the file could not be written
 * \throws InitFailedException without an X server, or when there is nothing to draw
 * \throws BadArgumentException when the scene has no data for a layer or for the
 * requested camera position, there is no state before rectification, the step or pose
 * does not exist, or as \ref saveSnapshot and \ref saveMapSnapshot
 * \ingroup visualization */
ACMAP_EXPORT void
saveSnapshot(const std::string& path,
             const LayeredScene& scene,
             const LayeredView& view = {});

/** \brief An interactive window for layers.
 *
 * It opens with a text that the scene is being read, so that the user sees it while the
 * program reads.
 *
 * Keys: 1 to 7 (or a click on its name) toggle the layers, b slides between before and
 * after rectification, t shows planes with or without texture, n and N go to the next
 * and previous step of the walls, space starts or stops a flight along the trajectory, p
 * (or a click with shift) shows the card of the plane under the mouse, m measures, h
 * shows the help, r resets the camera, q quits. The left button turns the scene about
 * the vertical.
 * \code
 * pcl::SceneWindow window ("kitchen");
 * window.show (readScene ());
 * \endcode
 * \ingroup visualization */
class ACMAP_EXPORT SceneWindow {
public:
  /** \param[in] name of what is shown; the title begins with it
   * \param[in] width, height pixels
   * \throws InitFailedException without an X server */
  explicit SceneWindow(const std::string& name, int width = 1280, int height = 960);

  ~SceneWindow();

  /** \brief Shows layers until the window is closed.
   * \param[in] tell receives help, cards and failures of keys, one text per call
   * \throws InitFailedException, BadArgumentException as \ref saveSnapshot */
  void
  show(const LayeredScene& scene,
       const LayeredView& view = {},
       const std::function<void(const std::string&)>& tell = {});

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/** \brief Shows layers in a \ref SceneWindow until it is closed. \ingroup visualization */
ACMAP_EXPORT void
showScene(const std::string& title,
          const LayeredScene& scene,
          const LayeredView& view = {},
          const std::function<void(const std::string&)>& tell = {});

} // namespace pcl

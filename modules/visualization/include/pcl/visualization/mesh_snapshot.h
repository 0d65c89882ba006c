#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace pcl {

/** \brief From where and how a scene is drawn. Lengths in metres, in the frame of the
 * cloud. \ingroup visualization */
struct SceneView {
  int width = 1280; ///< pixels
  int height = 960; ///< pixels

  /** \brief Place of the eye; unset: so far away that the scene fits. */
  std::optional<Eigen::Vector3f> from;

  /** \brief Point in the middle of the picture; unset: middle of the scene. */
  std::optional<Eigen::Vector3f> look;

  /** \brief Direction that is up in the picture; unset: up of the sensor (its -y) where
   * the scene is what one sensor saw, else -y or z, along which it stretches less. */
  std::optional<Eigen::Vector3f> up;

  /** \brief Pose of the sensor (x right, y down, z forward): a scene that lies in front
   * of it is seen from beside it. */
  Eigen::Vector3f sensor_origin = Eigen::Vector3f::Zero();
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();

  /** \brief Draws the edges with one triangle as thin lines. */
  bool show_boundary = false;

  /** \brief Draws the edges of all triangles of a mesh as thin lines; a picture of a mesh
   * alone has them, one of layers has not. */
  bool show_edges = false;

  /** \brief Leaves out the faces that look away: one sees into rooms through their walls.
   */
  bool hide_backs = false;

  /** \brief Draws without the cloud's colours, which can hide the relief. */
  bool ignore_colors = false;
};

/** \brief Draws a mesh, or the points of the cloud where the mesh has no triangle, into a
 * PNG file.
 *
 * Colours are the cloud's (`rgb`, `rgba`); without them a mesh is grey, and points are the
 * darker the farther they are. Back faces have a tint of their own.
 * The picture is fitted to the 2 % to 98 % quantiles of the points, so that strays do not
 * shrink the scene. Needs an X server (environment variable DISPLAY), which may be
 * virtual: `xvfb-run -a`. The file is written beside its target and renamed into place.
 * \param[in] path the file, ending in .png
 * \throws OutputFileException when it could not be written
 * \throws InitFailedException without an X server, or when no point is finite
 * \throws BadArgumentException when the mesh has an index outside the cloud, the cloud
 * lacks x y z, or the view has a size or a direction that cannot be
 * \code
 * pcl::SceneView view;
 * view.show_boundary = true;
 * pcl::saveSnapshot ("mesh.png", cloud, mesh, view);
 * \endcode
 * \ingroup visualization
 */
ACMAP_EXPORT void
saveSnapshot(const std::string& path,
             const PCLPointCloud2& cloud,
             const TriangleMesh& mesh,
             const SceneView& view = {});

/** \brief As above, of PCL's mesh; polygons are drawn as fans.
 * \ingroup visualization */
ACMAP_EXPORT void
saveSnapshot(const std::string& path,
             const PolygonMesh& mesh,
             const SceneView& view = {});

/** \brief Draws a mesh or cloud as \ref saveSnapshot does, into a window that follows the
 * mouse; returns when it is closed (key q).
 * \throws InitFailedException, BadArgumentException as \ref saveSnapshot
 * \ingroup visualization */
ACMAP_EXPORT void
showScene(const std::string& title,
          const PCLPointCloud2& cloud,
          const TriangleMesh& mesh,
          const SceneView& view = {});

/** \brief As above, of PCL's mesh. \ingroup visualization */
ACMAP_EXPORT void
showScene(const std::string& title,
          const PolygonMesh& mesh,
          const SceneView& view = {});

} // namespace pcl

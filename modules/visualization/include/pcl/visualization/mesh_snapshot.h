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

/** \brief How, and from where, a scene is drawn. Lengths in metres, in the frame of the
 * cloud. \ingroup visualization */
struct SceneView {
  int width = 1280; ///< pixels
  int height = 960; ///< pixels

  /** \brief Position of the camera; unset: at a distance at which the scene fits. */
  std::optional<Eigen::Vector3f> from;

  /** \brief Point at the centre of the picture; unset: centre of the scene. */
  std::optional<Eigen::Vector3f> look;

  /** \brief Up direction of the picture; unset: up of the sensor (its -y) if the scene
   * was observed by one sensor, else -y or z, whichever has the smaller extent. */
  std::optional<Eigen::Vector3f> up;

  /** \brief Pose of the sensor (x right, y down, z forward): a scene on one side of it is
   * seen from beside it. No position: the sensor is not known. */
  std::optional<Eigen::Vector3f> sensor_origin = Eigen::Vector3f::Zero();
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();

  /** \brief Draws boundary edges (edges with one triangle) as thin lines. */
  bool show_boundary = false;

  /** \brief Draws the edges of all triangles of a mesh as thin lines. */
  bool show_edges = false;

  /** \brief Leaves out back faces, so that one can see into rooms through their
   * walls. */
  bool hide_backs = false;

  /** \brief Ignores the colours of the cloud, which can hide the relief. */
  bool ignore_colors = false;
};

/** \brief Draws a mesh, or the points of the cloud if the mesh has no triangles, into a
 * PNG file.
 *
 * Colours are those of the cloud (`rgb`, `rgba`). Without colours a mesh is grey, and
 * points are blue; edges in the depth of points are dark. Back faces have a different tint. The
 * picture is fitted to the 2 % to 98 % quantiles of the points, so that outliers do
 * not shrink the scene. Needs an X server (environment variable DISPLAY), which may be
 * virtual: `xvfb-run -a`. The file is written beside its target and renamed into
 * place.
 * \param[in] path the file, ending in .png
 * \throws OutputFileException when the file could not be written
 * \throws InitFailedException without an X server, or when no point is finite
 * \throws BadArgumentException when the mesh has an index outside the cloud, the cloud
 * lacks x y z, or the view has an invalid size or direction
 * \code
 * pcl::SceneView view;
 * view.show_boundary = true;
 * pcl::saveSnapshot ("mesh.png", cloud, mesh, view);
 * \endcode
 * \ingroup visualization */
ACMAP_EXPORT void
saveSnapshot(const std::string& path,
             const PCLPointCloud2& cloud,
             const TriangleMesh& mesh,
             const SceneView& view = {});

/** \brief As above, for a PCL mesh; polygons are drawn as triangle fans.
 * \ingroup visualization */
ACMAP_EXPORT void
saveSnapshot(const std::string& path,
             const PolygonMesh& mesh,
             const SceneView& view = {});

/** \brief Shows a mesh or cloud as \ref saveSnapshot draws it in an interactive window;
 * returns when it is closed (key q).
 * \throws InitFailedException, BadArgumentException as \ref saveSnapshot
 * \ingroup visualization */
ACMAP_EXPORT void
showScene(const std::string& title,
          const PCLPointCloud2& cloud,
          const TriangleMesh& mesh,
          const SceneView& view = {});

/** \brief As above, for a PCL mesh. \ingroup visualization */
ACMAP_EXPORT void
showScene(const std::string& title,
          const PolygonMesh& mesh,
          const SceneView& view = {});

} // namespace pcl

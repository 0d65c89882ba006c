#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

class vtkProp;
class vtkRenderer;

namespace pcl {

/** \file
 * Layers for a renderer of your own. Each function adds one prop and returns it. The
 * renderer owns it; SetVisibility shows and hides it. The arguments need not outlive
 * the call.
 * \throws BadArgumentException, InitFailedException as pcl::saveSnapshot and
 * pcl::saveMapSnapshot; the renderer is then unchanged */

/** \brief Points in their colours, or blue if they have none. \ingroup visualization */
ACMAP_EXPORT vtkProp*
addPointLayer(vtkRenderer& renderer, const PCLPointCloud2& cloud);

/** \brief Facets in the colours of the vertices, or grey if these have none; back faces
 * are bluish.
 * \param[in] hide_backs leaves out facets that face away \ingroup visualization */
ACMAP_EXPORT vtkProp*
addMeshLayer(vtkRenderer& renderer,
             const PCLPointCloud2& vertices,
             const TriangleMesh& mesh,
             bool hide_backs = false);

/** \brief Short lines along the normals of the vertices, at most 3000.
 * \ingroup visualization */
ACMAP_EXPORT vtkProp*
addNormalLayer(vtkRenderer& renderer,
               const PCLPointCloud2& vertices,
               const TriangleMesh& mesh);

/** \brief Translucent planes with outlines, each in its own colour.
 * \ingroup visualization */
ACMAP_EXPORT vtkProp*
addPlaneLayer(vtkRenderer& renderer, const CompactMap& map, bool hide_backs = false);

/** \brief Planes with the colours of their charts, grey where there is no chart.
 * \ingroup visualization */
ACMAP_EXPORT vtkProp*
addTextureLayer(vtkRenderer& renderer, const CompactMap& map, bool hide_backs = false);

/** \brief A line through the poses, and the axes of the camera: x red, y green, z blue.
 * \param[in] axis_length metres \ingroup visualization */
ACMAP_EXPORT vtkProp*
addTrajectoryLayer(vtkRenderer& renderer,
                   const Trajectory& trajectory,
                   double axis_length = 0.2);

} // namespace pcl

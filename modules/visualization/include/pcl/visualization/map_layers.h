#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

class vtkProp;
class vtkRenderer;

namespace pcl {

/** \file
 * Layers for a renderer of your own. Each function adds one thing and returns it;
 * it belongs to the renderer, SetVisibility turns it off and on. Nothing of the arguments
 * is needed later.
 * \throws BadArgumentException, InitFailedException as pcl::saveSnapshot and
 * pcl::saveMapSnapshot; the renderer is then as it was */

/** \brief Points in their colours, else blue. \ingroup visualization */
ACMAP_EXPORT vtkProp*
addPointLayer(vtkRenderer& renderer, const PCLPointCloud2& cloud);

/** \brief Facets in the colours of the vertices, else grey; backs bluish.
 * \param[in] hide_backs leaves out facets that look away \ingroup visualization */
ACMAP_EXPORT vtkProp*
addMeshLayer(vtkRenderer& renderer,
             const PCLPointCloud2& vertices,
             const TriangleMesh& mesh,
             bool hide_backs = false);

/** \brief Short lines along the normals of the vertices, 3000 at most.
 * \ingroup visualization */
ACMAP_EXPORT vtkProp*
addNormalLayer(vtkRenderer& renderer,
               const PCLPointCloud2& vertices,
               const TriangleMesh& mesh);

/** \brief Planes, translucent, with outlines, each in a colour of its own.
 * \ingroup visualization */
ACMAP_EXPORT vtkProp*
addPlaneLayer(vtkRenderer& renderer, const CompactMap& map, bool hide_backs = false);

/** \brief Planes with the colours of their charts, grey where there are none.
 * \ingroup visualization */
ACMAP_EXPORT vtkProp*
addTextureLayer(vtkRenderer& renderer, const CompactMap& map, bool hide_backs = false);

/** \brief A line through the poses and the camera's axes: x red, y green, z blue.
 * \param[in] axis_length metres \ingroup visualization */
ACMAP_EXPORT vtkProp*
addTrajectoryLayer(vtkRenderer& renderer,
                   const Trajectory& trajectory,
                   double axis_length = 0.2);

} // namespace pcl

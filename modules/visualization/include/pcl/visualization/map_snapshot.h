#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <string>

namespace pcl {

/** \brief How, and from where, a compact map is drawn. \ingroup visualization */
struct MapView : SceneView {
  enum class Paint {
    Textured,    ///< with the colours of the charts, without lighting; else grey
    PlaneColors, ///< each plane has its own colour, with lighting
    Outlines     ///< outlines and holes as lines in the colours of the planes
  };

  enum class Place {
    Outside, ///< obliquely from above; faces that face away are left out
    Inside,  ///< wide angle, from the pose of the trajectory that sees most; without a
             ///< trajectory from the centre of the map
    Plan ///< orthographic from above: no downward facing planes, walls as lines, the
         ///< trajectory, a scale bar; the view's `from` is not used
  };

  Paint paint = Paint::Textured;
  Place place = Place::Outside;
};

/** \brief Draws a compact map into a PNG file.
 *
 * If the view does not set it, the up direction is \ref upDirection of the map.
 * Unknown texels are grey, back faces of planes bluish. A chart without colours is
 * treated as missing; planes without a normal or an area are left out. Needs an X
 * server as \ref saveSnapshot does.
 * \param[in] path the file, ending in .png
 * \throws OutputFileException when the file could not be written
 * \throws InitFailedException without an X server, or when no plane has an area
 * \throws BadArgumentException when a chart refers to a plane or polygon that does not
 * exist, or its colours do not have its size; or as \ref saveSnapshot for the view
 * \code
 * pcl::MapView view;
 * view.place = pcl::MapView::Place::Plan;
 * pcl::saveMapSnapshot ("plan.png", map, view);
 * \endcode
 * \ingroup visualization */
ACMAP_EXPORT void
saveMapSnapshot(const std::string& path,
                const CompactMap& map,
                const MapView& view = {});

} // namespace pcl

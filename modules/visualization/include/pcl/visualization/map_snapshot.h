#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <string>

namespace pcl {

/** \brief How a compact map is drawn, and from where. \ingroup visualization */
struct MapView : SceneView {
  enum class Paint {
    Textured,    ///< with the colours of the charts, without light; grey where none is
    PlaneColors, ///< each plane has a colour of its own, under light
    Outlines     ///< rims and holes as lines in the colours of the planes
  };

  enum class Place {
    Outside, ///< obliquely from above; faces that look away are left out
    Inside, ///< wide, from where the most is seen, at a pose of the trajectory or, without
            ///< one, in the middle of the map at half its height
    Plan ///< from above without perspective: no plane that looks down, walls as lines,
         ///< the trajectory, a bar that tells the scale; the view's `from` is not used
  };

  Paint paint = Paint::Textured;
  Place place = Place::Outside;
};

/** \brief Draws a compact map into a PNG file.
 *
 * Up, where the view does not tell, is \ref upDirection of the map. Texels of which nothing
 * is known are grey, backs of planes bluish. A chart without colours counts as none; planes
 * without a normal or an area are left out. Needs an X server as \ref saveSnapshot does.
 * \param[in] path the file, ending in .png
 * \throws OutputFileException when it could not be written
 * \throws InitFailedException without an X server, or when no plane has an area
 * \throws BadArgumentException when a chart is of a plane or polygon that is not there, or
 * its colours are not of its size; or as \ref saveSnapshot for the view
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

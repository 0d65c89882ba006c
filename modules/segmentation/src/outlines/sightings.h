#pragma once

#include "outlines/creases.h"

namespace pcl::acmap {

/** The cloud from which the points of a mesh were consolidated; may be empty. */
struct LabeledSource {
  PointView points;
  SensorView sensors;
  const PointLabels& labels; ///< plane of each point, -1 for none
};

namespace outlines {

/** Moves the rims of what was seen to where the rays of the source's points meet the
 * planes. Vertices of the mesh are means of points, so that faces end up to a spacing
 * before the surface does; and where rays graze a plane, the noise along them moves
 * points beyond its end. The ray itself is as exact as the camera, and so is its
 * intersection with the plane. Sets the points near rims.
 *
 * Planes whose rays are too few, or of a source without sensors, are left as they are.
 * \param[in] creases of the faces; along them, nothing is changed
 * \return was anything changed? */
bool
sharpenRims(const LabeledSource& source,
            const Creases& creases,
            std::vector<PlaneRaster>& rasters);

} // namespace outlines
} // namespace pcl::acmap

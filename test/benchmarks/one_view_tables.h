#pragma once

namespace pcl::acmap::bench {

/** \brief Real views without truth: planes, quantization levels, fraction of points,
 * time. */
void
printRealViews();

/** \brief Real views of a table with boxes, with manual labels. */
void
printTableViews();

/** \brief The first views of standard scenes, simulated as for a Kinect, with truth. */
void
printSimulatedViews();

/** \brief One view as a mesh. */
void
printViewMeshes();

} // namespace pcl::acmap::bench

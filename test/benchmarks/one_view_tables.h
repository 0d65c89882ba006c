#pragma once

namespace pcl::acmap::bench {

/** \brief Real views without truth: planes, layers, share of points, time. */
void
printRealViews();

/** \brief Real views of a table with boxes, whose points people have labelled. */
void
printTableViews();

/** \brief The first views of standard scenes as a Kinect measures them, with truth. */
void
printSimulatedViews();

/** \brief One view as a mesh. */
void
printViewMeshes();

} // namespace pcl::acmap::bench

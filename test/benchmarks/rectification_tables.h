#pragma once

namespace pcl::acmap::bench {

/** \brief Laser logs with robot drift of half, once and twice the typical level. */
void
printLogs();

/** \brief As above with four times the drift: no run may degrade a map. */
void
printStrongDrift();

/** \brief Other weights of the entropy, and other assumptions about the odometry
 * noise. */
void
printConstants();

/** \brief The runs of \ref printLogs with the search of the paper. */
void
printPaperMode();

/** \brief Simulated corridors, compared with PCL's LUM and ELCH. */
void
printCorridors();

/** \brief Maps that are already correct. */
void
printPerfect();

/** \brief Time and memory for a map of the paper's size. */
void
printSize();

} // namespace pcl::acmap::bench

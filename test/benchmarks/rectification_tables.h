#pragma once

namespace pcl::acmap::bench {

/** \brief Laser logs with the drift of robots, half, once and twice as much as usual. */
void
printLogs();

/** \brief The same with four times the drift: no run may make a map worse. */
void
printStrongDrift();

/** \brief Other weights of the entropy, other notions of the odometry's noise. */
void
printConstants();

/** \brief The runs of \ref printLogs by the paper's search. */
void
printPaperMode();

/** \brief Simulated corridors beside PCL's LUM and ELCH. */
void
printCorridors();

/** \brief Maps that are right already. */
void
printPerfect();

/** \brief Time and memory of a map of the paper's size. */
void
printSize();

} // namespace pcl::acmap::bench

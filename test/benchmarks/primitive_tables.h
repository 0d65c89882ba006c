#pragma once

namespace pcl::acmap::bench {

/** \brief Cylinders of the annotated CAD models of Fit4CAD: those with an even number,
 * on which nothing was tuned. */
void
printFit4cad();

/** \brief The same for the models with an odd number, on which limits were tuned. */
void
printFit4cadTuned();

/** \brief Columns and pipes of which one view sees half, among walls. */
void
printHalfSeen();

/** \brief Boxes of simulated buildings, with and without furniture; columns, pipes and
 * the curved wall of one of them. */
void
printBoxes();

/** \brief Desks with a slanted top, and pedestals with a tapered side. */
void
printSlants();

/** \brief Closed doors of simulated buildings, and the same buildings without them. */
void
printDoors();

/** \brief Walls that are flat, bowed, or curved with a radius of 10 m. */
void
printWalls();

/** \brief Errors of radii compared with their covariance. */
void
printSigma();

} // namespace pcl::acmap::bench

#pragma once

#include <pcl/filters/consolidation_kernel.h>

namespace pcl::acmap {

/** \brief Are the sensor positions consistent with the surfaces? If more than 5 % of
 * the surface is seen edge-on, the sensor was not there: this happens for the origin if
 * a file has no pose. Returns false if no sensor is known. */
bool
fitTheirSensors(const std::vector<Representative>& representatives,
                const SensorView& sensors);

/** \brief Makes the signs of neighbouring normals consistent, from flat regions to
 * creases (after Hoppe et al., "Surface reconstruction from unorganized points", 1992).
 * A connected component keeps the side of the majority of its normals.
 * \param[in] representatives their normals are changed
 * \param[in] edge of a voxel, metres */
void
makeNormalsAgree(std::vector<Representative>& representatives, double edge);

} // namespace pcl::acmap

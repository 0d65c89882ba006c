#pragma once

#include <pcl/filters/consolidation_kernel.h>

namespace pcl::acmap {

/** \brief Can the surfaces have been seen from where their sensors are said to stand? A
 * sensor that sees much of its surface edge-on was not there: it is the origin that a file
 * without a pose claims. False also where no sensor is known. */
bool
fitTheirSensors(const std::vector<Representative>& representatives,
                const SensorView& sensors);

/** \brief Gives neighbouring normals one side, from flat places to creases (after Hoppe
 * et al., "Surface reconstruction from unorganized points", 1992); a component as a whole
 * keeps the side that most of its normals had.
 * \param[in] edge of a voxel, metres */
void
makeNormalsAgree(std::vector<Representative>& representatives, double edge);

} // namespace pcl::acmap

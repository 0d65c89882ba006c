#pragma once

#include <pcl/core/sensor_view.h>
#include <pcl/filters/impl/consolidation_kernel.h>

namespace pcl::acmap {

/** \brief Can the surface have been seen from the sensor positions? For the origin, if a file
 * has no pose, this is often not so.
 *
 * It cannot if more than 5 % of the surface is seen edge-on, or if more than 25 % of it is
 * hidden from a single sensor by other surfaces, as the next room is by a wall.
 * \param[in] edge of a voxel, metres
 * \return false if no sensor is known */
bool
fitTheirSensors(const LargeVector<Representative>& representatives,
                const SensorView& sensors,
                double edge);

} // namespace pcl::acmap

#pragma once

#include <pcl/pipeline/depth_sensor.h>

namespace pcl::acmap {

class Tool;

/** \brief Adds `--sensor`. */
void
addSensor(Tool& tool, DepthSensor& sensor);

/** \brief Message for a cloud that is not organized, although the sensor requires
 * it. */
inline constexpr const char* needs_picture =
    "--sensor quantised and stereo are for one organized view in its sensor's frame, z "
    "forward, with at least 1000 points, or for what is left of one without its NaN "
    "pixels; leave --sensor out for this cloud";

} // namespace pcl::acmap

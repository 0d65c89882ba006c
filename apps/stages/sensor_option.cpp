#include "sensor_option.h"

#include "command_line.h"
#include "tool.h"

#include <CLI/CLI.hpp>

namespace pcl::acmap {

void
addSensor(Tool& tool, DepthSensor& sensor)
{
  addChoice<DepthSensor>(
      tool.options(),
      "--sensor",
      sensor,
      {{"auto", DepthSensor::Automatic},
       {"quantised", DepthSensor::Quantised},
       {"stereo", DepthSensor::Stereo},
       {"tof", DepthSensor::TimeOfFlight},
       {"laser", DepthSensor::Laser}},
      "What measured an organized cloud: quantised (structured light, as a Kinect) and "
      "stereo have noise that is even in inverse depth, and are worked on in their "
      "picture; tof and laser in space; auto: quantised where the depths have such "
      "steps");
}

} // namespace pcl::acmap

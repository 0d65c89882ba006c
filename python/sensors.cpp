#include "sensors.h"

#include <pcl/core/impl/arguments.h>

namespace pcl::acmap::python {

void
requireOrigin(const std::array<double, 3>& origin)
{
  for (const double coordinate : origin)
    requireInRange("sensor_origin", coordinate, -1e9, 1e9, "m");
}

SensorView
sensorViewOf(const SensorArguments& sensors, std::size_t points)
{
  if (sensors.viewpoints.has_value() != sensors.view.has_value())
    throw py::value_error("viewpoints and view belong together: give both or none");
  if (sensors.viewpoints) {
    const PointView places = pointRowsOf("viewpoints", *sensors.viewpoints).view;
    std::vector<Eigen::Vector3f> viewpoints;
    for (std::size_t i = 0; i < places.size(); ++i)
      viewpoints.push_back(places[i]);
    requireViewpoints(viewpoints);
    const Column view =
        columnOf("view", *sensors.view, py::dtype::of<std::int32_t>(), points);
    if (view.size > 0)
      return {view.first, view.stride, std::move(viewpoints)};
  }
  if (!sensors.origin)
    return {};
  requireOrigin(*sensors.origin);
  const std::array<double, 3>& p = *sensors.origin;
  return SensorView(Eigen::Vector3d(p[0], p[1], p[2]).cast<float>());
}

} // namespace pcl::acmap::python

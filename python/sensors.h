#pragma once

#include "array_view.h"

#include <pcl/core/sensor_view.h>

#include <array>
#include <optional>

namespace pcl::acmap::python {

/** \brief The arguments of functions that describe sensor positions. */
struct SensorArguments {
  std::optional<std::array<double, 3>> origin; ///< common sensor position of all points
  std::optional<PointArgument> viewpoints;     ///< sensor position of each observation
  std::optional<IndexArgument> view;           ///< observation of each point
};

/** \brief The sensor positions of the points: viewpoints if given, else the common
 * origin, else unknown. Does not copy \a view.
 * \throws py::value_error when only one of viewpoints and view is given, or a
 * viewpoint is not finite; as \ref pointRowsOf */
SensorView
sensorViewOf(const SensorArguments& sensors, std::size_t points);

/** \throws BadArgumentException when it is not finite */
void
requireOrigin(const std::array<double, 3>& origin);

} // namespace pcl::acmap::python

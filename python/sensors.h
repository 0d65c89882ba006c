#pragma once

#include "array_view.h"

#include <pcl/core/sensor_view.h>

#include <array>
#include <optional>

namespace pcl::acmap::python {

/** \brief Where the sensors stood, as the functions take it. */
struct SensorArguments {
  std::optional<std::array<double, 3>> origin; ///< of all points
  std::optional<PointArgument> viewpoints;     ///< of observations
  std::optional<IndexArgument> view;           ///< which of these saw a point
};

/** \brief Who saw the points: viewpoints where they are given, else the one origin, else
 * unknown. The views stay where they are.
 * \throws py::value_error when only one of viewpoints and view is given, or one is not
 * finite; as \ref pointRowsOf */
SensorView
sensorViewOf(const SensorArguments& sensors, std::size_t points);

/** \throws BadArgumentException when it is not finite */
void
requireOrigin(const std::array<double, 3>& origin);

} // namespace pcl::acmap::python

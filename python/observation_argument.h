#pragma once

#include "array_view.h"

#include <pcl/core/point_cloud_file.h>

#include <memory>

namespace pcl::acmap::python {

struct ShownView {
  static constexpr auto name =
      py::detail::const_name("numpy.ndarray[float32[h, w, 3]]");
};
struct ShownColors {
  static constexpr auto name = py::detail::const_name("numpy.ndarray[uint8[h, w, 3]]");
};

using ViewArgument = ShownAs<ShownView>;
using ColorArgument = ShownAs<ShownColors>;

/** \brief Copies the points and colours of an organized view; their arrays may have any
 * strides.
 * \return fields x y z rgb
 * \throws py::type_error, py::value_error naming the argument that does not fit */
std::shared_ptr<const PointCloudFile>
observationOf(const ViewArgument& points, const ColorArgument& colors);

} // namespace pcl::acmap::python

#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief What the caller states of a file before its points are read. */
struct CloudStatement {
  double scale = 1;                     ///< metres in a unit of the file
  std::optional<Eigen::Vector3d> shift; ///< to be subtracted, metres; none: found
  std::vector<std::string> columns;     ///< of a text; none: found

  /** \brief Leave a field of colours out in which all points are black, with a remark. */
  bool without_black = false;

  bool is_scale_stated = false; ///< the names of columns do not change it then
};

} // namespace pcl::acmap

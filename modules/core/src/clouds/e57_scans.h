#pragma once

#include "clouds/e57_points.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A scan: where its points are in the file, and its pose. */
struct E57Scan {
  std::vector<E57Field> fields;
  std::uint64_t section = 0; ///< logical offset
  std::uint64_t points = 0;
  Eigen::Isometry3d T_map_scan = Eigen::Isometry3d::Identity();
  std::array<double, 6> color_limits{}; ///< least and most of red, green, blue

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /** \brief Number of the field of a name, or \ref none. */
  std::size_t
  fieldOf(const char* name) const
  {
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].name == name)
        return i;
    return none;
  }
};

/** \brief Reads what a file says of its scans.
 * \throws InputFileException if it has none, or if they claim more points than the file can
 * have */
std::vector<E57Scan>
scansIn(E57Pages& pages);

} // namespace pcl::acmap

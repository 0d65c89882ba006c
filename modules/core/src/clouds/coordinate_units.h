#pragma once

#include <optional>
#include <string_view>

namespace pcl::acmap {

/** \brief Units of the coordinates of a reference system. */
struct CoordinateUnits {
  std::optional<double> across;   ///< metres in a unit of x and y; none: not told
  std::optional<double> up;       ///< metres in a unit of the heights; none: not told
  bool are_degrees = false;       ///< x and y are longitude and latitude
  std::optional<unsigned> system; ///< EPSG's number, where no unit is told
};

/** \brief Units of a reference system in well-known text, of version 1 or 2.
 * \param[in] text any; what is no such text tells no unit */
CoordinateUnits
unitsOfWkt(std::string_view text);

/** \brief Units of a reference system in the keys of a GeoTIFF.
 * \param[in] directory GeoKeyDirectoryTag, little-endian
 * \param[in] numbers GeoDoubleParamsTag, little-endian */
CoordinateUnits
unitsOfGeoKeys(std::string_view directory, std::string_view numbers);

} // namespace pcl::acmap

#pragma once

#include "clouds/coordinate_units.h"

#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief A part of a LAS file that has records of variable length. */
struct LasRecords {
  std::uint64_t begin = 0, end = 0; ///< bytes of the file
  bool are_extended = false;        ///< behind the points, as of LAS 1.4
};

/** \brief Units of the coordinates, by the record of the reference system: its well-known text,
 * else its keys of a GeoTIFF. Records that are damaged are passed over.
 * \param[in,out] source is moved */
CoordinateUnits
unitsOfRecords(const LasRecords& records, ByteSource& source);

} // namespace pcl::acmap

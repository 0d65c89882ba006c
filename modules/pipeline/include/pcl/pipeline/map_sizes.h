#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <string>

namespace pcl {

/** \brief How compact a map is: bytes. \ingroup pipeline */
struct MapSizes {
  std::size_t raw = 0;      ///< of the points: x y z rgb, 16 bytes per point
  std::size_t geometry = 0; ///< 16 bytes per plane and 12 per corner
  std::size_t details = 0;  ///< what they take in map.glb
  std::size_t glb = 0;      ///< file map.glb; 0 without one
  std::size_t json = 0;     ///< file map.json; 0 without one

  /** \brief Planes with their textures. */
  std::size_t
  textured() const
  {
    return glb > details ? glb - details : 0;
  }

  /** \brief How many times as large the points are. */
  double
  ratioTo(std::size_t bytes) const
  {
    return static_cast<double>(raw) / static_cast<double>(bytes > 0 ? bytes : 1);
  }
};

/** \brief Measures a map beside the points that it was made of.
 * \code
 * const pcl::MapSizes sizes = pcl::measureMap (map, cloud->size (), "map");
 * std::cout << sizes.ratioTo (sizes.textured ()) << " times as compact as the cloud\n";
 * \endcode
 * \param[in] points number of finite points of the input
 * \param[in] folder of the map, already written \ingroup pipeline */
ACMAP_EXPORT MapSizes
measureMap(const CompactMap& map, std::size_t points, const std::string& folder);

} // namespace pcl

#pragma once

#include "pinhole_views.h"

namespace pcl::acmap::test {

/** \brief A texel of the naive texture. */
struct NaiveTexel {
  int points = 0;
  Rgb mean{}; ///< of their colours
};

struct NaivePointTexture {
  std::vector<std::vector<NaiveTexel>> charts; ///< texels row by row
  std::size_t colored_points = 0;
  std::size_t far_points = 0;
};

/** \brief The last step of the paper (II-C.2), point by point: the colour of each point
 * goes to its closest plane within a distance, to the texel on which it is projected.
 * A plane ends at its polygon, that is, at the texels whose centre is inside of it.
 * \param[in] map planes and charts; their colours are not read */
NaivePointTexture
textureNaively(const CompactMap& map,
               const std::vector<View>& views,
               double maximum_distance);

} // namespace pcl::acmap::test

#pragma once

#include "literal_search.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A triangle of \ref buildLiterally. */
struct LiteralTriangle {
  std::array<std::int32_t, 3> corners;
  std::uint8_t depth; ///< of the call that built it; the first call has depth 0
};

/** \brief Result of Triange_Builder for one cluster. */
struct LiteralMesh {
  std::vector<LiteralTriangle> triangles; ///< no two have the same corners
  std::size_t walls = 0; ///< splitting planes whose call built a triangle
};

/** \brief Triange_Builder of [P] Fig. 6 for one cluster, line by line.
 *
 * Each call searches the whole point set, as printed, and has a part of the points for
 * its splitting plane: the median of the part along its widest axis, which divides it for
 * the two calls of line 22 and 23. A part of at most \a leaf_size points has no plane, so
 * that all sides are in its list L_alpha and the recursion ends.
 *
 * A triangle that is in the set already adds no sides; as printed, the loop would not
 * end, because *Insert* visits each inner side from both of its triangles.
 * \param[in] tick is called for each side */
LiteralMesh
buildLiterally(const LiteralPoints& points,
               std::int32_t leaf_size,
               const std::function<void()>& tick);

} // namespace pcl::acmap::ACMAP_DEWALL

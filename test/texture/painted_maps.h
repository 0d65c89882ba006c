#pragma once

#include "pinhole_views.h"

#include <pcl/texture/plane_texturing.h>

namespace pcl::acmap::test {

using Texturing = PlaneTexturing<PointXYZRGB>;

/** \brief A PlaneTexturing with planes and views, and texels of 2 cm. */
Texturing
texturingOf(const std::vector<PlanePatch>& planes, const std::vector<View>& views);

CompactMap
painted(Texturing texturing);

/** \brief The report of a run; discards the map. */
TexturingReport
reportOf(Texturing texturing);

Eigen::Vector3d
middleOfTexel(const TextureChart& chart, int column, int row);

TexelKind
kindOf(const TextureChart& chart, int column, int row);

std::size_t
countOf(const CompactMap& map, TexelKind kind);

/** \brief Calls a function with each texel of a kind and its position. */
void
forTexels(const CompactMap& map,
          TexelKind kind,
          const std::function<void(const TextureChart&,
                                   const std::uint8_t* color,
                                   const Eigen::Vector3d& place)>& call);

/** \brief Texels that are at least 3 cm inside their square on wall (plane 0) or floor (1). */
struct ComparedSquares {
  std::size_t texels = 0;
  std::size_t wrong = 0; ///< of their channels, those that are off by more
};

ComparedSquares
compareSquares(const CompactMap& map, double max_off);

/** \brief Checks the colours of the squares on wall (plane 0) and floor (1) for texels
 * that are at least 3 cm inside their square. \return number of compared texels */
std::size_t
expectSquares(const CompactMap& map, double max_off);

/** \brief Expects both maps to be byte-identical. */
void
expectSame(const CompactMap& a, const CompactMap& b);

} // namespace pcl::acmap::test

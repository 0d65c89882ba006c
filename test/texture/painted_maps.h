#pragma once

#include "pinhole_views.h"

#include <pcl/texture/plane_texturing.h>

namespace pcl::acmap::test {

using Texturing = PlaneTexturing<PointXYZRGB>;

/** \brief A texturing with planes and views, to be set and run. */
Texturing
texturingOf(const std::vector<PlanePatch>& planes, const std::vector<View>& views);

CompactMap
painted(Texturing texturing);

Eigen::Vector3d
middleOfTexel(const TextureChart& chart, int column, int row);

TexelKind
kindOf(const TextureChart& chart, int column, int row);

std::size_t
countOf(const CompactMap& map, TexelKind kind);

/** \brief Calls with each texel of a kind and its place. */
void
forTexels(const CompactMap& map,
          TexelKind kind,
          const std::function<void(const TextureChart&,
                                   const std::uint8_t* color,
                                   const Eigen::Vector3d& place)>& call);

/** \brief Expects the squares' colours on wall (plane 0) and floor (1) where a texel is 3 cm
 * inside of its square. \return how many were compared */
std::size_t
expectSquares(const CompactMap& map, double most_off);

/** \brief Expects the same bytes of both. */
void
expectSame(const CompactMap& a, const CompactMap& b);

} // namespace pcl::acmap::test

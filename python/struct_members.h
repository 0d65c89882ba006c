#pragma once

#include "compact_map.h"

#include <pcl/core/map_topology.h>

#include <tuple>

namespace pcl::acmap::python {

/** \brief How many members a struct has: all, or \ref membersOf does not compile. */
template <typename Struct>
inline constexpr int member_count = 0;

template <>
inline constexpr int member_count<BoxFace> = 2;
template <>
inline constexpr int member_count<BoxPatch> = 9;
template <>
inline constexpr int member_count<CylinderPatch> = 17;

template <>
inline constexpr int member_count<MapEdge> = 4;
template <>
inline constexpr int member_count<MapFace> = 4;
template <>
inline constexpr int member_count<MapOpening> = 8;
template <>
inline constexpr int member_count<MapRoom> = 6;
template <>
inline constexpr int member_count<MapTopology> = 3;
template <>
inline constexpr int member_count<PlanePatch> = 13;
template <>
inline constexpr int member_count<PlanePolygon> = 3;
template <>
inline constexpr int member_count<PolygonEdge> = 2;
template <>
inline constexpr int member_count<RecessPatch> = 10;
template <>
inline constexpr int member_count<ReportedMap> = 2;
template <>
inline constexpr int member_count<RgbImage> = 3;
template <>
inline constexpr int member_count<SurfaceLabel> = 3;
template <>
inline constexpr int member_count<Trajectory> = 2;

/** \brief References to the members of a struct, in their order. */
template <typename Struct>
auto
membersOf(Struct& value)
{
  constexpr int count = member_count<Struct>;
  if constexpr (count == 2) {
    auto& [a, b] = value;
    return std::tie(a, b);
  }
  else if constexpr (count == 3) {
    auto& [a, b, c] = value;
    return std::tie(a, b, c);
  }
  else if constexpr (count == 4) {
    auto& [a, b, c, d] = value;
    return std::tie(a, b, c, d);
  }
  else if constexpr (count == 6) {
    auto& [a, b, c, d, e, f] = value;
    return std::tie(a, b, c, d, e, f);
  }
  else if constexpr (count == 8) {
    auto& [a, b, c, d, e, f, g, h] = value;
    return std::tie(a, b, c, d, e, f, g, h);
  }
  else if constexpr (count == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = value;
    return std::tie(a, b, c, d, e, f, g, h, i);
  }
  else if constexpr (count == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = value;
    return std::tie(a, b, c, d, e, f, g, h, i, j);
  }
  else if constexpr (count == 13) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
  }
  else {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = value;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q);
  }
}

/** \brief Those that are read again from files. */
inline auto
membersOf(CompactMap& map)
{
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, details] = map;
  (void)details;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
}

/** \brief Those that Python has; the others are places in files, which saving sets. */
inline auto
membersOf(TexturePicture& picture)
{
  return std::tie(picture.colors, picture.kinds);
}

inline auto
membersOf(TextureChart& chart)
{
  return std::tuple_cat(
      membersOf(static_cast<TexturePicture&>(chart)),
      std::tie(chart.plane, chart.polygon, chart.origin, chart.texel_u, chart.texel_v));
}

} // namespace pcl::acmap::python

#pragma once

#include <pcl/core/compact_map.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief The newest format of map files that is known. */
constexpr int map_format = 1;

/** \brief Texels that a chart may have. */
constexpr std::int64_t maximum_texels = std::int64_t{1} << 28;

/** \brief What is wrong with the rectangle of a chart: its size or its frame; empty for
 * nothing. */
std::string
faultOfFrame(const TextureChart& chart);

/** \brief Checks what else a map file says beside its planes.
 * \throws BadArgumentException when charts, observations or poses make no sense */
void
requireConsistent(const CompactMap& map);

} // namespace pcl::acmap

#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/random.h>

namespace pcl::acmap::test {

/** \brief A map of two planes with arbitrary numbers: the first has two polygons, one
 * with a hole, and a chart on each; the second has no polygons. Two cylinders, the second
 * of unknown covariance. Three boxes and three recesses, the last of the template of the
 * first. Two poses. Two rooms, with a window between them and a door of none whose height
 * is unknown. */
CompactMap
makeSampleMap();

void
expectSameLabel(const SurfaceLabel& label, const SurfaceLabel& wanted);

/** \brief Expects bitwise equal numbers. */
void
expectSamePlanes(const CompactMap& map, const CompactMap& wanted);

/** \brief Expects bitwise equal numbers. */
void
expectSameCylinders(const CompactMap& map, const CompactMap& wanted);

/** \brief Expects bitwise equal numbers. */
void
expectSameBoxes(const CompactMap& map, const CompactMap& wanted);

/** \brief Expects bitwise equal numbers. */
void
expectSameRecesses(const CompactMap& map, const CompactMap& wanted);

/** \param[in] with_images also compare colours and kinds */
void
expectSameCharts(const CompactMap& map, const CompactMap& wanted, bool with_images);

} // namespace pcl::acmap::test
